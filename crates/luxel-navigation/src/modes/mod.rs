//! The navigation modes: the effect of turn gestures and held keys in each.

mod absolute;
mod flying;
mod horizon;
mod look_at;
mod mouselook;
mod rolling_ball;
mod turntable;

use crate::event::Mode;
use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::Settings;
use crate::state::{Drives, State};
use glam::{DVec2, DVec3};
pub(crate) use horizon::level;

/// Applies a turn gesture, in pixels to the right and upwards.
pub(crate) fn turn(state: State, settings: &Settings, way: DVec2) -> State {
    match state.mode {
        // Keyboard modes turn like the turntable.
        Mode::Absolute | Mode::LookAt | Mode::Turntable => turntable::turn(state, settings, way),
        Mode::RollingBall => rolling_ball::turn(state, settings, way),
        Mode::Flying => flying::turn(state, settings, way),
        Mode::Mouselook => mouselook::turn(state, settings, way),
    }
}

/// Applies commands by amounts (world units, radians, speed) within some seconds.
pub(crate) fn drive(state: State, settings: &Settings, drives: &Drives, seconds: f64) -> State {
    match state.mode {
        Mode::Absolute => absolute::drive(state, drives),
        Mode::LookAt => look_at::drive(state, settings, drives),
        Mode::RollingBall => rolling_ball::drive(state, drives),
        Mode::Turntable => turntable::drive(state, settings, drives),
        Mode::Flying => flying::drive(state, settings, drives, seconds),
        Mode::Mouselook => mouselook::drive(state, settings, drives),
    }
}

/// The pose when a mode is entered: upright for modes with a level horizon, aimed at the target for
/// look-at.
pub(crate) fn entered(state: &State, settings: &Settings) -> Place {
    match state.mode {
        Mode::Turntable | Mode::Mouselook => level(&state.place, settings),
        Mode::LookAt => look_at::aimed(state, settings),
        Mode::Absolute | Mode::RollingBall | Mode::Flying => state.place,
    }
}

/// Walks relative to the pivot: sideways and upwards the pivot moves along and keeps its position in the
/// picture; forwards and backwards it stays.
fn walk_with_pivot(state: State, walk: DVec3) -> State {
    if walk == DVec3::ZERO {
        return state;
    }
    let sideways = state.place.view.rotation.transpose() * walk.with_z(0.0);
    let mut state = state.moved(Rigid::shift(-walk));
    state.place.pivot += sideways;
    state
}
