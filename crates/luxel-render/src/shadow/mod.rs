//! What keeps light away from the surfaces that samples see.

mod batches;
mod floor;
mod occlusion;
mod openness;
mod place_cache;
mod receiver;
mod sequence;
mod shadow_ray;
mod shadows;

pub(crate) use batches::{Receivers, SeenSamples};
pub(crate) use floor::Floor;
pub(crate) use occlusion::{BATCHES, OcclusionLanes};
pub(crate) use sequence::DiscSequence;
pub(crate) use shadow_ray::LightSource;
pub(crate) use shadows::{OpennessRule, Receiver, Shadows};
