//! What keeps the lights away from the surfaces that samples see.

mod receiver;

pub(crate) use receiver::{LightSource, Shadows};
