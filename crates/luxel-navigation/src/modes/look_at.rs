//! The keyboard moves eye and target along the world's axes; the camera looks from eye to target with the
//! up axis upwards in the picture, as `gluLookAt` does.
//!
//! The target is the pivot. Straight above and below it the camera keeps its previous up direction.
//! Steps that would move the eye to the target are ignored.

use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::Settings;
use crate::state::{Drives, State};
use glam::DVec3;
use luxel_scene::Camera;

/// The least distance of eye and target, relative to their coordinates, that defines a direction.
const MIN_DISTANCE: f64 = 1e-9;
/// The sine of the angle between view and up below which up has no direction in the picture.
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

/// The pose with the same eye that looks at the target; unchanged if it does already.
pub(super) fn aimed(state: &State, settings: &Settings) -> Place {
    let in_view = state.place.view.apply(state.place.pivot);
    let is_aimed = in_view.truncate().length() <= MIN_DISTANCE * -in_view.z;
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
    if !size.is_finite() || back.length() <= MIN_DISTANCE * size {
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
