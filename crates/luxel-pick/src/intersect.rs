//! Rays and triangles, watertight (Woop, Benthin and Wald 2013).
//!
//! Corners are seen from the ray's origin and sheared so that the ray runs along the axis of its
//! largest component; what is left is whether the origin lies inside a triangle of the plane. An
//! edge function of `f32` never has the wrong sign, it can only become 0: then, and only then, it
//! is computed again in `f64`, where products are exact, as is the sign of their difference. So
//! triangles that share an edge agree on which side of it a ray passes, and a closed mesh is never
//! passed through.
//!
//! A ray exactly through an edge or a corner meets all triangles there. The distance is then taken
//! from the edge alone, whichever triangle it belongs to, so that all have the same one, and the
//! triangle of the lowest number wins.

use crate::bvh::{Block, Head, Rows, WIDTH, triangle_words};
use crate::gather::{Gathered, eight, places};
use crate::row::{Row, ShearedRows, load};
use luxel_math::{LANES, Simd, f32x8, mask32x8, permuted, prelude::*};

/// A ray: every place `origin + t direction` with t from `range`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Ray {
    /// Where t is 0.
    pub origin: [f32; 3],
    /// Where it goes, of any length but 0; t counts in this length.
    pub direction: [f32; 3],
    /// The least t, not below 0, and the greatest, which may be infinite.
    pub range: [f32; 2],
}

impl Ray {
    /// A ray that has no end.
    #[must_use]
    pub const fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        Self { origin, direction, range: [0.0, f32::INFINITY] }
    }

    /// Whether it is a ray at all: finite, with a direction that isn't 0 and a range above 0.
    #[must_use]
    #[inline]
    pub fn is_sound(&self) -> bool {
        let finite = |values: &[f32; 3]| values.iter().all(|value| value.is_finite());
        finite(&self.origin)
            && finite(&self.direction)
            && self.direction != [0.0; 3]
            && self.has_range()
    }

    /// Whether its range is one, above 0.
    #[inline(always)]
    pub(crate) fn has_range(&self) -> bool {
        let [nearest, farthest] = self.range;
        nearest >= 0.0 && farthest >= nearest
    }
}

/// Directions between these lengths are used as they are.
pub(crate) const USUAL_LENGTHS: std::ops::Range<f32> = 1e-9..1e9;

impl Ray {
    /// Whether its direction has a length to be used as it is.
    #[inline(always)]
    pub(crate) fn is_usual(&self) -> bool {
        let [x, y, z] = self.direction.map(f32::abs);
        USUAL_LENGTHS.contains(&x.max(y).max(z))
    }

    /// The same ray with a direction of about 1, and what its t must be multiplied with: a power of
    /// two, so that nothing is rounded. Very short and very long directions would leave the range of
    /// f32 on the way. For sound rays.
    #[inline(always)]
    pub(crate) fn scaled(&self) -> (Self, f32) {
        let [x, y, z] = self.direction.map(f32::abs);
        let longest = x.max(y).max(z);
        if USUAL_LENGTHS.contains(&longest) { (*self, 1.0) } else { self.rescaled(longest) }
    }

    #[cold]
    #[inline(never)]
    fn rescaled(&self, longest: f32) -> (Self, f32) {
        let mut ray = *self;
        let (mut scale, mut longest) = (1.0_f32, longest);
        // Steps of 2^24: a factor for all could itself be out of range.
        const STEP: f32 = 16_777_216.0;
        // A few steps bring any finite length but 0 into range.
        for _ in 0..8 {
            if USUAL_LENGTHS.contains(&longest) {
                break;
            }
            let factor = if longest < 1.0 { STEP } else { 1.0 / STEP };
            ray.direction = ray.direction.map(|component| component * factor);
            ray.range = ray.range.map(|t| t / factor);
            (scale, longest) = (scale * factor, longest * factor);
        }
        (ray, scale)
    }
}

/// A ray turned and sheared for triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sheared {
    /// The axis of the largest component of the direction, and that component's sign.
    pub(crate) last: usize,
    pub(crate) is_negative: bool,
    /// In the order of [`axes`], as is the shear.
    pub(crate) origin: [f32; 3],
    pub(crate) shear: [f32; 3],
}

