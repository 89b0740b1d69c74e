//! Folds that vertex normals hide: the faces turn, their shading doesn't.

use crate::normals::facing;
use crate::surface::{Edges, HalfEdge, Side, Surface, half_edge_of};
use luxel_scene::DVec3;

/// Flatter folds than this may well be meant to look smooth, or be the noise of a scan: here each
/// face is lit thirty degrees beside its own normal.
const LEAST_FOLD_DEGREES: f64 = 60.0;

/// The part of a fold's angle that shading shows at least where it shows a fold. On a smooth surface
/// the averages of two neighbours' normals turn by as much as the faces do.
const SHOWN: f64 = 0.25;

/// Edges between two faces that turn there while the averages of their normals don't, in order of
/// their places.
pub(crate) fn hidden(
    surface: &Surface<'_>,
    edges: &Edges,
    normals: &[[DVec3; 3]],
    is_left_out: &[bool],
) -> Vec<HalfEdge> {
    let angle = |one: DVec3, other: DVec3| libm::acos(one.dot(other).clamp(-1.0, 1.0));
    let is_hidden = |first: usize, second: usize| {
        let of = |triangle: usize| {
            let average = normals[triangle].iter().sum::<DVec3>().normalize_or_zero();
            (facing(surface, normals, triangle), average)
        };
        let ((face, shown), (other_face, other_shown)) = (of(first), of(second));
        let known = [face, shown, other_face, other_shown];
        let fold = angle(face, other_face);
        !known.contains(&DVec3::ZERO)
            && fold >= LEAST_FOLD_DEGREES.to_radians()
            && angle(shown, other_shown) < SHOWN * fold
    };
    let fold = |edge: &[Side]| {
        let &[first, second] = edge else { return None };
        let first = half_edge_of(first);
        let [one, other] = [first, half_edge_of(second)].map(|half_edge| (half_edge / 3) as usize);
        let is_asked = !is_left_out[one] && !is_left_out[other];
        (is_asked && is_hidden(one, other)).then_some(first)
    };
    edges.iter().filter_map(fold).collect()
}
