//! What a window is opened with, and how it ends.

use crate::keys::Keys;
use crate::theme::ThemeChoice;
use luxel::formats::SurfaceChange;
use luxel::navigation::{Log, Mode};
use luxel::render::{Execution, View};
use luxel::scene::{Scene, SceneLight, Size};
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// How the window begins, and what it leaves.
pub struct Options {
    /// The files to look at, one after the other; `demo:NAME` and `-` are those of the command line.
    pub files: Vec<OsString>,
    /// The window's size in logical pixels.
    pub size: Size,
    /// The way to navigate at first.
    pub mode: Mode,
    /// Where a log of what is done goes, at the end.
    pub record: Option<PathBuf>,
    /// A log to be played at first, in its own time.
    pub replay: Option<Log>,
    /// The window's colours.
    pub theme: ThemeChoice,
    /// What keys do.
    pub keys: Keys,
    /// How pictures are drawn.
    pub execution: Execution,
    /// Writes a file, whole or not at all; answers with what went wrong, for the user.
    pub write: Write,
    /// Prints the line of a terminal that draws what is seen of a file, and answers with it.
    pub print: Print,
    /// Saves what is shown of a file as a scene file; answers with its name, or with what went wrong.
    pub save: Save,
    /// Takes what is to be done when the program is interrupted.
    pub when_interrupted: WhenInterrupted,
    /// Says something that is worth knowing.
    pub tell: Box<dyn Fn(&str)>,
    /// Says how long things take, to those who have asked for it.
    pub detail: Box<dyn Fn(&str)>,
}

/// Takes what is to be done when the program is interrupted: it closes the window, or says that there is
/// none any more.
pub type WhenInterrupted = Box<dyn Fn(Box<dyn FnOnce() -> bool + Send>)>;

/// Prints the line of a terminal that draws what is seen of a file, and answers with it.
pub type Print = Box<dyn Fn(&OsStr, &Seen<'_>) -> String>;

/// What is seen of a file, to be drawn again.
pub struct Seen<'a> {
    /// The view.
    pub view: &'a View,
    /// Its lights in coordinates of the world or the camera, if they or the scene's ambient light are not
    /// those that the file or the line has.
    pub lights: Option<Vec<SceneLight>>,
    /// Whether what mirrors and metals see is not what the file or the line has.
    pub is_environment_changed: bool,
}

/// Saves what is shown of a file as a scene file; answers with its name, or with what went wrong.
pub type Save = Box<dyn Fn(&OsStr, &Showing<'_>) -> Result<String, String>>;

/// What a window shows, to be saved.
pub struct Showing<'a> {
    /// The scene as it was read.
    pub scene: &'a Scene,
    /// The view.
    pub view: &'a View,
    /// The clipping planes that the user has fixed.
    pub planes: [Option<f64>; 2],
    /// What was changed of the surfaces.
    pub changes: Vec<SurfaceChange>,
}

/// Writes a file; answers with what went wrong.
pub type Write = Box<dyn Fn(&Path, &[u8]) -> Result<(), String>>;

/// How the window came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The user has closed it.
    Closed,
    /// A signal has closed it.
    Interrupted,
    /// The first file was not loaded; whoever has tried knows why.
    NotLoaded,
}

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ViewerError {
    /// The system has no display, or gives no window on it.
    #[error("no window can be opened: {0}")]
    NoDisplay(String),
    /// There is no terminal, or it doesn't answer.
    #[error("the terminal can't be used: {0}")]
    NoTerminal(String),
    /// The scene can't be drawn.
    #[error("{0}")]
    Draw(String),
    /// The log of what was done could not be written.
    #[error("{0}")]
    Record(String),
    /// The system gives no thread.
    #[error("can't start a thread: {0}")]
    Thread(#[from] std::io::Error),
}