/// The nearest hit so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Nearest {
    pub(crate) t: f32,
    /// The triangle's number; the highest of all where nothing was hit.
    pub(crate) triangle: u32,
    /// Where its block begins, and its place there.
    pub(crate) block: u32,
    pub(crate) lane: u32,
}

impl Nearest {
    pub(crate) const fn before(t: f32) -> Self {
        Self { t, triangle: u32::MAX, block: 0, lane: 0 }
    }
}

/// The axis of the largest component.
#[inline(always)]
pub(crate) fn longest_axis(direction: &[f32; 3]) -> usize {
    let [x, y, z] = [direction[0].abs(), direction[1].abs(), direction[2].abs()];
    if x > y && x > z { 0 } else { 1 + usize::from(z >= y) }
}

/// The order of axes with the longest last, so that the handedness stays.
#[inline(always)]
pub(crate) fn axes(longest: usize) -> [usize; 3] {
    match longest {
        0 => [1, 2, 0],
        1 => [2, 0, 1],
        _ => [0, 1, 2],
    }
}

impl Sheared {
    pub(crate) fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        let [x, y, z] = direction.map(|along| 1.0 / along);
        Self::with_inverse(&origin, &direction, &[x, y, z, 0.0])
    }

    /// The same, with one over each component of the direction at hand.
    #[inline(always)]
    pub(crate) fn with_inverse(
        origin: &[f32; 3],
        direction: &[f32; 3],
        inverse: &[f32; 4],
    ) -> Self {
        let last = longest_axis(direction);
        let [x, y, z] = axes(last);
        let inverse = inverse[z];
        Self {
            last,
            is_negative: inverse < 0.0,
            origin: [origin[x], origin[y], origin[z]],
            shear: [direction[x] * inverse, direction[y] * inverse, inverse],
        }
    }

    /// Three corners, in the order of its axes, as the ray sees them.
    #[inline(always)]
    fn corners(&self, corners: [[f32; 3]; 3]) -> [[f32; 3]; 3] {
        let [ox, oy, oz] = self.origin;
        let [sx, sy, sz] = self.shear;
        let mut seen = [[0.0; 3]; 3];
        for (seen, [x, y, z]) in seen.iter_mut().zip(corners) {
            let along = z - oz;
            *seen = [x - ox - sx * along, y - oy - sy * along, sz * along];
        }
        seen
    }

    /// The weights of a triangle's corners, in the order of the ray's axes, where the ray meets it, in
    /// `f64`.
    #[inline(always)]
    pub(crate) fn barycentric(&self, corners: [[f32; 3]; 3]) -> [f32; 3] {
        let weights = edges(&self.corners(corners));
        let sum = weights[0] + weights[1] + weights[2];
        weights.map(|weight| (weight / sum) as f32)
    }
}

/// The three edge functions, signs exact.
#[inline(always)]
fn edges(corners: &[[f32; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = corners.map(|[x, y, _]| [f64::from(x), f64::from(y)]);
    [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]]
}

/// The distance for a ray through an edge or a corner, if it meets the triangle at all.
fn on_edge(corners: [[f32; 3]; 3]) -> Option<f32> {
    let weights = edges(&corners);
    let negative = weights.iter().any(|weight| *weight < 0.0);
    let positive = weights.iter().any(|weight| *weight > 0.0);
    let sum = weights[0] + weights[1] + weights[2];
    if negative && positive || sum == 0.0 {
        return None;
    }
    let corners = corners.map(|corner| corner.map(f64::from));
    let mut zeros = (0..3).filter(|&corner| weights[corner] == 0.0);
    let t = match (zeros.next(), zeros.next()) {
        // Through a corner: the one whose weight is left.
        (Some(i), Some(j)) => corners[3 - i - j][2],
        // Through an edge, taken the same way round whichever triangle it belongs to.
        (Some(opposite), None) => {
            let [mut p, mut q] = [corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]];
            if p > q {
                (p, q) = (q, p);
            }
            let axis = usize::from((q[1] - p[1]).abs() > (q[0] - p[0]).abs());
            p[2] + (q[2] - p[2]) * (-p[axis] / (q[axis] - p[axis]))
        }
        _ => {
            let [u, v, w] = weights;
            (u * corners[0][2] + v * corners[1][2] + w * corners[2][2]) / sum
        }
    };
    Some(t as f32)
}

