//! Parsers for the values of flags.
//!
//! Errors are one sentence that describes the expected value; clap adds the flag and exits with 2.

mod at;
mod choice;
mod memory;
mod numbering;
mod region;
mod threads;

pub(crate) use at::at;
pub(crate) use choice::choice;
pub(crate) use luxel::formats::values::{
    Exposure, LightSpec, OcclusionRadius, Surroundings, background, color, exposure, far_plane,
    finite, fog, fov, intrinsics, light, light_usage, non_negative_f32, occlusion_radius,
    parameter, point, positive, rays, reflectance, reflection, reflection_choices, samples, size,
    surroundings, up, view_matrix,
};
pub(crate) use memory::memory;
pub(crate) use numbering::Numbering;
pub(crate) use region::{Rectangle, lasso, rectangle};
pub(crate) use threads::threads;
