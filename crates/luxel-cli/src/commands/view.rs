//! `luxel view`: the interactive viewer.

#[cfg(feature = "terminal")]
mod keys;
#[cfg(feature = "viewer")]
pub(crate) mod line;
#[cfg(feature = "terminal")]
mod loading;
#[cfg(feature = "viewer")]
mod saved;
#[cfg(feature = "terminal")]
mod terminal;
#[cfg(feature = "viewer")]
mod window;

use crate::console::Console;
use crate::failure::Failure;
use crate::options::{InputOptions, ViewOptions};
use clap::parser::ValueSource;
use clap::{ArgMatches, Args, Command, ValueEnum};
use luxel::navigation::Mode;
use std::ffi::OsString;

/// The default model: the teapot on the coloured ground.
const WELCOME: &str = "demo:welcome";

/// View a model in a window
///
/// For example: luxel view model.glb --mode rolling-ball
#[derive(Args, Debug)]
pub(crate) struct ViewCommand {
    #[command(flatten)]
    input: InputOptions,

    /// More models; the arrow keys switch between them
    #[arg(value_name = "MODEL")]
    more: Vec<OsString>,

    /// The initial navigation mode: absolute, look-at, rolling-ball, flying, mouselook,
    /// turntable
    #[arg(long, value_name = "MODE", default_value = "turntable")]
    mode: Mode,

    /// Write a log of the session's events when the window closes
    #[arg(long, value_name = "FILE")]
    record: Option<OsString>,

    /// Replay a log of events in the window first
    #[arg(long, value_name = "FILE")]
    replay: Option<OsString>,

    /// Show the model in the terminal instead of a window, with the same keys
    #[arg(long, conflicts_with_all = ["record", "replay", "more"])]
    terminal: bool,

    /// How the terminal displays images: auto picks the best that it is known to support; blocks
    /// show two pixels per cell
    #[arg(long, value_enum, value_name = "HOW", default_value = "auto", requires = "terminal")]
    graphics: GraphicsName,

    /// The colour theme; auto follows the system
    #[arg(long, value_enum, value_name = "THEME", default_value = "auto")]
    theme: ThemeName,

    /// Begin without the occlusion and the ground that the window otherwise shows models with (not
    /// scene files, which decide for themselves)
    #[arg(long)]
    no_occlusion: bool,

    /// A file of key bindings [default: luxel/keys.toml in the user's configuration folder,
    /// if it exists]
    #[arg(long, value_name = "FILE")]
    keys: Option<OsString>,

    #[command(flatten)]
    view: ViewOptions,
}

/// How a terminal displays images.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum GraphicsName {
    Auto,
    Kitty,
    Iterm2,
    Sixel,
    Blocks,
}

/// The colour theme.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum ThemeName {
    Auto,
    Dark,
    Light,
}

impl ViewCommand {
    /// `words` is the whole command line, `program` its definition.
    pub(crate) fn run(
        mut self,
        console: Console,
        words: &[OsString],
        program: Command,
    ) -> Result<(), Failure> {
        if !names_model(&program, words) {
            self.input.model = WELCOME.into();
        }
        if self.input.model == "-" && self.replay.as_deref() == Some("-".as_ref()) {
            let message = "model and log can't both be the standard input: use a file";
            return Err(Failure::Usage(message.to_owned()));
        }
        if self.terminal {
            self.in_terminal(console)
        } else {
            self.in_window(console, words, program)
        }
    }

    #[cfg(not(feature = "terminal"))]
    fn in_terminal(&self, _: Console) -> Result<(), Failure> {
        let what = "this build of luxel has no viewer";
        Err(Failure::work(what, "build luxel with `--features terminal`, or use `luxel render`"))
    }

    #[cfg(not(feature = "viewer"))]
    fn in_window(self, _: Console, _: &[OsString], _: Command) -> Result<(), Failure> {
        let what = "this build of luxel has no window";
        let remedy = if cfg!(feature = "terminal") {
            "use `luxel view --terminal` or `luxel render`, or build luxel with `--features viewer`"
        } else {
            "build luxel with `--features viewer`, or use `luxel render`"
        };
        Err(Failure::work(what, remedy))
    }
}

/// Whether the command line names a model.
fn names_model(program: &Command, words: &[OsString]) -> bool {
    let matches = program.clone().try_get_matches_from(words).ok();
    let matches = matches.as_ref().and_then(ArgMatches::subcommand);
    let source = matches.and_then(|(_, view)| view.value_source("model"));
    source.is_none_or(|source| source == ValueSource::CommandLine)
}
