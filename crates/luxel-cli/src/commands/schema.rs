//! `luxel schema`: what a scene file may say, for editors.

use crate::cli::Cli;
use crate::failure::Failure;
use crate::{output, scene_file};
use clap::CommandFactory;

/// Prints the JSON schema of scene files.
pub(crate) fn run() -> Result<(), Failure> {
    output::print(&text())
}

/// The schema as the file has it.
pub(crate) fn text() -> String {
    let mut program = Cli::command();
    program.build();
    let render = program.find_subcommand("render").unwrap_or(&program);
    let schema = scene_file::schema::schema(render);
    format!("{schema:#}\n")
}
