//! Triangles divided into pieces between whose corners their light is interpolated.

mod pieces;
mod shared;
mod texel_light;

#[cfg(feature = "vectors")]
pub(crate) use pieces::encoded;
pub(crate) use pieces::{Asked, Pieces, mixed};
pub(crate) use shared::SubdividedTriangles;
pub(crate) use texel_light::TexelLight;
