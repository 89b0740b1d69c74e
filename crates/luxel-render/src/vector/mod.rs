//! Frames as primitives: feedback, and pictures made of vectors.

mod feedback;
mod primitives;
#[cfg(feature = "vectors")]
mod svg;

#[cfg(feature = "vectors")]
pub use svg::{MAX_PIECES, Svg, SvgOptions};
