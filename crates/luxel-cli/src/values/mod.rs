//! What may stand after a flag: each kind of value with its parser.
//!
//! A parser answers wrong text with one sentence that says what would be right; clap adds the flag
//! and ends with status 2.

mod at;
mod fog;
mod light;
mod memory;
mod number;
mod numbering;
mod reflection;
mod size;
mod surroundings;
mod vector;

pub(crate) use at::at;
pub(crate) use fog::{FogSpec, fog};
pub(crate) use light::{LightSpec, light};
pub(crate) use memory::memory;
pub(crate) use number::{far_plane, finite, fov, non_negative_f32, positive, samples, threads};
pub(crate) use numbering::Numbering;
pub(crate) use reflection::{reflection, reflection_name};
pub(crate) use size::size;
pub(crate) use surroundings::{Surroundings, surroundings};
pub(crate) use vector::{background, color, intrinsics, point, reflectance, up, view_matrix};
