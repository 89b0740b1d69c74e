//! Light: sources, environment, depth cueing.

use crate::values::{
    LightSpec, Surroundings, color, fog, light, light_usage, non_negative_f32, surroundings,
};
use clap::Args;
use luxel::lighting::Fog;
use luxel::scene::NamedEnvironment;

/// Sources, environment, depth cueing.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Light")]
pub(crate) struct LightOptions {
    #[arg(long = "light", value_name = "SPEC", value_parser = light, help = format!(
        "A light, instead of the file's; may be repeated: {}, with optional :ambient=COLOR \
         :diffuse=COLOR :specular=COLOR :attenuation=C1,C2,C3 :limit=A (cuts the attenuation, at 1 \
         as in Foley et al.) :range=D :in=world|camera :name=NAME",
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

    /// Surfaces keep directional, point and spot lights from what lies behind them
    #[arg(long)]
    pub(crate) shadows: bool,

    /// Depth cueing: near=Z:far=Z:front=S:back=S:color=COLOR, or fog:
    /// law=exp|exp2:density=D:color=COLOR
    #[arg(long, value_name = "SPEC", value_parser = fog)]
    pub(crate) fog: Option<Fog>,
}

fn environment_help() -> String {
    let choice = |one: NamedEnvironment| format!("{} ({})", one.name(), one.help());
    let choices = NamedEnvironment::ALL.map(choice).join(", ");
    let [none, _, microfacet] = NamedEnvironment::NAMES;
    format!(
        "Environment that mirrors and metals reflect: {choices} or a colour [default: {microfacet} if \
         the file has no lights, else {none}]"
    )
}
