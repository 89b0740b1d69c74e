//! Another lens for a camera, with the picture in place.

use crate::window::{height_at, point_at};
use glam::{DMat4, DVec2, DVec3};
use luxel_scene::{Lens, Size};

/// The view matrix with which another lens shows the plane through `pivot`, parallel to the window,
/// as `before` showed it: the same part of it from bottom to top, in the same place. What lies before
/// or behind the plane is seen in the other perspective.
///
/// For [`Lens::Orthographic`] as `after`, take [`parallel_height`] as its height. The eye must be able
/// to see the pivot; if the pivot lies behind it, the plane as far before it is taken.
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
        // Height grows with depth.
        Lens::Perspective { .. } | Lens::Intrinsics { .. } => height / height_at(after, size, 1.0),
    };
    let middle = DVec2::new(f64::from(size.width), f64::from(size.height)) * 0.5;
    let shift = point_at(after, size, middle, new_depth) - point_at(before, size, middle, depth);
    DMat4::from_translation(shift) * *view_from_world
}

/// The height for parallel rays that show the plane through `pivot` as a lens shows it, in world
/// units.
#[must_use]
pub fn parallel_height(view_from_world: &DMat4, pivot: DVec3, lens: Lens, size: Size) -> f64 {
    height_at(lens, size, plane_depth(view_from_world, pivot))
}

fn plane_depth(view_from_world: &DMat4, pivot: DVec3) -> f64 {
    let in_view = view_from_world.transform_point3(pivot);
    if in_view.z == 0.0 { in_view.length().max(f64::MIN_POSITIVE) } else { in_view.z.abs() }
}
