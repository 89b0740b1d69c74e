//! Parsers for the values of flags.
//!
//! Errors are one sentence that describes the expected value; clap adds the flag and exits with 2.

mod at;
mod choice;
mod count;
mod memory;
mod numbering;
mod occlusion;
mod region;
mod size;

pub(crate) use at::at;
pub(crate) use choice::choice;
pub(crate) use count::{samples, threads};
pub(crate) use luxel::formats::values::{
    LightSpec, Surroundings, background, color, far_plane, finite, fog, fov, intrinsics, light,
    light_usage, non_negative_f32, parameter, point, positive, reflectance, reflection,
    reflection_choices, surroundings, up, view_matrix,
};
pub(crate) use memory::memory;
pub(crate) use numbering::Numbering;
pub(crate) use occlusion::{OcclusionRadius, occlusion_radius, rays};
pub(crate) use region::{Rectangle, lasso, rectangle};
pub(crate) use size::size;
