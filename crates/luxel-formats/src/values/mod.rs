//! The text forms of points, colours, lights and reflection models in scene files and on command
//! lines.
//!
//! Errors are one sentence that describes the expected value; callers add the place.

mod color;
mod exposure;
mod fields;
mod fog;
mod light;
mod light_text;
mod nearest;
mod number;
mod occlusion;
mod reflection;
mod samples;
mod size;
mod surroundings;
mod vector;

pub use color::{background, color, reflectance};
pub use exposure::{Exposure, exposure};
pub use fields::{FieldError, Fields};
pub use fog::{fog, fog_of};
pub use light::{LightSpec, light, light_of, light_usage};
#[cfg(feature = "toml")]
pub(crate) use light_text::{FieldValue, light_fields};
pub use light_text::{cos_cutoff, cutoff_degrees, light_text};
pub use nearest::nearest;
pub use number::{degrees, far_plane, finite, fov, non_negative_f32, positive, unit_interval};
pub use occlusion::{OcclusionRadius, occlusion_radius, rays};
pub use reflection::{parameter, reflection, reflection_choices, reflection_text};
pub use samples::samples;
pub use size::size;
pub use surroundings::{Surroundings, surroundings};
#[cfg(feature = "toml")]
pub(crate) use vector::numbers;
pub use vector::{direction, intrinsics, point, up, view_matrix};
