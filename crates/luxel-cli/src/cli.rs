//! The command line: commands and global flags.

use crate::commands::{
    batch, bench, check, demos, explain, gallery, info, navigate, pick, render, schema, view,
};
#[cfg(feature = "manual")]
use crate::commands::{completions, manual};
use crate::console::Console;
use crate::failure::Failure;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use luxel::formats::values::nearest;
use std::ffi::OsString;
use std::path::Path;

/// Renders 3D models on the CPU, with the same bytes on every machine.
///
/// luxel reads a model file and shades it with the classic local reflection models, on request with cast
/// shadows and ambient occlusion. It needs no GPU and no display.
#[derive(Parser, Debug)]
#[command(name = "luxel", version, args_override_self = true)]
#[command(override_usage = "luxel [MODEL] [OPTIONS]\n       luxel <COMMAND> [OPTIONS]")]
#[command(subcommand_required = true)]
#[command(infer_long_args = false, max_term_width = 100)]
pub(crate) struct Cli {
    /// Print errors only
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub(crate) quiet: bool,

    /// Print what luxel does, with timings
    #[arg(short, long, global = true)]
    pub(crate) verbose: bool,

    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The commands.
#[derive(Subcommand, Debug)]
pub(crate) enum Command {
    View(Box<view::ViewCommand>),
    Render(Box<render::RenderCommand>),
    Pick(Box<pick::PickCommand>),
    Explain(Box<explain::ExplainCommand>),
    Info(Box<info::InfoCommand>),
    Check(Box<check::CheckCommand>),
    Bench(Box<bench::BenchCommand>),
    Batch(Box<batch::BatchCommand>),
    Navigate(Box<navigate::NavigateCommand>),
    Demos(demos::DemosCommand),
    Gallery(gallery::GalleryCommand),
    #[cfg(feature = "manual")]
    Completions(completions::CompletionsCommand),
    /// Print the JSON schema of scene files
    ///
    /// For example: luxel schema > scene.schema.json
    Schema,
    /// Print the manual page
    ///
    /// For example: luxel man > ~/.local/share/man/man1/luxel.1
    #[cfg(feature = "manual")]
    Man,
}

impl Command {
    /// Runs the command.
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        match self {
            Self::View(command) => command.run(console, &words(), Cli::command()),
            Self::Render(command) => command.run(console),
            Self::Pick(command) => command.run(console),
            Self::Explain(command) => command.run(console),
            Self::Info(command) => command.run(console),
            Self::Bench(command) => command.run(console),
            Self::Batch(command) => command.run(console),
            Self::Navigate(command) => command.run(console),
            Self::Check(command) => command.run(console),
            Self::Gallery(command) => command.run(console),
            Self::Demos(command) => command.run(),
            #[cfg(feature = "manual")]
            Self::Completions(command) => command.run(Cli::command()),
            Self::Schema => schema::run(Cli::command()),
            #[cfg(feature = "manual")]
            Self::Man => manual::run(Cli::command()),
        }
    }
}

/// The arguments of the process.
pub(crate) struct Line {
    /// The arguments, with `view` inserted if they name no command.
    pub(crate) words: Vec<OsString>,
    /// The place of the command among them.
    place: usize,
    /// Whether `view` was inserted.
    is_completed: bool,
}

/// The arguments of the process, completed by a command.
pub(crate) fn line() -> Line {
    Line::new(std::env::args_os())
}

/// The words of the line of the process.
pub(crate) fn words() -> Vec<OsString> {
    line().words
}

impl Line {
    /// The first word that is not a global flag decides: `luxel info` is the command, `luxel view info`
    /// opens a file of that name.
    pub(crate) fn new(words: impl IntoIterator<Item = OsString>) -> Self {
        let mut words: Vec<_> = words.into_iter().collect();
        let of_all = ["-q", "--quiet", "-v", "--verbose"];
        let first = words.iter().skip(1).position(|word| !of_all.iter().any(|flag| word == flag));
        let place = first.map_or(words.len(), |place| place + 1);
        let names_one = words.get(place).is_some_and(|word| {
            let about = ["help", "-h", "--help", "-V", "--version"];
            about.iter().any(|name| word == name)
                || command_names().iter().any(|name| word == name.as_str())
        });
        let place = place.max(1).min(words.len());
        if !names_one {
            words.insert(place, "view".into());
        }
        Self { words, place, is_completed: !names_one }
    }

