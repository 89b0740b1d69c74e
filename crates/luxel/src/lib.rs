//! Light, draw and pick 3D models on the CPU, with the same bytes on every machine.
//!
//! This crate is the one to depend on: it gathers the others, each with one subject.
//!
//! | module | subject |
//! | --- | --- |
//! | [`formats`] | files in: glTF, OBJ, STL, PLY, with limits and errors that name their place |
//! | [`scene`] | what there is: meshes, nodes, cameras, lights, textures, the built-in demos |
//! | [`lighting`] | what a lit surface point sends to the eye |
//! | [`render`] | pictures and layers of a scene |
//! | [`math`] | numbers with the same bits everywhere |

#![forbid(unsafe_code)]

mod load;

pub use load::load;
pub use luxel_formats as formats;
pub use luxel_lighting as lighting;
pub use luxel_math as math;
pub use luxel_render as render;
pub use luxel_scene as scene;

/// What most programs want in scope.
pub mod prelude {
    pub use crate::load;
    pub use luxel_formats::{Format, Limits, Loaded};
    pub use luxel_lighting::{Light, LightKind, Material, Reflection};
    pub use luxel_math::SimdLevel;
    pub use luxel_scene::{Camera, DMat4, DVec3, Lens, Placement, Projection, Scene, Size};
}
