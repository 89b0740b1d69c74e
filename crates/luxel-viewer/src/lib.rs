//! An interactive window for 3D models rendered on the CPU: `winit` opens the window and delivers its
//! events, `softbuffer` presents the pixels, `luxel` renders them. The same scene can be viewed in a
//! terminal, over SSH too.
//!
//! A separate thread renders, and only when something has changed. While the camera moves, the
//! resolution drops as far as the frame rate requires; at rest the picture is refined.
//!
//! # Features
//!
//! `window` (default) is the window with its panels. Without it, [`view_in_terminal`] remains, which
//! needs no library of the system.

#![forbid(unsafe_code)]
#![cfg_attr(
    not(feature = "window"),
    allow(dead_code, unused_imports, reason = "session, keys and pictures serve the window too")
)]

mod display;
mod keys;
mod model;
mod number;
mod options;
mod picture;
mod projection;
mod render;
mod selection;
mod session;
mod terminal;
mod theme;
#[cfg(feature = "window")]
mod ui;
#[cfg(feature = "window")]
mod window;

pub use keys::{Keys, KeysError, KeysErrorKind};
pub use model::{LoadProgress, Model};
pub use options::{
    OnInterrupt, Options, Outcome, PrintCommand, SaveScene, ShownScene, ShownView, ViewerError,
    WriteFile,
};
pub use terminal::{Graphics, GraphicsChoice, TerminalOptions, leave_terminal, view_in_terminal};
pub use theme::ThemeChoice;
#[cfg(feature = "window")]
pub use window::run;
