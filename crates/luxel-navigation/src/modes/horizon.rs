//! Turning with a level horizon: azimuth about the axis that is up, elevation up to a limit.

use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::Settings;
use glam::{DMat3, DVec3};

/// A camera whose right axis rises by less than this, per length, counts as level.
const LEVEL: f64 = 1e-6;

/// The increment that turns the scene about the axis that is up by `yaw`, and the camera upwards by
/// `pitch`, both by the right-hand rule and about `centre`, given in camera space. The elevation
/// of the view is read from the camera itself, so no angles need to be kept.
///
/// The view's elevation stops at `limit`; a camera that is beyond it may come back. At the pole
/// itself the camera's own right axis says what is horizontal, so nothing flips there.
pub(crate) fn turn(
    view: &Rigid,
    up: DVec3,
    centre: DVec3,
    [yaw, pitch]: [f64; 2],
    limit: f64,
) -> Rigid {
    let up = view.rotation * up;
    let (horizontal, elevation) = if up.x.abs() < LEVEL {
        // A full circle: upside down lies beyond the poles.
        (DVec3::X, libm::atan2(-up.z, up.y))
    } else {
        // Of a tilted camera: view x up.
        let across = DVec3::new(up.y, -up.x, 0.0);
        let length = across.length();
        (across / length, libm::atan2(-up.z, length))
    };
    let lowest = elevation.min(-limit);
    let highest = elevation.max(limit);
    let pitch = (elevation + pitch).clamp(lowest, highest) - elevation;
    let about_up = Rigid::turn_about(up * yaw, centre);
    about_up.then(Rigid::turn_about(-horizontal * pitch, centre))
}

/// The place with a level horizon, upright, with the same eye and direction; as it is if it is level
/// already, or looks straight up or down, where any camera is.
pub(crate) fn level(place: &Place, settings: &Settings) -> Place {
    let up_axis = settings.up_axis();
    let up = place.view.rotation * up_axis;
    let is_upright = up.x.abs() < LEVEL && up.y > -LEVEL;
    let eye = place.view.eye();
    let back = -place.view.direction();
    let Some(right) = up_axis.cross(back).try_normalize() else { return *place };
    if is_upright {
        return *place;
    }
    let rotation = DMat3::from_cols(right, back.cross(right), back).transpose();
    Place { view: Rigid { rotation, translation: -(rotation * eye) }, ..*place }
}
