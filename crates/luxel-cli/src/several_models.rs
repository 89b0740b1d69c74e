//! `luxel render` of several models: one after the other, each into a file of its own.
//!
//! A model that fails doesn't stop the rest.

use crate::cli::{Cli, Command};
use crate::commands::render::RenderCommand;
use crate::console::{Console, report};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::scene_file::Refusal;
use std::collections::HashMap;
use std::ffi::{OsStr, OsString};

/// Renders all models of a command. `read` reads the line again, with the settings of one of them.
///
/// # Errors
/// [`Failure::Usage`] before any work if two models would be written to the same file;
/// [`Failure::Work`] at the end, with a list, if some failed.
pub(crate) fn run(
    command: &RenderCommand,
    models: &[OsString],
    console: Console,
    read: impl Fn(&OsStr) -> Result<Cli, Refusal>,
) -> Result<(), Failure> {
    check_outputs(command, models)?;
    let progress = Progress::new(console, models.len(), "models");
    let mut failed = Vec::new();
    for model in models {
        let done = match read(model) {
            Ok(Cli { command: Command::Render(own), .. }) => own.with_model(model).run(console),
            Ok(_) => Ok(()),
            Err(Refusal::Line(error)) => Err(Failure::Usage(error.to_string())),
            Err(Refusal::File(failure)) => Err(failure),
        };
        if let Err(Failure::OutputClosed) = done {
            return done;
        }
        if let Err(failure) = done {
            progress.hidden(|| report(&failure));
            failed.push(model.to_string_lossy());
        }
        progress.step();
    }
    progress.finish();
    if failed.is_empty() {
        return Ok(());
    }
    let what = format!("{} of {} models failed: {}", failed.len(), models.len(), failed.join(", "));
    Err(Failure::work(what, ""))
}

/// Checks that each model has an output file of its own.
fn check_outputs(command: &RenderCommand, models: &[OsString]) -> Result<(), Failure> {
    command.check_output()?;
    let mut writers: HashMap<OsString, &OsString> = HashMap::new();
    for model in models {
        let output = command.output_of(model);
        if let Some(other) = writers.insert(output.clone(), model) {
            let [one, other, output] = [model, other, &output].map(|name| name.to_string_lossy());
            let what = if one == other {
                format!("{one} is given twice")
            } else {
                format!(
                    "{other} and {one} would both be written to {output}: use -o '{{stem}}.png'"
                )
            };
            return Err(Failure::Usage(what));
        }
    }
    Ok(())
}
