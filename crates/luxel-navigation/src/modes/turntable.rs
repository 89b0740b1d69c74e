//! The camera orbits the pivot on a sphere, with a level horizon.
//!
//! Dragging right rotates the scene about the up axis by the displacement over the ball's radius, dragging
//! up changes the elevation. The elevation stops at the poles, where the scene can still be rotated.

use super::{horizon, walk_with_pivot};
use crate::settings::Settings;
use crate::state::{Drives, State};
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

pub(super) fn turn(state: State, settings: &Settings, way: DVec2) -> State {
    around(state, settings, way / settings.ball_radius())
}

pub(super) fn drive(state: State, settings: &Settings, drives: &Drives) -> State {
    // The camera moves right as the scene rotates left.
    let state = around(state, settings, -drives.orbit);
    walk_with_pivot(state, drives.walk)
}

/// Rotates the scene to the right and upwards by angles.
fn around(state: State, settings: &Settings, angles: DVec2) -> State {
    if angles == DVec2::ZERO {
        return state;
    }
    let view = state.place.view;
    let centre = view.apply(state.place.pivot);
    let up = settings.up_axis();
    state.moved(horizon::turn(&view, up, centre, angles.to_array(), FRAC_PI_2))
}
