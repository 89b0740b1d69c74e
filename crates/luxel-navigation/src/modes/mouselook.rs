//! The mouse rotates the view, the keys move along the camera's own axes.
//!
//! Dragging right rotates to the right about the up axis, dragging up looks up, within the pitch limit.

use super::horizon;
use crate::motion::Rigid;
use crate::settings::{Number, Settings};
use crate::state::{Drives, State};
use glam::{DVec2, DVec3};

pub(super) fn turn(state: State, settings: &Settings, way: DVec2) -> State {
    look(state, settings, way * settings.number(Number::LookRate))
}

pub(super) fn drive(state: State, settings: &Settings, drives: &Drives) -> State {
    let mut state = state;
    let yaw = -drives.own.y;
    if drives.walk != DVec3::ZERO || yaw != 0.0 {
        // Rotating while walking follows an arc.
        let turn = state.place.view.rotation * settings.up_axis() * yaw;
        state = state.moved(Rigid::screw(turn, -drives.walk));
    }
    look(state, settings, DVec2::new(0.0, drives.own.x))
}

/// Rotates the view to the right and upwards by angles.
fn look(state: State, settings: &Settings, angles: DVec2) -> State {
    if angles == DVec2::ZERO {
        return state;
    }
    let view = state.place.view;
    let limit = settings.number(Number::PitchLimit);
    let up = settings.up_axis();
    state.moved(horizon::turn(&view, up, DVec3::ZERO, angles.to_array(), limit))
}
