//! `luxel view`: the interactive viewer.

use crate::options::{InputOptions, ViewOptions};
#[cfg(not(feature = "viewer"))]
use crate::{console::Console, failure::Failure};
#[cfg(not(feature = "viewer"))]
use clap::Command;
use clap::{Args, ValueEnum};
use luxel::navigation::Mode;
use std::ffi::OsString;

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

#[cfg(not(feature = "viewer"))]
impl ViewCommand {
    pub(crate) fn run(self, _: Console, _: &[OsString], _: Command) -> Result<(), Failure> {
        let what = "this build of luxel has no window";
        Err(Failure::work(what, "build luxel with `--features viewer`, or use `luxel render`"))
    }
}

#[cfg(feature = "viewer")]
mod keys;
#[cfg(feature = "viewer")]
pub(crate) mod line;
#[cfg(feature = "viewer")]
mod saved;

#[cfg(feature = "viewer")]
mod window {
    use super::keys;
    use super::line::line;
    use super::saved;
    use super::{GraphicsName, ThemeName, ViewCommand};
    use crate::console::Console;
    use crate::failure::Failure;
    use crate::options::InputOptions;
    use crate::{model, navigation, output, surface, view};
    use clap::parser::ValueSource;
    use clap::{ArgMatches, Command};
    use luxel_viewer::{
        Graphics, GraphicsChoice, LoadProgress, Model, Options, Outcome, TerminalOptions,
        ThemeChoice, ViewerError, leave_terminal, view_in_terminal,
    };
    use std::ffi::{OsStr, OsString};
    use std::path::{Path, PathBuf};
    use std::sync::{Arc, Mutex, PoisonError};

    /// The default model: the teapot on the coloured ground.
    const WELCOME: &str = "demo:welcome";

    /// Whether the command line names a model.
    fn names_model(program: &Command, words: &[OsString]) -> bool {
        let matches = program.clone().try_get_matches_from(words).ok();
        let matches = matches.as_ref().and_then(ArgMatches::subcommand);
        let source = matches.and_then(|(_, view)| view.value_source("model"));
        source.is_none_or(|source| source == ValueSource::CommandLine)
    }

    /// Fails after a stop; the failure is not shown.
    fn stopped(progress: &LoadProgress) -> Result<(), Failure> {
        if progress.is_stopped() { Err(Failure::work("it was stopped", "")) } else { Ok(()) }
    }

