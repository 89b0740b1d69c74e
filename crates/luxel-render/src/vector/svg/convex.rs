//! Convex polygons in the window by their places alone: what they share, what is left of them.

use super::web::Place;
use crate::vector::primitives::twice_area;

/// Polygons that reach less than this into one another, in pixels, abut.
pub(super) const TOUCHING: f64 = 1e-6;

/// How far a place lies to the right of an edge, in pixels: inside of a polygon that runs clockwise
/// to the eye.
pub(super) fn inside([ax, ay]: Place, [bx, by]: Place, [x, y]: Place) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let length = (dx * dx + dy * dy).sqrt();
    (dx * (y - ay) - dy * (x - ax)) / length.max(f64::MIN_POSITIVE)
}

fn edges(polygon: &[Place]) -> impl Iterator<Item = (Place, Place)> + '_ {
    (0..polygon.len()).map(|at| (polygon[at], polygon[(at + 1) % polygon.len()]))
}

/// Whether two polygons share more than an edge.
pub(super) fn overlap(a: &[Place], b: &[Place]) -> bool {
    let apart = |a: &[Place], b: &[Place]| {
        edges(a).any(|(from, to)| b.iter().all(|&place| inside(from, to, place) <= TOUCHING))
    };
    !apart(a, b) && !apart(b, a)
}

/// The part of a polygon where a linear function of places is positive.
pub(super) fn half(polygon: &[Place], value: impl Fn(Place) -> f64, out: &mut Vec<Place>) {
    out.clear();
    for (here, next) in edges(polygon) {
        let (from, to) = (value(here), value(next));
        if from >= 0.0 {
            out.push(here);
        }
        if (from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0) {
            let t = from / (from - to);
            out.push([here[0] + (next[0] - here[0]) * t, here[1] + (next[1] - here[1]) * t]);
        }
    }
}

/// What two polygons share; empty if they only touch.
pub(super) fn shared(a: &[Place], b: &[Place]) -> Vec<Place> {
    let (mut left, mut cut) = (a.to_vec(), Vec::with_capacity(a.len() + b.len()));
    for (from, to) in edges(b) {
        half(&left, |place| inside(from, to, place), &mut cut);
        std::mem::swap(&mut left, &mut cut);
        if left.len() < 3 {
            return Vec::new();
        }
    }
    left
}

/// What is left of a polygon without another, in convex parts; parts without area are left out.
pub(super) fn without(polygon: &[Place], other: &[Place], parts: &mut Vec<Vec<Place>>) {
    if !overlap(polygon, other) {
        parts.push(polygon.to_vec());
        return;
    }
    let mut left = polygon.to_vec();
    let (mut outer, mut inner) = (Vec::new(), Vec::new());
    for (from, to) in edges(other) {
        half(&left, |place| -inside(from, to, place), &mut outer);
        if twice_area(outer.iter().copied()) > TOUCHING {
            parts.push(outer.clone());
        }
        half(&left, |place| inside(from, to, place), &mut inner);
        std::mem::swap(&mut left, &mut inner);
        if left.len() < 3 {
            return;
        }
    }
}

/// Left, top, right, bottom.
pub(super) fn bounds(places: impl Iterator<Item = Place>) -> [f64; 4] {
    let nothing = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    places.fold(nothing, |[left, top, right, bottom], [x, y]| {
        [left.min(x), top.min(y), right.max(x), bottom.max(y)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Place; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

    #[test]
    fn a_hole_leaves_four_parts_and_their_area() {
        let hole = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]];
        let mut parts = Vec::new();
        without(&SQUARE, &hole, &mut parts);
        let area: f64 = parts.iter().map(|part| twice_area(part.iter().copied())).sum();
        assert_eq!((parts.len(), area), (4, 30.0));
        assert_eq!(twice_area(shared(&SQUARE, &hole).into_iter()), 2.0);
    }

    #[test]
    fn neighbours_do_not_overlap() {
        let beside = SQUARE.map(|[x, y]| [x + 4.0, y]);
        assert!(!overlap(&SQUARE, &beside));
        assert!(overlap(&SQUARE, &beside.map(|[x, y]| [x - 1e-3, y])));
    }
}
