//! How far things slide that are interpolated in the window instead of in space.

use crate::silhouette::Sight;
use crate::surface::{RUN, Surface};
use luxel_parallel::gather;

/// Triangles over which things slide by at least so many pixels, with how far they do.
///
/// Along an edge between the depths z and r z, with r at least 1, what lies at the part s of the
/// window's way lies at s / (s + (1 - s) r) of the way in space, taken from the far end. The two
/// differ most where both add up to 1: by (sqrt r - 1) / (sqrt r + 1) of the edge's length in the
/// window.
pub(crate) fn drifts(
    surface: &Surface<'_>,
    is_left_out: &[bool],
    sight: &Sight,
    least_pixels: f64,
) -> Vec<(u32, f64)> {
    let drift = |triangle: u32| {
        let corners = surface.corners(triangle).map(|corner| sight.pixel_and_depth(corner));
        if sight.is_beside_window(&corners) {
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
        let kept = run.filter(|&triangle| !is_left_out[triangle]);
        let drifts = kept.map(|triangle| drift(triangle as u32));
        found.extend(drifts.filter(|(_, pixels)| *pixels >= least_pixels));
    })
}