    /// Writes a file. The error omits the remedy, which names a flag.
    fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
        output::write_file(path, bytes)
            .map_err(|failure| failure.lines().first().copied().unwrap_or_default().to_owned())
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
                return self.in_terminal(console);
            }
            let words = words.to_vec();
            let files: Vec<_> = std::iter::once(&self.input.model).chain(&self.more).collect();
            for file in &files {
                self.check_model(file, console)?;
            }
            let files = files.into_iter().cloned().collect();
            let record = self.record.as_ref().map(PathBuf::from);
            if let Some(path) = &record {
                output::check_writable(path, "--record")?;
            }
            let most = self.view.execution.max_memory;
            let replay = self.replay.as_ref().map(|path| navigation::read_log(path, most));
            let (restyle, shading) =
                (surface::restyle(&self.view.material), self.view.shading.clone());
            let options = Options {
                files,
                size: self.view.frame.size,
                mode: self.mode,
                record,
                replay: replay.transpose()?.map(|(log, _)| log),
                theme: self.theme(),
                keys: keys::keys(self.keys.as_deref())?,
                execution: view::execution(&self.view.execution),
                write: Box::new(write),
                print: Box::new(move |file, seen| {
                    let line = line(&program, &words, file, seen);
                    // The reader may be gone; the window stays open.
                    let _ = output::print(&format!("{line}\n"));
                    line
                }),
                save: Box::new(move |file, showing| {
                    let (path, text) = saved::saved(file, showing, restyle.clone(), &shading)?;
                    write(&path, text.as_bytes())?;
                    Ok(path.display().to_string())
                }),
                on_interrupt: Box::new(output::on_interrupt),
                notice: Box::new(move |what| console.notice(what)),
                detail: Box::new(move |what| console.detail(what)),
            };
            // The error of the loading thread.
            let failure = Arc::new(Mutex::new(None));
            let kept = Arc::clone(&failure);
            let load = move |file: &OsStr, progress: &LoadProgress| {
                self.load(file, console, progress).map_err(|failure| {
                    let what = failure.lines().join("; ");
                    *kept.lock().unwrap_or_else(PoisonError::into_inner) = Some(failure);
                    what
                })
            };
            match luxel_viewer::run(load, options) {
                Ok(Outcome::Closed) => Ok(()),
                Ok(Outcome::NotLoaded) => {
                    let failure = failure.lock().unwrap_or_else(PoisonError::into_inner).take();
                    failure.map_or(Ok(()), Err)
                }
                Ok(Outcome::Interrupted) => Err(Failure::Interrupted),
                Err(error @ ViewerError::Record(_)) => {
                    Err(Failure::work(error.to_string(), "choose another file with --record"))
                }
                Err(error @ ViewerError::NoDisplay(_)) => Err(Failure::work(
                    error.to_string(),
                    "`luxel view --terminal` and `luxel render` need no display; or set DISPLAY",
                )),
                Err(error) => Err(Failure::work(error.to_string(), "")),
            }
        }

        fn theme(&self) -> ThemeChoice {
            match self.theme {
                ThemeName::Auto => ThemeChoice::Auto,
                ThemeName::Dark => ThemeChoice::Dark,
                ThemeName::Light => ThemeChoice::Light,
            }
        }

        /// Runs the viewer in the terminal.
        fn in_terminal(&self, console: Console) -> Result<(), Failure> {
            let keys = keys::keys(self.keys.as_deref())?;
            let graphics = match self.graphics {
                GraphicsName::Auto => GraphicsChoice::Auto,
                GraphicsName::Kitty => GraphicsChoice::Only(Graphics::Kitty),
                GraphicsName::Iterm2 => GraphicsChoice::Only(Graphics::Iterm2),
                GraphicsName::Sixel => GraphicsChoice::Only(Graphics::Sixel),
                GraphicsName::Blocks => GraphicsChoice::Only(Graphics::Blocks),
            };
            let file = &self.input.model;
            let model = self.load(file, console, &LoadProgress::default())?;
            let options = TerminalOptions {
                file: file.clone(),
                mode: self.mode,
                keys,
                theme: self.theme(),
                graphics,
                execution: view::execution(&self.view.execution),
                write: Box::new(write),
            };
            output::on_interrupt(Box::new(|| {
                leave_terminal();
                false
            }));
            view_in_terminal(model, &options).map_err(|error| match error {
                ViewerError::NoTerminal(_) => Failure::work(
                    error.to_string(),
                    "run it in a terminal, or draw a file with `luxel render`",
                ),
                error => Failure::work(error.to_string(), ""),
            })
        }

        /// Fails before a window opens if the file is missing or a folder.
        fn check_model(&self, model: &OsStr, console: Console) -> Result<(), Failure> {
            let is_file = model != "-" && !model.to_string_lossy().starts_with("demo:");
            if is_file && !std::fs::metadata(model).is_ok_and(|there| !there.is_dir()) {
                return model::load(&self.input(model), &self.view.execution, console).map(|_| ());
            }
            Ok(())
        }

        /// Another model, of the same format if `--format` is given.
        fn input(&self, model: &OsStr) -> InputOptions {
            InputOptions { model: model.to_owned(), format: self.input.format }
        }

        fn load(
            &self,
            file: &OsStr,
            console: Console,
            progress: &LoadProgress,
        ) -> Result<Model, Failure> {
            let input = self.input(file);
            let reading = Some(progress.reader.clone());
            let mut model =
                model::load_with_progress(&input, &self.view.execution, console, reading)?;
            progress.file_parsed();
            stopped(progress)?;
            if model.scene.is_empty() {
                return Err(model::nothing_to_draw(&input.name()));
            }
            surface::apply_material(&self.view.material, &mut model.scene);
            surface::apply_normals(&self.view.shading, &mut model.scene);
            progress.normals_computed();
            stopped(progress)?;
            let scene = model.scene;
            let (state, settings, camera) = navigation::start(&self.view.frame, &scene, self.mode)?;
            let view = view::view(&self.view, None, camera, &scene)?;
            Ok(Model {
                scene: Arc::new(scene),
                view,
                up: settings.up,
                pivot: state.pivot(),
                planes: [self.view.frame.near, self.view.frame.far],
            })
        }
    }
}