/// [`on_edge`] for those of several pairs whose bit is set in `asked`; all hits.
#[cold]
#[inline(never)]
fn on_edges(
    corners: &[[[f32; LANES]; 3]; 3],
    range: &[[f32; LANES]; 2],
    mut asked: u32,
    distances: &mut [f32; LANES],
    mut hits: u32,
) -> u32 {
    while asked != 0 {
        let lane = asked.trailing_zeros() as usize & (LANES - 1);
        asked &= asked - 1;
        hits &= !(1 << lane);
        if let Some(t) = on_edge(corners.map(|corner| corner.map(|row| row[lane])))
            && range[0][lane] <= t
            && t <= range[1][lane]
        {
            distances[lane] = t;
            hits |= 1 << lane;
        }
    }
    hits
}

/// Pairs of a ray and a triangle, lane by lane: x, y and z of each corner as the ray sees it.
type Seen<N> = [[N; 3]; 3];

/// The distances at which a ray meets a block's triangles, and a bit for each that it meets from
/// `range[0]` to `range[1]`.
#[inline(always)]
pub(crate) fn meet_block<S: Simd>(
    simd: S,
    block: &Block,
    positions: &[[f32; 3]],
    ray: &Sheared,
    range: [f32; 2],
) -> ([f32; WIDTH], u32) {
    let head = Head::of(block);
    let [kx, ky, kz] = axes(ray.last);
    let zero = f32x8::splat(simd, 0.0);
    let mut corners: Seen<f32x8<S>> = [[zero; 3]; 3];
    match head.rows() {
        Rows::Shared => {
            // Each vertex once, however many triangles it has.
            let [x, y, z] = seen_rows(simd, block, [kx, ky, kz], ray);
            let words = triangle_words(simd, block);
            for (corner, at) in [words, words >> 3, words >> 6].into_iter().enumerate() {
                corners[0][corner] = permuted(simd, x, at);
                corners[1][corner] = permuted(simd, y, at);
                corners[2][corner] = permuted(simd, z, at);
            }
        }
        Rows::Apart => {
            for corner in 0..3 {
                let rows = [3 * corner + kx, 3 * corner + ky, 3 * corner + kz];
                let [x, y, z] = seen_rows(simd, block, rows, ray);
                (corners[0][corner], corners[1][corner], corners[2][corner]) = (x, y, z);
            }
        }
        Rows::Numbers => {
            let is_x = mask32x8::splat(simd, ray.last == 0);
            let chosen = [is_x, mask32x8::splat(simd, ray.last == 1)];
            for corner in 0..3 {
                let [x, y, z] = see(simd, block, corner, positions, ray, chosen);
                (corners[0][corner], corners[1][corner], corners[2][corner]) = (x, y, z);
            }
        }
    }
    let range = range.map(|t| f32x8::splat(simd, t));
    let mut distances = [0.0; WIDTH];
    let (t, hits) = meet_seen(&corners, ray.is_negative, range, (1 << head.count()) - 1);
    t.store_slice(&mut distances);
    (distances, hits)
}

/// Rows of a block as a ray sees them, in the order of its axes.
#[inline(always)]
fn seen_rows<S: Simd>(
    simd: S,
    block: &Block,
    [x, y, z]: [usize; 3],
    ray: &Sheared,
) -> [f32x8<S>; 3] {
    seen(places(simd, block, x), places(simd, block, y), places(simd, block, z), ray)
}

/// A corner of a block's triangles as a ray sees it, where the block has vertices' numbers.
#[inline(always)]
fn see<S: Simd>(
    simd: S,
    block: &Block,
    corner: usize,
    positions: &[[f32; 3]],
    ray: &Sheared,
    [is_x, is_y]: [mask32x8<S>; 2],
) -> [f32x8<S>; 3] {
    let [x, y, z] = eight(simd, block, corner, positions);
    let first = is_x.select(y, is_y.select(z, x));
    let second = is_x.select(z, is_y.select(x, y));
    let last = is_x.select(x, is_y.select(y, z));
    seen(first, second, last, ray)
}

#[inline(always)]
fn seen<S: Simd>(
    first: f32x8<S>,
    second: f32x8<S>,
    last: f32x8<S>,
    ray: &Sheared,
) -> [f32x8<S>; 3] {
    let along = last - ray.origin[2];
    [
        first - ray.origin[0] - along * ray.shear[0],
        second - ray.origin[1] - along * ray.shear[1],
        along * ray.shear[2],
    ]
}

