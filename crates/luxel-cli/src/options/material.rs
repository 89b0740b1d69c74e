//! Material: constants of reflection that replace the file's.

use crate::values::{non_negative_f32, reflectance, reflection};
use clap::Args;
use luxel::lighting::Reflection;

/// Constants of reflection for all surfaces.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Material (for all surfaces, instead of the file's)")]
pub(crate) struct MaterialOptions {
    /// Diffuse and ambient colour, instead of textures and vertex colours
    #[arg(long, value_name = "R,G,B", value_parser = reflectance, allow_hyphen_values = true)]
    pub(crate) color: Option<[f32; 3]>,

    /// k_a: how much ambient light is reflected
    #[arg(long, value_name = "K", value_parser = non_negative_f32, allow_hyphen_values = true)]
    pub(crate) ka: Option<f32>,

    /// k_d: how much light is reflected diffusely
    #[arg(long, value_name = "K", value_parser = non_negative_f32, allow_hyphen_values = true)]
    pub(crate) kd: Option<f32>,

    /// k_s: how much light is reflected in the highlight
    #[arg(long, value_name = "K", value_parser = non_negative_f32, allow_hyphen_values = true)]
    pub(crate) ks: Option<f32>,

    /// n: the exponent of the highlight
    #[arg(long, value_name = "N", value_parser = non_negative_f32, allow_hyphen_values = true)]
    pub(crate) shininess: Option<f32>,

    /// Light of the surface's own
    #[arg(long, value_name = "R,G,B", value_parser = reflectance, allow_hyphen_values = true)]
    pub(crate) emission: Option<[f32; 3]>,

    /// The model of reflection: unlit, lambert, oren-nayar, phong, blinn-phong, microfacet, mirror,
    /// retro or mixed:NAME=W,...
    #[arg(long, value_name = "MODEL", value_parser = reflection)]
    pub(crate) reflection: Option<Reflection>,
}
