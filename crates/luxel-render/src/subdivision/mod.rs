//! Triangles divided into pieces between whose corners their light is interpolated.

mod pieces;
mod shared;
mod texel_light;
mod tries;

pub(crate) use pieces::{Asked, Pieces, mixed};
pub(crate) use shared::SubdividedTriangles;
pub(crate) use texel_light::TexelLight;
#[cfg(feature = "vectors")]
pub(crate) use tries::encoded;
pub(crate) use tries::{Comparison, PlaceLight};
