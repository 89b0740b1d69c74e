//! What keeps light away from the surfaces that samples see.

mod openness;
mod receiver;
mod sequence;

pub(crate) use openness::OpennessRule;
pub(crate) use receiver::{Asked, LightSource, OcclusionLanes, Shadows};
pub(crate) use sequence::DiscSequence;
