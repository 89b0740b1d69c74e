//! Changes of the lens that keep the picture in place.

use crate::window::{height_at, point_at};
use glam::{DMat4, DVec2, DVec3};
use luxel_scene::{Lens, Size};

/// The view matrix with which lens `after` shows the plane through `pivot`, parallel to the window, as
/// `before` does: the same height at the same position. Points off the plane change with the
/// perspective.
///
/// For [`Lens::Orthographic`] as `after`, use [`parallel_height`] as its height. The pivot should be
/// visible; if it lies behind the eye, its mirrored depth is used.
#[must_use]
pub fn with_lens(
    view_from_world: &DMat4,
    pivot: DVec3,
    before: Lens,
    after: Lens,
    size: Size,
) -> DMat4 {
    let depth = plane_depth(view_from_world, pivot);
    let height = height_at(before, size, depth);
    let new_depth = match after {
        Lens::Orthographic { .. } => depth,
        // The height is proportional to the depth.
        Lens::Perspective { .. } | Lens::Intrinsics { .. } => height / height_at(after, size, 1.0),
    };
    let middle = DVec2::new(f64::from(size.width), f64::from(size.height)) * 0.5;
    let shift = point_at(after, size, middle, new_depth) - point_at(before, size, middle, depth);
    DMat4::from_translation(shift) * *view_from_world
}

/// The orthographic height that shows the plane through `pivot` as a lens does, in world units.
#[must_use]
pub fn parallel_height(view_from_world: &DMat4, pivot: DVec3, lens: Lens, size: Size) -> f64 {
    height_at(lens, size, plane_depth(view_from_world, pivot))
}

fn plane_depth(view_from_world: &DMat4, pivot: DVec3) -> f64 {
    let in_view = view_from_world.transform_point3(pivot);
    if in_view.z == 0.0 { in_view.length().max(f64::MIN_POSITIVE) } else { in_view.z.abs() }
}
