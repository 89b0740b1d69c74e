//! Camera control as pure functions: [`advance`] takes a [`State`], [`Settings`], an [`Event`] and
//! the seconds that have passed, and answers with the next state. It knows no window, no clock and no
//! file, and gives the same bits on every machine.
//!
//! Six ways to navigate ([`Mode`]), pan that keeps what is grabbed under the pointer, zoom to the
//! pointer, standard views, fitting, smooth ways between views, inertia; a [`Log`] of events in text
//! that plays back to the same camera. Only the view matrix is changed, never the projection: another
//! lens for the same picture is a function of its own, [`with_lens`].
//!
//! Motion relative to the camera is composed in camera coordinates, each increment I on the left of
//! what the last frame used, p' = I C p, and kept a rotation without drift; no angles are added up.
//! World space is right-handed, the camera looks along -Z of its own space, window coordinates
//! begin at the upper left with y down.

#![forbid(unsafe_code)]

mod event;
mod gizmo;
mod hand;
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
