//! A window onto a 3D model, drawn on the processor: `winit` gives the window and its events,
//! `softbuffer` brings pixels into it, `luxel` draws them.
//!
//! The picture is drawn on a thread of its own, and only when something has changed. While the camera
//! moves, resolution drops as far as the frame rate needs; at rest the picture sharpens.

#![forbid(unsafe_code)]

mod app;
mod compose;
mod explain;
mod files;
mod keys;
mod marks;
mod model;
mod outline;
mod pace;
mod paint;
mod panels;
mod probe;
mod recorder;
mod ruler;
mod screen;
mod session;
mod theme;
mod ui;
mod worker;

pub use app::{Options, Outcome, Print, ViewerError, Write, run};
pub use model::Model;
