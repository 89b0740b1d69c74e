//! Flying: roll, pitch and yaw about the camera's own axes, and a throttle.
//!
//! The speed persists until the throttle changes it, and may be negative. Rotation and forward motion are
//! one screw motion, so that the path doesn't depend on the frame rate. Dragging steers: right is yaw to
//! the right, up is pitch up.

use crate::motion::Rigid;
use crate::settings::{Number, Settings};
use crate::state::{Drives, State};
use glam::{DVec2, DVec3};

pub(super) fn turn(state: State, settings: &Settings, way: DVec2) -> State {
    let angles = way * settings.number(Number::LookRate);
    steer(state, DVec3::new(angles.y, -angles.x, 0.0), DVec3::ZERO)
}

pub(super) fn drive(mut state: State, settings: &Settings, drives: &Drives, seconds: f64) -> State {
    let limit = settings.number(Number::SpeedLimit);
    let before = state.speed;
    state.speed = (before + drives.throttle).clamp(-limit, limit);
    // Constant acceleration: the mean of the speeds.
    let ahead = (before + state.speed) * 0.5 * seconds;
    steer(state, drives.own, drives.walk - DVec3::Z * ahead)
}

/// Rotates and moves the camera in its own axes.
fn steer(state: State, turn: DVec3, shift: DVec3) -> State {
    if turn == DVec3::ZERO && shift == DVec3::ZERO {
        return state;
    }
    // The scene moves the other way: the inverse of a screw is its negation.
    state.moved(Rigid::screw(-turn, -shift))
}
