//! The camera moves around the pivot, on a sphere, and the horizon stays level.
//!
//! The hand's way to the right over the ball's radius turns the scene about the axis that is up, its
//! way upwards changes the elevation. The elevation stops at the poles: the view from straight above
//! can be reached, and there the scene can still be turned.

use super::{horizon, walk_with_pivot};
use crate::settings::Settings;
use crate::state::{Drives, State};
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

pub(super) fn turn(state: State, settings: &Settings, way: DVec2) -> State {
    around(state, settings, way / settings.ball_radius())
}

pub(super) fn drive(state: State, settings: &Settings, drives: &Drives) -> State {
    // The camera goes to the right as the scene turns to the left.
    let state = around(state, settings, -drives.orbit);
    walk_with_pivot(state, drives.walk)
}

/// Turns the scene to the right and upwards by angles.
fn around(state: State, settings: &Settings, angles: DVec2) -> State {
    if angles == DVec2::ZERO {
        return state;
    }
    let view = state.place.view;
    let centre = view.apply(state.place.pivot);
    let up = settings.up_axis();
    state.moved(horizon::turn(&view, up, centre, angles.to_array(), FRAC_PI_2))
}
