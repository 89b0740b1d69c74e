//! Flying: roll, pitch and yaw about the camera's own axes, and a throttle.
//!
//! The speed stays until the throttle changes it, below zero too. While time passes, turning and
//! moving ahead are one screw motion, so that the way flown doesn't depend on how time is cut into
//! frames. The hand steers: to the right is yaw to the right, upwards is pitch up.

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
    // Steady acceleration: the mean of the speeds.
    let ahead = (before + state.speed) * 0.5 * seconds;
    steer(state, drives.own, drives.walk - DVec3::Z * ahead)
}

/// Turns and moves the camera in its own axes.
fn steer(state: State, turn: DVec3, shift: DVec3) -> State {
    if turn == DVec3::ZERO && shift == DVec3::ZERO {
        return state;
    }
    // The scene moves the other way: the inverse of a screw is the screw backwards.
    state.moved(Rigid::screw(-turn, -shift))
}
