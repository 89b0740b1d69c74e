//! The keyboard turns and moves the camera about and along the axes of the world.
//!
//! The camera rotates by the right-hand rule about axes through the pivot; the scene appears to rotate the
//! other way. Several keys at once are one rotation about the sum of their axes.

use crate::motion::Rigid;
use crate::state::{Drives, State};
use glam::DVec3;

pub(super) fn drive(state: State, drives: &Drives) -> State {
    let mut state = state;
    if drives.turn != DVec3::ZERO {
        let view = state.place.view;
        let turn = view.rotation * -drives.turn;
        state = state.moved(Rigid::turn_about(turn, view.apply(state.place.pivot)));
    }
    if drives.shift != DVec3::ZERO {
        let shift = state.place.view.rotation * drives.shift;
        state = state.moved(Rigid::shift(-shift));
    }
    state
}
