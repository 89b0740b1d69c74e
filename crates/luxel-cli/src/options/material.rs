//! Material: reflection constants that replace the file's.

use super::parameter::ParameterOptions;
use crate::values::{reflectance, reflection, reflection_choices};
use clap::Args;
use luxel::lighting::Reflection;

/// Reflection constants for all surfaces.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Material (for all surfaces, instead of the file's)")]
pub(crate) struct MaterialOptions {
    /// Diffuse and ambient colour, instead of textures and vertex colours: R,G,B (linear), a CSS name, or
    /// #rrggbb (sRGB)
    #[arg(long, value_name = "COLOR", value_parser = reflectance, allow_hyphen_values = true)]
    pub(crate) color: Option<[f32; 3]>,

    #[command(flatten)]
    pub(crate) shared: ParameterOptions<false>,

    /// Emitted light
    #[arg(long, value_name = "COLOR", value_parser = reflectance, allow_hyphen_values = true)]
    pub(crate) emission: Option<[f32; 3]>,

    #[arg(
        long,
        value_name = "MODEL",
        value_parser = reflection,
        help = format!("Reflection model: {}", reflection_choices())
    )]
    pub(crate) reflection: Option<Reflection>,

    #[command(flatten)]
    pub(crate) own: ParameterOptions<true>,
}
