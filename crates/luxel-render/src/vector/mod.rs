//! Frames as primitives: feedback, and pictures made of vectors.

mod feedback;
mod primitives;
mod svg;

pub use svg::{MAX_PIECES, Svg, SvgOptions};
