//! An interactive window for 3D models rendered on the CPU: `winit` opens the window and delivers its
//! events, `softbuffer` presents the pixels, `luxel` renders them.
//!
//! A separate thread renders, and only when something has changed. While the camera moves, the
//! resolution drops as far as the frame rate requires; at rest the picture is refined.

#![forbid(unsafe_code)]

mod display;
mod keys;
mod model;
mod options;
mod picture;
mod projection;
mod render;
mod selection;
mod session;
mod terminal;
mod theme;
mod ui;
mod window;

pub use keys::{Keys, KeysError, KeysErrorKind};
pub use model::{LoadProgress, Model};
pub use options::{
    OnInterrupt, Options, Outcome, PrintCommand, SaveScene, ShownScene, ShownView, ViewerError,
    WriteFile,
};
pub use terminal::{Graphics, GraphicsChoice, TerminalOptions, leave_terminal, view_in_terminal};
pub use theme::ThemeChoice;
pub use window::run;
