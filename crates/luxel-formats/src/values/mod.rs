//! Text forms of points, colours, lights and models of reflection, as scene files and command lines
//! have them.
//!
//! Errors are one sentence that says what is right; callers add where the text stands.

mod fields;
mod fog;
mod light;
mod nearest;
mod number;
mod reflection;
mod surroundings;
mod vector;

pub use fields::{FieldError, Fields};
pub use fog::{fog, fog_of};
#[cfg(feature = "gltf")]
pub(crate) use light::LEAST_CONE_EDGE;
pub use light::{LightSpec, cos_cutoff, cutoff_degrees, light, light_of, light_text, light_usage};
pub use nearest::nearest;
pub use number::{degrees, far_plane, finite, fov, non_negative_f32, positive, unit_interval};
pub use reflection::{parameter, reflection, reflection_choices, reflection_text};
pub use surroundings::{Surroundings, surroundings};
#[cfg(feature = "toml")]
pub(crate) use vector::numbers;
pub use vector::{background, color, direction, intrinsics, point, reflectance, up, view_matrix};
