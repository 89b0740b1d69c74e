//! An axes gizmo: six knobs for the standard views.

use crate::event::StandardView;
use crate::window::upwards;
use glam::{DMat3, DMat4, DVec2, DVec3};

/// A knob at one end of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knob {
    /// The axis in world space: +X, -X, +Y, ...
    pub axis: DVec3,
    /// The standard view from that side.
    pub view: StandardView,
    /// The position in the window.
    pub at: DVec2,
    /// The component towards the eye, from -1 to 1.
    pub towards: f64,
}

/// The six knobs in drawing order, farthest first: the world's axes around `centre` in the window,
/// `radius` pixels long, in orthographic projection.
#[must_use]
pub fn knobs(view_from_world: &DMat4, up: DVec3, centre: DVec2, radius: f64) -> [Knob; 6] {
    let rotation = DMat3::from_mat4(*view_from_world);
    let mut knobs = [
        StandardView::Front,
        StandardView::Back,
        StandardView::Right,
        StandardView::Left,
        StandardView::Top,
        StandardView::Bottom,
    ]
    .map(|view| {
        let [_, _, axis] = view.axes(up);
        let in_view = rotation * axis;
        let at = centre + upwards(in_view.truncate()) * radius;
        Knob { axis, view, at, towards: in_view.z }
    });
    knobs.sort_by(|a, b| a.towards.total_cmp(&b.towards));
    knobs
}

/// The knob under the pointer, if any: of several within `knob_radius` pixels, the nearest to the eye.
#[must_use]
pub fn hit(knobs: &[Knob; 6], at: DVec2, knob_radius: f64) -> Option<Knob> {
    knobs.iter().rev().find(|knob| knob.at.distance(at) <= knob_radius).copied()
}
