//! Camera control as pure functions: [`advance`] takes a [`State`], [`Settings`], an [`Event`] and
//! the elapsed seconds, and returns the next state. It depends on no window, clock or file, and gives
//! the same bits on every machine.
//!
//! Six navigation modes ([`Mode`]), panning that keeps the grabbed point under the pointer, zoom to the
//! pointer, standard views, fitting, transitions, inertia; a textual [`Log`] of events that replays to
//! the same camera. Only the view matrix changes, never the projection; [`with_lens`] changes the lens
//! and keeps the picture in place.
//!
//! Motion relative to the camera is composed in camera space, each increment I on the left of the
//! previous matrix, p' = I C p, and orthonormalised; no angles are accumulated. World space is
//! right-handed, the camera looks along -Z, window coordinates start at the upper left with y down.

#![forbid(unsafe_code)]

mod event;
mod gestures;
mod gizmo;
mod lens;
mod log;
mod modes;
mod motion;
mod navigator;
mod place;
mod settings;
mod state;
mod transition;
mod views;
mod window;

pub use event::{Axis, Command, Drive, Event, Gesture, Mode, StandardView, UnknownName};
pub use gizmo::{Knob, hit, knobs};
pub use lens::{parallel_height, with_lens};
pub use log::{Change, Entry, LOG_VERSION, Log, LogError, LogErrorKind};
pub use navigator::advance;
pub use settings::{Number, Settings};
pub use state::{State, is_rigid};
