//! The command line: commands and the flags that all of them take.

use crate::commands::{bench, check, completions, demos, explain, info, navigate, render};
use clap::{Parser, Subcommand};

/// Light, draw and pick 3D models on the CPU, with the same bytes everywhere.
///
/// luxel reads a model file and lights it as the lectures teach it: local reflection, without cast
/// shadows and global light. It needs no GPU and no display.
#[derive(Parser, Debug)]
#[command(name = "luxel", version, args_override_self = true)]
#[command(subcommand_required = true, arg_required_else_help = true)]
#[command(infer_long_args = false, max_term_width = 100)]
pub(crate) struct Cli {
    /// Say nothing but errors
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub(crate) quiet: bool,

    /// Say what is done and how long it takes
    #[arg(short, long, global = true)]
    pub(crate) verbose: bool,

    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Subcommand, Debug)]
pub(crate) enum Command {
    Render(Box<render::RenderCommand>),
    Explain(Box<explain::ExplainCommand>),
    Info(Box<info::InfoCommand>),
    Check(Box<check::CheckCommand>),
    Bench(Box<bench::BenchCommand>),
    Navigate(Box<navigate::NavigateCommand>),
    Demos(demos::DemosCommand),
    Completions(completions::CompletionsCommand),
    /// Print the JSON schema of scene files
    ///
    /// For example: luxel schema > scene.schema.json
    Schema,
    /// Print the manual page
    ///
    /// For example: luxel man > ~/.local/share/man/man1/luxel.1
    Man,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_table_of_options_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn every_command_and_every_flag_is_told_about() {
        let program = Cli::command();
        for command in program.get_subcommands() {
            assert!(command.get_about().is_some(), "{}", command.get_name());
            for flag in command.get_arguments() {
                assert!(flag.get_help().is_some(), "{} {}", command.get_name(), flag.get_id());
            }
        }
    }
}
