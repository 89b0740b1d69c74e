//! What keeps light away from the surfaces that samples see.

mod floor;
mod openness;
mod receiver;
mod sequence;

pub(crate) use floor::Floor;
pub(crate) use openness::OpennessRule;
pub(crate) use receiver::{LightSource, OcclusionLanes, SeenSamples, Shadows};
pub(crate) use sequence::DiscSequence;
