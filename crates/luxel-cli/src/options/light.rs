//! Light: sources, environment, depth cueing.

use crate::values::{
    LightSpec, OcclusionRadius, Surroundings, color, finite, fog, light, light_usage,
    non_negative_f32, occlusion_radius, rays, surroundings,
};
use clap::Args;
use luxel::lighting::Fog;
use luxel::scene::NamedEnvironment;
use luxel::view::{AmbientOcclusion, DEFAULT_LIGHT_RAYS};

/// Sources, environment, depth cueing.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Light")]
pub(crate) struct LightOptions {
    #[arg(long = "light", value_name = "SPEC", value_parser = light, help = format!(
        "A light, instead of the file's; may be repeated: {}, with optional :ambient=COLOR \
         :diffuse=COLOR :specular=COLOR :attenuation=C1,C2,C3 :limit=A (cuts the attenuation, at 1 \
         as in Foley et al.) :range=D :radius=R or, directional, :angle=DEG (soft shadows) :in=world|camera :name=NAME",
        light_usage()
    ))]
    pub(crate) lights: Vec<LightSpec>,

    /// Ambient light of the scene
    #[arg(long, value_name = "COLOR", value_parser = color, allow_hyphen_values = true)]
    pub(crate) ambient: Option<[f32; 3]>,

    /// Factor for all lights, including ambient: for files with lights in lux
    #[arg(long, value_name = "S", value_parser = non_negative_f32, allow_hyphen_values = true)]
    pub(crate) light_scale: Option<f32>,

    #[arg(long, value_name = "WHAT", value_parser = surroundings, allow_hyphen_values = true)]
    #[arg(help = environment_help())]
    pub(crate) environment: Option<Surroundings>,

    /// Turns a file's environment about the up axis, in degrees, counterclockwise as seen from above
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    pub(crate) environment_rotation: Option<f64>,

    /// Shows the environment behind the model instead of the background colour
    #[arg(long)]
    pub(crate) environment_background: bool,

    /// Surfaces keep directional, point and spot lights from what lies behind them
    #[arg(long)]
    pub(crate) shadows: bool,

    /// Rays from a sample to a light with a radius or an angle, 1 to 4096; more make soft shadows
    /// smoother
    #[arg(long, value_name = "N", default_value_t = DEFAULT_LIGHT_RAYS, value_parser = rays)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) light_rays: u32,

    /// Ambient occlusion: less ambient light where something is near, within RADIUS or `infinity`
    /// [default without a value: a quarter of the radius of the scene's bounding sphere]
    #[arg(long, value_name = "RADIUS", value_parser = occlusion_radius)]
    #[arg(num_args = 0..=1, require_equals = true, default_missing_value = "auto")]
    pub(crate) ao: Option<OcclusionRadius>,

    /// Rays from a sample for ambient occlusion, 1 to 4096; more make it smoother
    #[arg(long, value_name = "N", default_value_t = AmbientOcclusion::RAYS, value_parser = rays)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) ao_rays: u32,

    /// A ground under the model, square to --up, that shows nothing but the model's shadow and its
    /// occlusion over the background, with or without --shadows and --ao; not in .svg
    #[arg(long)]
    pub(crate) ground: bool,

    /// Depth cueing: near=Z:far=Z:front=S:back=S:color=COLOR, or fog:
    /// law=exp|exp2:density=D:color=COLOR
    #[arg(long, value_name = "SPEC", value_parser = fog)]
    pub(crate) fog: Option<Fog>,
}

impl LightOptions {
    /// Ambient occlusion, if `--ao` is given.
    pub(crate) fn ambient_occlusion(&self) -> Option<AmbientOcclusion> {
        self.ao.map(|OcclusionRadius(radius)| AmbientOcclusion { radius, rays: self.ao_rays })
    }
}

fn environment_help() -> String {
    let choice = |one: NamedEnvironment| format!("{} ({})", one.name(), one.help());
    let choices = NamedEnvironment::ALL.map(choice).join(", ");
    let [none, _, microfacet] = NamedEnvironment::NAMES;
    format!(
        "Environment that mirrors and metals reflect: {choices}, a colour, or an equirectangular picture, \
         FILE.hdr or FILE.exr, that also lights matt surfaces [default: {microfacet} if the file has no \
         lights, else {none}]"
    )
}
