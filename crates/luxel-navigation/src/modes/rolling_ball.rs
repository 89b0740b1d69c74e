//! The scene rotates like a ball that rolls under the pointer.
//!
//! A displacement (x, y), y upwards, rotates the scene about the axis (-y, x, 0) of camera space through
//! the pivot, by sqrt(x^2 + y^2) / r, r the ball's radius: the ball rolls without
//! slipping (Hanson 1992, The Rolling Ball, Graphics Gems III; the angle is the arc's, so that a
//! straight drag gives the same rotation in any number of steps). There is no gimbal lock. A small closed
//! loop of area A rotates the scene about the view axis by A / r^2, against the loop's sense.

use super::walk_with_pivot;
use crate::motion::Rigid;
use crate::settings::Settings;
use crate::state::{Drives, State};
use glam::{DVec2, DVec3};

pub(super) fn turn(state: State, settings: &Settings, way: DVec2) -> State {
    let way = way / settings.ball_radius();
    rolled(state, DVec3::new(-way.y, way.x, 0.0))
}

pub(super) fn drive(state: State, drives: &Drives) -> State {
    // The scene rotates opposite to the camera.
    let camera = DVec3::new(-drives.orbit.y, drives.orbit.x, drives.own.z);
    walk_with_pivot(rolled(state, -camera), drives.walk)
}

/// Rotates the scene about the pivot; axis and angle in camera space.
fn rolled(state: State, turn: DVec3) -> State {
    if turn == DVec3::ZERO {
        return state;
    }
    let centre = state.place.view.apply(state.place.pivot);
    state.moved(Rigid::turn_about(turn, centre))
}
