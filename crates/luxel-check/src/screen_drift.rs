//! The drift of attributes that are interpolated in screen space.

use crate::silhouette::MeshView;
use crate::surface::{RUN, Surface};
use luxel_parallel::gather;

/// Triangles over which attributes drift by at least so many pixels, with their drift.
///
/// On an edge between the depths z and r z, r >= 1, the point at the fraction s of the edge in the window
/// is at s / (s + (1 - s) r) of the edge in space, from the far end. The two differ most where they add
/// up to 1: by (sqrt r - 1) / (sqrt r + 1) of the edge's length in the window.
pub(crate) fn drifts(
    surface: &Surface<'_>,
    is_excluded: &[bool],
    view: &MeshView,
    least_pixels: f64,
) -> Vec<(u32, f64)> {
    let drift = |triangle: u32| {
        let corners = surface.corners(triangle).map(|corner| view.pixel_and_depth(corner));
        if view.is_beside_window(&corners) {
            return (triangle, 0.0);
        }
        let mut largest: f64 = 0.0;
        for k in 0..3 {
            let (Some((from, near)), Some((to, far))) = (corners[k], corners[(k + 1) % 3]) else {
                continue;
            };
            let root = (near / far).max(far / near).sqrt();
            largest = largest.max(from.distance(to) * (root - 1.0) / (root + 1.0));
        }
        (triangle, largest)
    };
    gather(surface.triangles.len(), RUN, &|run, found| {
        let kept = run.filter(|&triangle| !is_excluded[triangle]);
        let drifts = kept.map(|triangle| drift(triangle as u32));
        found.extend(drifts.filter(|(_, pixels)| *pixels >= least_pixels));
    })
}
