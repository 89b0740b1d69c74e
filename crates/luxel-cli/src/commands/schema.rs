//! `luxel schema`: the JSON schema of scene files, for editors.

use crate::failure::Failure;
use crate::{output, scene_file};
use clap::Command;

/// Prints the JSON schema of scene files.
pub(crate) fn run(program: Command) -> Result<(), Failure> {
    output::print(&text(program))
}

/// The schema as text.
pub(crate) fn text(mut program: Command) -> String {
    program.build();
    let render = program.find_subcommand("render").unwrap_or(&program);
    let schema = scene_file::schema::schema(render);
    format!("{schema:#}\n")
}
