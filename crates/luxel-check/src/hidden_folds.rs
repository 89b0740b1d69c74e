//! Folds that vertex normals hide: faces turn, shading doesn't.

use crate::normals::facing;
use crate::surface::{EdgeKey, Edges, HalfEdge, Surface, half_edge_of};
use luxel_scene::DVec3;

/// Flatter folds may be intended as smooth, or be noise of a scan. At this angle each face is lit thirty
/// degrees off its own normal.
const LEAST_FOLD_DEGREES: f64 = 60.0;

/// The least fraction of a fold's angle that shading must show. On a smooth surface the average normals
/// of neighbours turn by as much as the faces.
const MIN_SHOWN_TURN: f64 = 0.25;

/// Edges between faces that turn while the averages of their vertex normals don't, in order.
pub(crate) fn hidden(
    surface: &Surface<'_>,
    edges: &Edges,
    normals: &[[DVec3; 3]],
    is_excluded: &[bool],
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
            && angle(shown, other_shown) < MIN_SHOWN_TURN * fold
    };
    let fold = |edge: &[EdgeKey]| {
        let &[first, second] = edge else { return None };
        let first = half_edge_of(first);
        let [one, other] = [first, half_edge_of(second)].map(|half_edge| (half_edge / 3) as usize);
        let is_included = !is_excluded[one] && !is_excluded[other];
        (is_included && is_hidden(one, other)).then_some(first)
    };
    edges.iter().filter_map(fold).collect()
}
