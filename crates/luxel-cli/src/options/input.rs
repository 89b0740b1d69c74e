//! The input.

use crate::flag_words::unknown_format_text;
use clap::Args;
use luxel::formats::Format;
use std::ffi::OsString;

/// The model and its format.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Input")]
pub(crate) struct InputOptions {
    /// A model file (.glb .gltf .obj .stl .ply), a scene file (.toml), `-` for the standard input,
    /// or `demo:NAME` for a built-in scene
    #[arg(default_value = "demo:teapot")]
    pub(crate) model: OsString,

    /// The input format, regardless of the file name or, of the standard input, its first bytes:
    /// glb, gltf, obj, stl, ply, toml
    #[arg(long, value_name = "EXT", value_parser = format)]
    pub(crate) format: Option<Format>,
}

impl InputOptions {
    /// The model's name, for messages.
    pub(crate) fn name(&self) -> String {
        self.model.to_string_lossy().into_owned()
    }
}

fn format(text: &str) -> Result<Format, String> {
    text.parse().map_err(|error| unknown_format_text(&error))
}
