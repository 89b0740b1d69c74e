//! The keyboard moves eye and target along the axes of the world; the camera looks from the one to
//! the other, with the axis that is up pointing up in the picture, as `gluLookAt` does.
//!
//! The target is the pivot. Straight above and below it the camera keeps the up of the view before.
//! A step that would put the eye at the target is not made.

use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::Settings;
use crate::state::{Drives, State};
use glam::DVec3;
use luxel_scene::Camera;

/// How near, in parts of their coordinates, eye and target may come: there is a direction left.
const NEAREST: f64 = 1e-9;
/// The sine of the angle between view and up below which up has no direction left in the picture.
const ALONG_UP: f64 = 1e-6;

pub(super) fn drive(state: State, settings: &Settings, drives: &Drives) -> State {
    if drives.shift == DVec3::ZERO && drives.target == DVec3::ZERO {
        return state;
    }
    let eye = state.place.view.eye() + drives.shift;
    let target = state.place.pivot + drives.target;
    match looking(&state.place, settings, eye, target) {
        Some(place) => State { place, ..state },
        None => state,
    }
}

/// The place with the same eye that looks at the target; as it is if it does already.
pub(super) fn aimed(state: &State, settings: &Settings) -> Place {
    let in_view = state.place.view.apply(state.place.pivot);
    let is_aimed = in_view.truncate().length() <= NEAREST * -in_view.z;
    let leveled = super::level(&state.place, settings);
    if is_aimed {
        return leveled;
    }
    let eye = state.place.view.eye();
    looking(&state.place, settings, eye, state.place.pivot).unwrap_or(leveled)
}

fn looking(place: &Place, settings: &Settings, eye: DVec3, target: DVec3) -> Option<Place> {
    let size = eye.abs().max(target.abs()).max_element();
    let back = eye - target;
    if !size.is_finite() || back.length() <= NEAREST * size {
        return None;
    }
    let up = settings.up_axis();
    let up = if up.cross(back.normalize_or_zero()).length() < ALONG_UP {
        place.view.rotation.row(1)
    } else {
        up
    };
    let view = Rigid::from_matrix(&Camera::look_at(eye, target, up));
    Some(Place { view, pivot: target, ..*place })
}
