//! A window onto a 3D model, drawn on the processor: `winit` gives the window and its events,
//! `softbuffer` brings pixels into it, `luxel` draws them.
//!
//! The picture is drawn on a thread of its own, and only when something has changed. While the camera
//! moves, resolution drops as far as the frame rate needs; at rest the picture sharpens.

#![forbid(unsafe_code)]

mod app;
mod clipboard;
mod compare;
mod compose;
mod divider;
mod explain;
mod files;
mod focus;
mod guides;
mod handles;
mod help;
mod icons;
mod keys;
mod lamps;
mod ledger;
mod lines;
mod loading;
mod look;
mod marks;
mod model;
mod opener;
mod outline;
mod pace;
mod paint;
mod panels;
mod places;
mod probe;
mod recorder;
mod ruler;
mod screen;
mod session;
mod sheet;
mod snapshot;
mod terminal;
mod theme;
mod ui;
mod wait;
mod wardrobe;
mod worker;

pub use app::{
    Options, Outcome, Print, Save, Seen, Showing, ViewerError, WhenInterrupted, Write, run,
};
pub use keys::{Keys, KeysError, KeysErrorKind};
pub use loading::Loading;
pub use model::Model;
pub use terminal::{Graphics, GraphicsChoice, TerminalOptions, leave_terminal, view_in_terminal};
pub use theme::ThemeChoice;
