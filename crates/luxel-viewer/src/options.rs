//! How a window is opened, and how it ends.

use crate::keys::Keys;
use crate::theme::ThemeChoice;
use luxel::formats::SurfaceChange;
use luxel::navigation::{Log, Mode};
use luxel::render::{Execution, View};
use luxel::scene::{Scene, SceneLight, Size};
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// How the window starts, and the callbacks through which it writes files and notices.
pub struct Options {
    /// The files to step through; `demo:NAME` and `-` mean what they mean on the command line.
    pub files: Vec<OsString>,
    /// The window's size in logical pixels.
    pub size: Size,
    /// The initial navigation mode.
    pub mode: Mode,
    /// The file that receives a log of the session when the window closes.
    pub record: Option<PathBuf>,
    /// A log to replay first, in real time.
    pub replay: Option<Log>,
    /// The colour theme.
    pub theme: ThemeChoice,
    /// Key bindings.
    pub keys: Keys,
    /// Threads and vector level of rendering.
    pub execution: Execution,
    /// Writes a file.
    pub write: WriteFile,
    /// Prints the command that draws the current view.
    pub print: PrintCommand,
    /// Saves what is shown as a scene file.
    pub save: SaveScene,
    /// Registers a handler for interrupts of the program.
    pub on_interrupt: OnInterrupt,
    /// Receives notices for the user.
    pub notice: Box<dyn Fn(&str)>,
    /// Receives timings, for verbose output.
    pub detail: Box<dyn Fn(&str)>,
}

/// Registers a handler for interrupts of the program. The handler closes the window; it returns
/// false if the window is gone already.
pub type OnInterrupt = Box<dyn Fn(Box<dyn FnOnce() -> bool + Send>)>;

/// Prints the command line that draws the current view of a file, and returns it.
pub type PrintCommand = Box<dyn Fn(&OsStr, &ShownView<'_>) -> String>;

/// The current view of a file.
pub struct ShownView<'a> {
    /// The view.
    pub view: &'a View,
    /// Its lights in world or camera coordinates, if they or the scene's ambient light differ from
    /// those of the file and the command line.
    pub lights: Option<Vec<SceneLight>>,
    /// Whether the environment differs from that of the file and the command line.
    pub is_environment_changed: bool,
}

/// Saves the current scene and view of a file as a scene file; returns its name, or an error for
/// the user.
pub type SaveScene = Box<dyn Fn(&OsStr, &ShownScene<'_>) -> Result<String, String>>;

/// The scene and view that a window shows.
pub struct ShownScene<'a> {
    /// The scene as it was loaded.
    pub scene: &'a Scene,
    /// The view.
    pub view: &'a View,
    /// The clipping planes that the user has fixed.
    pub planes: [Option<f64>; 2],
    /// Edits of its materials.
    pub changes: Vec<SurfaceChange>,
}

/// Writes a file, completely or not at all; the error is for the user.
pub type WriteFile = Box<dyn Fn(&Path, &[u8]) -> Result<(), String>>;

/// How the window was closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// By the user.
    Closed,
    /// By a signal.
    Interrupted,
    /// Because the first file failed to load; the loader knows why.
    NotLoaded,
}

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ViewerError {
    /// There is no display, or no window can be opened on it.
    #[error("no window can be opened: {0}")]
    NoDisplay(String),
    /// There is no terminal, or it fails.
    #[error("the terminal can't be used: {0}")]
    NoTerminal(String),
    /// The scene can't be drawn.
    #[error("{0}")]
    Draw(String),
    /// The session's log can't be written.
    #[error("{0}")]
    Record(String),
    /// No thread can be started.
    #[error("can't start a thread: {0}")]
    Thread(#[from] std::io::Error),
}
