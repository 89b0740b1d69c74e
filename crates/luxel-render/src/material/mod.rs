//! What a surface with given vertex attributes reflects and sends: textures, then the equation. Knows
//! no triangle.

mod attributes;
mod surface;
mod vertex;

pub(crate) use attributes::{Attributes, Corner, Footprint};
pub(crate) use surface::{SurfaceWitness, base_texel, lit, lit_elsewhere, shading_normal};
pub(crate) use vertex::{TriangleLight, light_at, light_under, lights_at, lights_with};
