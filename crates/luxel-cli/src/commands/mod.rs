//! The commands, one file each.

pub(crate) mod bench;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod demos;
pub(crate) mod explain;
pub(crate) mod gallery;
pub(crate) mod info;
mod manual;
pub(crate) mod navigate;
pub(crate) mod pick;
pub(crate) mod render;
pub(crate) mod schema;
pub(crate) mod view;

use crate::cli::Command;
use crate::console::Console;
use crate::failure::Failure;

/// Does what the command line asks for.
pub(crate) fn run(command: Command, console: Console) -> Result<(), Failure> {
    match command {
        Command::View(command) => command.run(console),
        Command::Render(command) => command.run(console),
        Command::Pick(command) => command.run(console),
        Command::Explain(command) => command.run(console),
        Command::Info(command) => command.run(console),
        Command::Bench(command) => command.run(console),
        Command::Navigate(command) => command.run(console),
        Command::Check(command) => command.run(console),
        Command::Gallery(command) => command.run(console),
        Command::Demos(command) => command.run(),
        Command::Completions(command) => command.run(),
        Command::Schema => schema::run(),
        Command::Man => manual::run(),
    }
}