/// The same for triangles whose vertices are there already.
#[inline(always)]
pub(crate) fn meet_gathered<S: Simd>(
    simd: S,
    gathered: &Gathered,
    count: usize,
    ray: &Sheared,
    range: [f32; 2],
) -> ([f32; WIDTH], u32) {
    let [kx, ky, kz] = axes(ray.last);
    let [x, y, z] = [&gathered[kx & 3], &gathered[ky & 3], &gathered[kz & 3]];
    let mut corners: Seen<f32x8<S>> = [[f32x8::splat(simd, 0.0); 3]; 3];
    for corner in 0..3 {
        let row = |rows: &[[f32; WIDTH]; 3]| f32x8::simd_from(simd, rows[corner]);
        let [x, y, z] = seen(row(x), row(y), row(z), ray);
        (corners[0][corner], corners[1][corner], corners[2][corner]) = (x, y, z);
    }
    let range = range.map(|t| f32x8::splat(simd, t));
    let mut distances = [0.0; WIDTH];
    let (t, hits) = meet_seen(&corners, ray.is_negative, range, (1 << count) - 1);
    t.store_slice(&mut distances);
    (distances, hits)
}

/// The distances at which a group of rays meets a triangle, and a bit for each of the `asked` that
/// meets it within its range. Corners and rays are in the order of the rays' axes.
#[inline(always)]
pub(crate) fn meet_rays<N: Number>(
    like: N,
    corners: [[f32; 3]; 3],
    (rays, group): (&ShearedRows, usize),
    is_negative: bool,
    range: [&Row; 2],
    asked: u32,
) -> (N, u32) {
    let [x, y, z] = [0, 1, 2].map(|axis: usize| load(like, &rays.origin[axis], group));
    let shear = [0, 1, 2].map(|axis: usize| load(like, &rays.shear[axis], group));
    let mut seen: Seen<N> = [[like; 3]; 3];
    for corner in 0..3 {
        let at = corners[corner].map(|place| like.constant(place));
        let along = at[2] - z;
        seen[0][corner] = at[0] - x - along * shear[0];
        seen[1][corner] = at[1] - y - along * shear[1];
        seen[2][corner] = along * shear[2];
    }
    meet_seen(&seen, is_negative, range.map(|row| load(like, row, group)), asked)
}

/// Where the origins lie within the triangles, and how far along.
#[inline(always)]
fn meet_seen<N: Number>(
    [x, y, z]: &Seen<N>,
    is_negative: bool,
    range: [N; 2],
    counted: u32,
) -> (N, u32) {
    let u = x[2] * y[1] - y[2] * x[1];
    let v = x[0] * y[2] - y[0] * x[2];
    let w = x[1] * y[0] - y[1] * x[0];
    let zero = u.zero();
    let negative = u.less(zero) | v.less(zero) | w.less(zero);
    let positive = zero.less(u) | zero.less(v) | zero.less(w);
    let candidates = !(negative & positive);
    let counted = candidates.bits() & counted;
    if counted == 0 {
        return (zero, 0);
    }
    let unknown = u.equal(zero) | v.equal(zero) | w.equal(zero);
    let sum = u + v + w;
    let mut t = (u * z[0] + v * z[1] + w * z[2]) / sum;
    let within = range[0].less_or_equal(t) & t.less_or_equal(range[1]);
    let unknown = unknown.bits() & counted;
    let mut hits = within.bits() & counted & !unknown;
    if unknown != 0 {
        // Stored here alone: all else stays in registers.
        let mut corners = [[[0.0; LANES]; 3]; 3];
        let (mut ends, mut distances) = ([[0.0; LANES]; 2], [0.0; LANES]);
        for corner in 0..3 {
            // In this order ends of edges are compared: that of one winding, as the ray sees it.
            x[corner].store(&mut corners[corner][usize::from(is_negative)], 0);
            y[corner].store(&mut corners[corner][usize::from(!is_negative)], 0);
            z[corner].store(&mut corners[corner][2], 0);
        }
        range[0].store(&mut ends[0], 0);
        range[1].store(&mut ends[1], 0);
        t.store(&mut distances, 0);
        hits = on_edges(&corners, &ends, unknown, &mut distances, hits);
        t = t.load(&distances, 0);
    }
    (t, hits)
}
