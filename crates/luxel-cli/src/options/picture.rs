//! Background and encoding.

use crate::values::background;
use clap::{Args, ValueEnum};

/// Background and encoding.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
pub(crate) struct PictureOptions {
    /// Background: R,G,B or R,G,B,A (linear), a CSS name, #rrggbb, or #rrggbbaa [default: transparent]
    #[arg(long, value_name = "COLOR", value_parser = background, allow_hyphen_values = true)]
    pub(crate) background: Option<[f32; 4]>,

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
