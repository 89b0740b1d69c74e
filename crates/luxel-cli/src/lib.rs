//! The program `luxel` renders 3D models from the command line. Internal: no other crate builds on it.
//!
//! Results go to the standard output, all else to the standard error. Status 0: success; 1: the
//! work failed; 2: wrong usage; 3: a check has findings.

#![forbid(unsafe_code)]
#![cfg_attr(not(feature = "batch"), expect(dead_code, reason = "batches alone use some of it"))]

mod camera;
mod cli;
mod commands;
mod console;
mod drawing;
mod failure;
mod flag_words;
mod model;
mod navigation;
mod options;
mod output;
mod program;
mod progress;
mod scene_file;
mod several_models;
mod surface;
#[cfg(feature = "batch")]
pub mod tasks;
mod values;
mod view;

use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches};
use cli::{Cli, Command, Line};
use console::{Console, report};
use failure::Failure;
use scene_file::Refusal;
use std::ffi::{OsStr, OsString};
use std::process::ExitCode;

/// The program, with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    ExitCode::from(main_as(Vec::new(), std::env::args_os().collect()))
}

/// The status of the program with these arguments, of which the first is its name. `program` is the line that starts it as a process
/// of its own; empty for the executable.
#[must_use]
pub fn main_as(program: Vec<OsString>, words: Vec<OsString>) -> u8 {
    program::set_line(program);
    output::outlive_file_limits();
    #[expect(clippy::exit, reason = "the program ends in its hook where nothing unwinds")]
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(ToString::to_string).unwrap_or_default();
        console::error(&[
            &format!("this is a bug in luxel ({place})"),
            "please report it with the command and the file that caused it",
        ]);
        // Packaged programs don't unwind: they end here, with the same status.
        if cfg!(panic = "abort") {
            #[cfg(feature = "terminal")]
            luxel_viewer::leave_terminal();
            std::process::exit(1);
        }
    }));
    // The panic hook has already printed the message.
    std::panic::catch_unwind(|| run(words)).unwrap_or(1)
}

/// The message for arguments that the program refuses; the first is its name. Runs no command.
#[must_use]
pub fn refusal(words: Vec<OsString>) -> Option<String> {
    let line = Line::new(words);
    if let Some(message) = line.misspelt_command() {
        return Some(message);
    }
    match read(&line, None) {
        Ok(_) => None,
        Err(Refusal::Line(error)) => {
            let meant = line.meant_command(&error).unwrap_or_default();
            Some(format!("{}{meant}", error.render()))
        }
        Err(Refusal::File(failure)) => Some(failure.lines().concat()),
    }
}

/// The command and its flags, completed by the scene file, if the model is one.
fn read(line: &Line, model: Option<&OsStr>) -> Result<Cli, Refusal> {
    let matches = scene_file::matches(Cli::command, &line.words, model)?;
    Ok(Cli::from_arg_matches(&matches)?)
}

fn run(words: Vec<OsString>) -> u8 {
    let line = Line::new(words);
    if let Some(command) = line.misspelt_command() {
        return report(&Failure::Usage(command));
    }
    let cli = match read(&line, None) {
        Ok(cli) => cli,
        Err(Refusal::Line(error)) => return print_usage(&error, line.meant_command(&error)),
        Err(Refusal::File(failure)) => return report(&failure),
    };
    let console = Console::new(cli.quiet, cli.verbose).into_current();
    let done = match cli.command {
        Command::Render(render) => match render.several() {
            Some(models) => {
                several_models::run(&render, &models, console, |model| read(&line, Some(model)))
            }
            None => render.run(console),
        },
        command => command.run(console),
    };
    match done {
        Ok(()) => 0,
        Err(failure) => report(&failure),
    }
}

/// Prints clap's message: help and version on the standard output, errors on the standard error, with the
/// line that was meant.
fn print_usage(error: &clap::Error, meant: Option<String>) -> u8 {
    let text = error.render().to_string();
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        return match output::print(&text) {
            Ok(()) => 0,
            Err(failure) => report(&failure),
        };
    }
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        eprint!("{text}");
    } else {
        eprint!("luxel: {text}");
    }
    if let Some(meant) = meant {
        eprintln!("\n  tip: did you mean `{meant}`?");
    }
    2
}
