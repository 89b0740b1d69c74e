//! Shapes from formulas: spheres, boxes, cones and their kin, with normals and texture coordinates.
//!
//! All have +Y as up, are centred on the origin unless documented otherwise, and have one part with
//! the first material. Normals are those of the smooth surface, not of its triangles. Positions are
//! shared across seams of the texture; attribute vertices are not. Where a row of a grid shrinks to
//! a point, as at the poles of a sphere, it has triangles instead of quadrilaterals, so that no
//! triangle is degenerate.
//!
//! Resolutions below the least that makes sense are raised to it, and those above
//! [`FINEST`] lowered, so that every number of a corner fits 32 bits.
//!
//! Texture coordinates run from the upper left of the surface, seen from its front.

mod bezier;
mod builder;
mod flat;
mod icosphere;
mod revolution;

pub(crate) use bezier::Patch;
pub(crate) use builder::{MeshBuilder, SurfacePoint};
pub use flat::{cuboid, plane};
pub(crate) use icosphere::geodesic;
pub use icosphere::icosphere;
pub use revolution::{cone, cylinder, sphere, torus};

/// The finest resolution of any shape, in steps along one direction.
pub const FINEST: u32 = 4096;

#[cfg(test)]
mod tests;
