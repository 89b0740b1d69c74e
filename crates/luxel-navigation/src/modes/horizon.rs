//! Rotation with a level horizon: azimuth about the up axis, elevation up to a limit.

use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::Settings;
use glam::{DMat3, DVec3};

/// The largest slope of the right axis of a level camera.
const LEVEL: f64 = 1e-6;

/// The increment that rotates the scene about the up axis by `yaw` and the camera upwards by `pitch`,
/// both by the right-hand rule and about `centre` in camera space. The elevation is read from the camera
/// itself, so no angles are stored.
///
/// The elevation stops at `limit`; a camera beyond it may return. At the pole the camera's right axis
/// defines the horizontal, so that nothing flips.
pub(crate) fn turn(
    view: &Rigid,
    up: DVec3,
    centre: DVec3,
    [yaw, pitch]: [f64; 2],
    limit: f64,
) -> Rigid {
    let up = view.rotation * up;
    let (horizontal, elevation) = if up.x.abs() < LEVEL {
        // Over the full circle: upside down lies beyond the poles.
        (DVec3::X, libm::atan2(-up.z, up.y))
    } else {
        // For a tilted camera: view x up.
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

/// The upright pose with a level horizon and the same eye and direction; unchanged if it is level already,
/// or looks straight up or down.
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
