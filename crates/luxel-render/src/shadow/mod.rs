//! What keeps light away from the surfaces that samples see.

mod floor;
mod openness;
mod place_cache;
mod receiver;
mod sequence;
mod shadow_ray;

pub(crate) use floor::Floor;
pub(crate) use openness::OpennessRule;
pub(crate) use receiver::{OcclusionLanes, Receiver, SeenSamples, Shadows};
pub(crate) use sequence::DiscSequence;
pub(crate) use shadow_ray::LightSource;
