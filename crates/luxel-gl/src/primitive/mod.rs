//! Primitives: assembled from vertices, and clipped.

mod assemble;
mod clip;
pub(crate) mod line;

pub(crate) use assemble::{Visitor, assemble, assemble_parts, parts};
pub(crate) use clip::{ClipCorner, Cut, clip_polygon, clip_segment, plane_distances};
