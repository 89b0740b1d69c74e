//! Target poses of standard and fitted views.

use crate::event::StandardView;
use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::Settings;
use crate::state::State;
use glam::{DMat3, DVec3};
use luxel_scene::{Bounds, Lens, Viewpoint, fit_box};

impl StandardView {
    /// The picture's right, up and back directions in world space, for the up axis `up`.
    #[must_use]
    pub fn axes(self, up: DVec3) -> [DVec3; 3] {
        // Permuting axes keeps them exact, unlike sines and cosines.
        let front = Viewpoint { up, azimuth_radians: 0.0, elevation_radians: 0.0 };
        let [right, up, front] = front.axes();
        match self {
            Self::Front => [right, up, front],
            Self::Back => [-right, up, -front],
            Self::Right => [-front, up, right],
            Self::Left => [front, up, -right],
            Self::Top => [right, -front, up],
            Self::Bottom => [right, front, -up],
        }
    }
}

/// The standard view of the pivot, at the same distance and position in the picture; centred if it was
/// behind the eye.
pub(crate) fn standard(state: &State, settings: &Settings, view: StandardView) -> Place {
    let [right, up, back] = view.axes(settings.up_axis());
    let rotation = DMat3::from_cols(right, up, back).transpose();
    let in_view = state.place.view.apply(state.place.pivot);
    let in_view = if in_view.z < 0.0 { in_view } else { DVec3::NEG_Z * state.pivot_depth() };
    let translation = in_view - rotation * state.place.pivot;
    Place { view: Rigid { rotation, translation }, ..state.place }
}

/// The view that fits a box, in the same direction. Empty boxes change nothing.
pub(crate) fn fitted(state: &State, settings: &Settings, bounds: &Bounds) -> Place {
    if bounds.is_empty() || !bounds.min.is_finite() || !bounds.max.is_finite() {
        return state.place;
    }
    let axes = [0, 1, 2].map(|row| state.place.view.rotation.row(row));
    let lens = match settings.lens {
        // A height of 0 asks for the one that fits.
        Lens::Orthographic { .. } => Lens::Orthographic { height: 0.0 },
        lens => lens,
    };
    let camera = fit_box(bounds, axes, lens, settings.size);
    let scale = match (camera.projection.lens, settings.lens) {
        (Lens::Orthographic { height: fitted }, Lens::Orthographic { height }) => fitted / height,
        _ => state.place.scale,
    };
    let view = Rigid::from_matrix(&camera.view_from_world);
    Place { view, pivot: bounds.centre(), scale }
}
