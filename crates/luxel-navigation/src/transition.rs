//! Animated transitions between poses.

use crate::motion::{Rigid, rotation};
use crate::place::Place;
use glam::{DMat3, DQuat, DVec3};

/// A transition between two poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transition {
    from: Place,
    to: Place,
    /// Seconds since the start, and in total.
    elapsed: f64,
    duration: f64,
}

impl Transition {
    pub(crate) fn new(from: Place, to: Place, duration: f64) -> Self {
        Self { from, to, elapsed: 0.0, duration }
    }

    pub(crate) fn goal(&self) -> Place {
        self.to
    }

    /// The pose some seconds later, and the rest of the transition, if any.
    pub(crate) fn later(self, seconds: f64) -> (Place, Option<Self>) {
        let elapsed = self.elapsed + seconds;
        if elapsed >= self.duration {
            return (self.to, None);
        }
        let part = elapsed / self.duration;
        // Zero velocity at both ends.
        let eased = part * part * (3.0 - 2.0 * part);
        (between(&self.from, &self.to, eased), Some(Self { elapsed, ..self }))
    }
}

/// An intermediate pose: the camera rotates at constant speed about one axis, while the pivot moves
/// straight in the picture and its distance changes geometrically, so that nothing overshoots.
fn between(from: &Place, to: &Place, part: f64) -> Place {
    let pivot = from.pivot.lerp(to.pivot, part);
    let turn = turn_between(&from.view.rotation, &to.view.rotation);
    let rotation = rotation(turn * part) * from.view.rotation;
    let [first, last] = [from, to].map(|place| place.view.apply(place.pivot));
    let mut in_view = first.lerp(last, part);
    if first.z < 0.0 && last.z < 0.0 {
        in_view.z = -geometric(-first.z, -last.z, part);
    }
    let view = Rigid { rotation, translation: in_view - rotation * pivot };
    Place { view, pivot, scale: geometric(from.scale, to.scale, part) }
}

/// The shorter rotation from one orientation to another, as axis times angle.
fn turn_between(from: &DMat3, to: &DMat3) -> DVec3 {
    let turn = DQuat::from_mat3(&(*to * from.transpose()));
    let turn = if turn.w < 0.0 { -turn } else { turn };
    let sine = turn.xyz().length();
    if sine == 0.0 {
        return DVec3::ZERO;
    }
    turn.xyz() * (2.0 * libm::atan2(sine, turn.w) / sine)
}

/// Geometric interpolation of positive numbers.
fn geometric(from: f64, to: f64, part: f64) -> f64 {
    from * libm::exp(libm::log(to / from) * part)
}