    /// A message if the first word is neither a command nor a file, but nearly a command.
    pub(crate) fn misspelt_command(&self) -> Option<String> {
        let word = self.words.get(self.place + 1)?;
        if self.words.get(self.place).is_some_and(|command| command == "help") {
            let (name, names) = (word.to_str()?, command_names());
            let meant = nearest(name, names.iter().map(String::as_str))?;
            let is_one = names.iter().any(|known| known == name);
            let what = format!("there is no command `{name}`: did you mean `luxel help {meant}`?");
            return (!is_one).then_some(what);
        }
        let word = Some(word).filter(|_| self.is_completed)?;
        let name = word.to_str().filter(|name| !Path::new(name).exists())?;
        let names = command_names();
        let meant = nearest(name, names.iter().map(String::as_str))?;
        Some(format!("`{name}` is neither a command nor a file: did you mean `luxel {meant}`?"))
    }

    /// The line with the command that takes its flags, if `view`, which it doesn't name, does not:
    /// `luxel x.obj -o a.png` is meant as `luxel render x.obj -o a.png`.
    pub(crate) fn meant_command(&self, error: &clap::Error) -> Option<String> {
        if !self.is_completed || error.kind() != ErrorKind::UnknownArgument {
            return None;
        }
        let with = |command: &&str| {
            let mut words = self.words.clone();
            words[self.place] = command.into();
            words
        };
        let takes_flags =
            |words: &Vec<OsString>| Cli::command().try_get_matches_from(words).is_ok();
        let words = ["render", "pick", "explain", "info", "check", "bench", "navigate"]
            .iter()
            .map(with)
            .find(takes_flags)?;
        let words: Vec<_> = words[1..].iter().map(|word| word.to_string_lossy()).collect();
        Some(format!("luxel {}", words.join(" ")))
    }
}

fn command_names() -> Vec<String> {
    Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).collect()
}

#[cfg(test)]
mod scene_file_page;
#[cfg(test)]
mod scene_file_tests;
#[cfg(test)]
mod settings_tests;
#[cfg(all(test, feature = "viewer"))]
mod view_line_tests;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_command_is_view() {
        for (line, expected) in [
            ("luxel", "luxel view"),
            ("luxel a.glb --size 3x3", "luxel view a.glb --size 3x3"),
            ("luxel -q demo:teapot", "luxel -q view demo:teapot"),
            ("luxel --fov 3 info", "luxel view --fov 3 info"),
            ("luxel info a.glb", "luxel info a.glb"),
            ("luxel -v render", "luxel -v render"),
            ("luxel --help", "luxel --help"),
            ("luxel help", "luxel help"),
        ] {
            let line = Line::new(line.split(' ').map(OsString::from));
            assert_eq!(line.words.join(" ".as_ref()), expected);
        }
    }

    #[test]
    fn clap_accepts_the_table_of_options() {
        Cli::command().debug_assert();
    }

    #[test]
    fn every_command_and_every_flag_has_help() {
        let program = Cli::command();
        for command in program.get_subcommands() {
            assert!(command.get_about().is_some(), "{}", command.get_name());
            for flag in command.get_arguments() {
                assert!(flag.get_help().is_some(), "{} {}", command.get_name(), flag.get_id());
            }
        }
    }

    #[test]
    fn the_flags_in_remedies_of_findings_exist() {
        for kind in luxel::check::Kind::ALL {
            if let Some((_, flags)) = crate::flag_words::cure(kind).split_once("in luxel: ") {
                let line = ["luxel", "render", "x.obj", "-o", "x.png"];
                let words = line.into_iter().chain(flags.split(' '));
                assert!(Cli::command().try_get_matches_from(words).is_ok(), "{flags}");
            }
        }
    }
}
