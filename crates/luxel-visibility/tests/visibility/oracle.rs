//! The naive oracle: every triangle asked at every sample, in integers that cannot overflow.

use crate::scene::{Corner, DEPTHS, Scene, Submitted};
use luxel_visibility::{Coverage, CullFaces, PartUse};

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

/// A triangle that a sample lies in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub(crate) submitted: Submitted,
    pub(crate) coverage: Coverage,
    corners: [Corner; 3],
    depth: f64,
    tolerance: f64,
}

impl Hit {
    /// The corners' depths, weighted by the areas opposite to them: exact integers, divided once.
    fn new(
        submitted: Submitted,
        (corners, part): ([Corner; 3], PartUse),
        sample: [i32; 2],
    ) -> Self {
        let [a, b, c] = corners.map(Corner::position);
        let areas =
            [doubled_area(b, c, sample), doubled_area(c, a, sample), doubled_area(a, b, sample)];
        let weighted: i128 =
            areas.iter().zip(corners).map(|(area, corner)| area * i128::from(corner.z)).sum();
        let area = doubled_area(a, b, c);
        // The remainder apart: flat triangles have none, and so their depth without rounding.
        let fraction = (weighted % area) as f64 / area as f64;
        let depth = ((weighted / area) as f64 + fraction) / f64::from(DEPTHS);
        let tolerance = tolerance(corners, sample);
        Self { submitted, coverage: part.coverage, corners, depth, tolerance }
    }

    /// Whether a depth in f32 is that of this triangle: near the exact one, never beyond the corners.
    pub(crate) fn has(&self, depth: f32) -> bool {
        let depths = self.corners.map(Corner::depth);
        let within =
            depths.iter().any(|&low| low <= depth) && depths.iter().any(|&high| depth <= high);
        within && (f64::from(depth) - self.depth).abs() <= self.tolerance
    }

    /// Whether this is nearer than a depth of another triangle, whatever either's rounding.
    pub(crate) fn is_before(&self, depth: f32) -> bool {
        self.depth - self.tolerance > f64::from(depth)
    }

    /// Whether both have the same depth to the bit: of flat triangles or of repeated ones.
    pub(crate) fn ties_with(&self, other: &Self) -> bool {
        let are_exact = self.tolerance == 0.0 && other.tolerance == 0.0;
        self.corners == other.corners || are_exact && self.depth == other.depth
    }
}

/// How far a plane through three depths can be off at a sample in f32: both gradients are differences
/// of two products, divided by an area, and multiplied by a distance; each step rounds by half of 2^-23.
/// What cancels in the differences weighs in full. Flat triangles are exact.
fn tolerance(corners @ [a, b, c]: [Corner; 3], sample: [i32; 2]) -> f64 {
    let [low, high] = [corners.iter().map(|c| c.z).min(), corners.iter().map(|c| c.z).max()];
    let steps = |from: i32, to: i32| (f64::from(to) - f64::from(from)).abs();
    let (ab_z, ac_z) = ((b.depth() - a.depth()).abs(), (c.depth() - a.depth()).abs());
    let [ab_z, ac_z] = [ab_z, ac_z].map(f64::from);
    let area = doubled_area(a.position(), b.position(), c.position()).abs() as f64;
    let across = (ab_z * steps(a.y, c.y) + ac_z * steps(a.y, b.y)) * steps(a.x, sample[0]) / area;
    let down = (ac_z * steps(a.x, b.x) + ab_z * steps(a.x, c.x)) * steps(a.y, sample[1]) / area;
    if low == high { 0.0 } else { 8.0 * f64::from(f32::EPSILON / 2.0) * (across + down + 1.0) }
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

/// All triangles that a sample lies in.
pub(crate) fn hits(scene: &Scene, sample: [i32; 2]) -> Vec<Hit> {
    let mut hits = Vec::new();
    for (instance, placed) in scene.instances.iter().enumerate() {
        for (number, &(corners, part)) in (0..).zip(&placed.triangles) {
            if !is_culled(corners, part.cull) && covers(corners.map(Corner::position), sample) {
                hits.push(Hit::new((instance, number), (corners, part), sample));
            }
        }
    }
    hits
}

/// What is wrong with the triangle that an opaque picture shows at a sample: it must be one of those
/// that hold the sample, the nearest, and the first of equally near ones.
pub(crate) fn fault(seen: Option<(f32, Submitted)>, hits: &[Hit]) -> Option<String> {
    let Some((depth, submitted)) = seen else {
        return hits.first().map(|hit| format!("{hit:?} is not seen"));
    };
    let Some(hit) = hits.iter().find(|hit| hit.submitted == submitted) else {
        return Some(format!("{submitted:?} does not hold the sample"));
    };
    if !hit.has(depth) {
        return Some(format!("the depth {depth} of {hit:?}"));
    }
    let before = |other: &&Hit| {
        other.is_before(depth) || other.ties_with(hit) && other.submitted < submitted
    };
    hits.iter().find(before).map(|other| format!("{other:?} hides {hit:?}"))
}
