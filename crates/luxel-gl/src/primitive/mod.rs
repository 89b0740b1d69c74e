//! Primitives: assembled from vertices, and clipped.

mod assemble;
mod clip;
pub(crate) mod line;
mod primitives;

pub(crate) use assemble::Visitor;
pub(crate) use clip::{ClipCorner, Cut, clip_polygon, clip_segment, plane_distances};
pub(crate) use primitives::Primitives;
