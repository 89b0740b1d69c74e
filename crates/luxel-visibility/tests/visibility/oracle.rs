//! The naive oracle: every triangle asked at every sample, in integers that cannot overflow.

use crate::scene::{Corner, Scene, Submitted};
use luxel_visibility::{Coverage, CullFaces};

/// Twice the signed area of (p, q, r), positive where they run clockwise in the window.
pub(crate) fn doubled_area(p: [i32; 2], q: [i32; 2], r: [i32; 2]) -> i128 {
    let across = |p: [i32; 2], q: [i32; 2], axis: usize| i128::from(q[axis]) - i128::from(p[axis]);
    across(p, q, 0) * across(p, r, 1) - across(p, q, 1) * across(p, r, 0)
}

/// Whether a triangle holds a sample.
///
/// The top-left rule says: what lies on an edge counts as if it were moved a little to the right,
/// and, where that doesn't decide, far less down. So the edge function's value is followed by its
/// change to the right and its change downwards, and the first that isn't 0 decides.
pub(crate) fn covers(corners: [[i32; 2]; 3], sample: [i32; 2]) -> bool {
    let [a, mut b, mut c] = corners;
    let area = doubled_area(a, b, c);
    if area == 0 {
        return false;
    }
    if area < 0 {
        std::mem::swap(&mut b, &mut c);
    }
    [(a, b), (b, c), (c, a)].into_iter().all(|(p, q)| {
        let value = doubled_area(p, q, sample);
        let to_the_right = -(i128::from(q[1]) - i128::from(p[1]));
        let downwards = i128::from(q[0]) - i128::from(p[0]);
        (value, to_the_right, downwards) > (0, 0, 0)
    })
}

/// The depth of a sample: the corners' plane in f32, kept within the corners' range.
pub(crate) fn depth([a, b, c]: [Corner; 3], sample: [i32; 2]) -> f32 {
    let area = doubled_area(a.position(), b.position(), c.position()) as f32;
    let steps = |from: i32, to: i32| (to - from) as f32;
    let (ab_x, ab_y, ab_z) = (steps(a.x, b.x), steps(a.y, b.y), b.depth() - a.depth());
    let (ac_x, ac_y, ac_z) = (steps(a.x, c.x), steps(a.y, c.y), c.depth() - a.depth());
    let across = (ab_z * ac_y - ac_z * ab_y) / area;
    let down = (ac_z * ab_x - ab_z * ac_x) / area;
    let z = steps(a.x, sample[0]) * across + a.depth() + steps(a.y, sample[1]) * down;
    let low = a.depth().min(b.depth()).min(c.depth());
    let high = a.depth().max(b.depth()).max(c.depth());
    z.max(low).min(high)
}

/// Whether the faces that are left out include this triangle.
fn is_culled(corners: [Corner; 3], cull: CullFaces) -> bool {
    let [a, b, c] = corners.map(Corner::position);
    let area = doubled_area(a, b, c);
    match cull {
        CullFaces::None => area == 0,
        CullFaces::Clockwise => area >= 0,
        CullFaces::CounterClockwise => area <= 0,
    }
}

/// All triangles that a sample lies in, with their depths: nearest first, equally near ones in the
/// order of submission.
pub(crate) fn hits(
    scene: &Scene,
    sample: [i32; 2],
    wanted: impl Fn(Coverage) -> bool,
) -> Vec<(f32, Submitted)> {
    let mut hits = Vec::new();
    for (instance, placed) in scene.instances.iter().enumerate() {
        for (number, (corners, part)) in (0..).zip(&placed.triangles) {
            if wanted(part.coverage)
                && !is_culled(*corners, part.cull)
                && covers(corners.map(Corner::position), sample)
            {
                hits.push((depth(*corners, sample), (instance, number)));
            }
        }
    }
    hits.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    hits
}

/// The triangle that an opaque picture shows at a sample.
pub(crate) fn winner(scene: &Scene, sample: [i32; 2]) -> Option<(f32, Submitted)> {
    hits(scene, sample, |coverage| coverage != Coverage::Blended).first().copied()
}
