//! Light: sources, environment, depth cueing.

use crate::values::{
    LightSpec, Surroundings, color, fog, light, light_usage, non_negative_f32, surroundings,
};
use clap::Args;
use luxel::lighting::Fog;

/// Sources, environment, depth cueing.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Light")]
pub(crate) struct LightOptions {
    #[arg(long = "light", value_name = "SPEC", value_parser = light, help = format!(
        "A light, instead of the file's; may be repeated: {}, with optional :ambient=R,G,B \
         :diffuse=R,G,B :specular=R,G,B :attenuation=C1,C2,C3 :limit=A (cuts the attenuation, at 1 \
         as in Foley et al.) :range=D :in=world|camera :name=NAME",
        light_usage()
    ))]
    pub(crate) lights: Vec<LightSpec>,

    /// The scene's ambient light
    #[arg(long, value_name = "R,G,B", value_parser = color, allow_hyphen_values = true)]
    pub(crate) ambient: Option<[f32; 3]>,

    /// All lights, the ambient one too, this many times as strong: for files whose lights are in lux
    #[arg(long, value_name = "S", value_parser = non_negative_f32, allow_hyphen_values = true)]
    pub(crate) light_scale: Option<f32>,

    /// What mirrors and metals see: none, studio, microfacet (the studio, for microfacet materials
    /// alone) or R,G,B [default: microfacet where the file has no lights, else none]
    #[arg(long, value_name = "WHAT", value_parser = surroundings, allow_hyphen_values = true)]
    pub(crate) environment: Option<Surroundings>,

    /// Depth cueing: near=Z:far=Z:front=S:back=S:color=R,G,B, or fog:
    /// law=exp|exp2:density=D:color=R,G,B
    #[arg(long, value_name = "SPEC", value_parser = fog)]
    pub(crate) fog: Option<Fog>,
}
