//! Clipping to the clip volume and the user's planes (OpenGL 1.5, section 2.11), in f64.
//!
//! Corners that are cut out carry the weights of the polygon's own corners, so that attributes are those of the
//! polygon itself.

use luxel_visibility::clip_by_plane;

/// A corner of a polygon that is being clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClipCorner {
    /// Clip coordinates.
    pub(crate) clip: [f64; 4],
    /// Weights of three corners of what is clipped.
    pub(crate) weights: [f64; 3],
    /// Whether it is a corner of its own that an unclipped neighbour may have: no side cuts it off then.
    pub(crate) held: bool,
    /// Whether it is a vertex rather than a point where an edge leaves.
    pub(crate) own: bool,
    /// Whether the edge from it to the next corner is a part of the border.
    pub(crate) border: bool,
    /// Its number among the corners, and that of the next one.
    order: [usize; 2],
}

impl ClipCorner {
    pub(crate) fn new(clip: [f32; 4], corner: usize, held: bool) -> Self {
        let mut weights = [0.0; 3];
        weights[corner] = 1.0;
        let clip = clip.map(f64::from);
        Self { clip, weights, held, own: true, border: true, order: [0; 2] }
    }
}

/// What clipping can cut between.
pub(crate) trait Cut: Copy {
    /// inside + (outside - inside) t
    fn between(inside: &Self, outside: &Self, t: f64) -> Self;

    /// Says which of so many corners it is, for those that mark where a polygon leaves.
    fn set_order(&mut self, _number: usize, _count: usize) {}
}

impl Cut for ClipCorner {
    fn between(inside: &Self, outside: &Self, t: f64) -> Self {
        let mix = |inside: f64, outside: f64| inside + (outside - inside) * t;
        // Where the polygon leaves, an edge of the border begins; where it comes back, an edge goes on (section 2.11).
        let leaves = inside.order[1] == outside.order[0];
        let border = leaves || outside.border;
        let mut cut = Self { held: false, own: false, border, ..*inside };
        for (value, other) in cut.clip.iter_mut().zip(outside.clip) {
            *value = mix(*value, other);
        }
        for (weight, other) in cut.weights.iter_mut().zip(outside.weights) {
            *weight = mix(*weight, other);
        }
        cut
    }

    fn set_order(&mut self, number: usize, count: usize) {
        self.order = [number, (number + 1) % count];
    }
}

/// plane . corner
pub(crate) fn plane_distances(plane: &[f64; 4], corner: &ClipCorner) -> f64 {
    let [a, b, c, d] = plane;
    let [x, y, z, w] = corner.clip;
    a * x + b * y + c * z + d * w
}

/// Clips a convex polygon by planes, which are given by distances that aren't negative inside.
pub(crate) fn clip_polygon<C: Cut, P>(
    polygon: &mut Vec<C>,
    planes: &[P],
    distance: impl Fn(&P, &C) -> f64,
) {
    let mut distances = Vec::new();
    for plane in planes {
        distances.clear();
        distances.extend(polygon.iter().map(|corner| distance(plane, corner)));
        if distances.iter().all(|distance| *distance >= 0.0) {
            continue;
        }
        let mut source = std::mem::take(polygon);
        let count = source.len();
        for (number, corner) in source.iter_mut().enumerate() {
            corner.set_order(number, count);
        }
        clip_by_plane(&source, &distances, C::between, &mut |corner| polygon.push(corner));
    }
}

/// Clips a line by planes; `None` if nothing is left.
pub(crate) fn clip_segment<C: Cut, P>(
    ends: [C; 2],
    planes: &[P],
    distance: impl Fn(&P, &C) -> f64,
) -> Option<[C; 2]> {
    let [mut from, mut to] = ends;
    for plane in planes {
        let (a, b) = (distance(plane, &from), distance(plane, &to));
        match (a >= 0.0, b >= 0.0) {
            (true, true) => {}
            (true, false) => to = C::between(&from, &to, a / (a - b)),
            (false, true) => from = C::between(&to, &from, b / (b - a)),
            (false, false) => return None,
        }
    }
    Some([from, to])
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEAR: [f64; 4] = [0.0, 0.0, 1.0, 1.0];

    #[test]
    fn section_2_11_edges_along_a_plane_are_border_and_others_stay_what_they_were() {
        let corner = |z: f32, number, border| ClipCorner {
            border,
            ..ClipCorner::new([0.0, 0.0, z, 1.0], number, false)
        };
        for (before, after) in [
            ([true, false, true], [true, true, false, true]),
            ([false, true, false], [false, true, true, false]),
        ] {
            let mut polygon: Vec<_> = [0.0, -2.0, 0.0]
                .into_iter()
                .zip(before)
                .enumerate()
                .map(|(number, (z, border))| corner(z, number, border))
                .collect();
            clip_polygon(&mut polygon, &[NEAR], plane_distances);
            let border: Vec<_> = polygon.iter().map(|corner| corner.border).collect();
            assert_eq!(border, after);
        }
    }

    #[test]
    fn section_2_11_what_is_cut_out_carries_the_weights_of_its_corners() {
        let corner = |z: f32, number| ClipCorner::new([0.0, 0.0, z, 1.0], number, false);
        let mut polygon = vec![corner(0.0, 0), corner(-2.0, 1), corner(0.0, 2)];
        clip_polygon(&mut polygon, &[NEAR], plane_distances);
        let weights: Vec<_> = polygon.iter().map(|corner| corner.weights).collect();
        let half = [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.0, 0.0, 1.0]];
        assert_eq!(weights, half);
        let line = clip_segment([corner(-2.0, 0), corner(0.0, 1)], &[NEAR], plane_distances);
        assert_eq!(line.unwrap()[0].weights, [0.5, 0.5, 0.0]);
        let behind = clip_segment([corner(-2.0, 0), corner(-3.0, 1)], &[NEAR], plane_distances);
        assert_eq!(behind, None);
    }
}
