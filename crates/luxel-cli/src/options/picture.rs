//! Background, exposure, tone curve and encoding.

use crate::values::{Exposure, background, choice, exposure};
use clap::{Args, ValueEnum};
use luxel::lighting::Tone;
use luxel::scene::Background;

/// Background, exposure, tone curve and encoding.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
pub(crate) struct PictureOptions {
    /// Background: studio (a quiet gradient, as of light paper), R,G,B or R,G,B,A (linear), a CSS name
    /// such as white, #rrggbb, or #rrggbbaa [default: transparent]
    #[arg(long, value_name = "WHAT", value_parser = background, allow_hyphen_values = true)]
    pub(crate) background: Option<Background>,

    /// Exposure of surfaces in stops, each of which doubles their light, or auto: from the scene's own
    /// lights [default: 0; auto in the window]
    #[arg(long, value_name = "EV|auto", value_parser = exposure, allow_hyphen_values = true)]
    pub(crate) exposure: Option<Exposure>,

    #[arg(
        long,
        value_name = "CURVE",
        default_value = Tone::None.name(),
        hide_possible_values = true,
        value_parser = choice(&Tone::ALL, Tone::name, Tone::help),
        help = format!("Tone curve of surfaces, after the exposure: {}", tones()),
    )]
    pub(crate) tone: Tone,

    /// Encoding of the pixels: srgb (the curve of IEC 61966-2-1) or none
    #[arg(long, value_name = "CURVE", default_value = "srgb", hide_possible_values = true)]
    pub(crate) encoding: EncodingChoice,
}

/// The encoding of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EncodingChoice {
    /// The curve of IEC 61966-2-1.
    Srgb,
    /// Linear.
    None,
}

/// `none (light beyond white is clamped), ...`
fn tones() -> String {
    Tone::ALL.map(|tone| format!("{} ({})", tone.name(), tone.help())).join(", ")
}
