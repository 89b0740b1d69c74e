//! From light to bytes.

use crate::values::background;
use clap::{Args, ValueEnum};

/// From light to bytes.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
pub(crate) struct PictureOptions {
    /// Linear colour where nothing is, with alpha if you like [default: transparent black]
    #[arg(long, value_name = "R,G,B[,A]", value_parser = background, allow_hyphen_values = true)]
    pub(crate) background: Option<[f32; 4]>,

    /// How light becomes bytes: srgb (the curve of IEC 61966-2-1) or none
    #[arg(long, value_name = "CURVE", default_value = "srgb", hide_possible_values = true)]
    pub(crate) encoding: EncodingChoice,
}

/// How light becomes bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EncodingChoice {
    /// The curve of IEC 61966-2-1.
    Srgb,
    /// As it is.
    None,
}
