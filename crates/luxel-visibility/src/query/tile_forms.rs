//! Barycentrics in f32: linear forms about the triangle's first corner, kept within one tile.
//!
//! The weight of corner i is w_i(X, Y) = a_i (X - X_0) + b_i (Y - Y_0) + c_i with b_i(X, Y) =
//! max(w_i, 0) / sum_k max(w_k, 0) the barycentrics. (X_0, Y_0), the *anchor*, is where the first
//! corner lies in the window, brought into the tile. Constants are made in f64 by [`Forms`] and rounded
//! once; the weights are evaluated in f32.
//!
//! Why about a corner: f32 forms over the whole window lose triangles of a hundredth of a pixel, as
//! the products cancel to a ten-thousandth of themselves. About the corner nothing cancels that is
//! larger than the triangle's own extent. Why within the tile: X - X_0 is then at most 64 and an
//! exact difference but for the anchor's own rounding, which is kept beside it.
//!
//! **Error bound.** Constants are scaled so that S = sum_i (|a_i| U + |b_i| V + |c_i|) = 1, where U and
//! V are the extents from the anchor of the part of the triangle in the tile. Each weight is two
//! products and two sums of terms that are within S and rounded once before: its error is below
//! 5 u S_i with u = 2^-24 and S_i its share of S. With s the sum of weights at the sample, the error of
//! a barycentric is below 10 u / s. s is about 1/7 for a compact triangle that faces the eye and falls
//! with the cosine between its plane and the ray. Where s < 1/512, a cosine of about 1/70 (or a
//! sliver as thin), [`Forms::exact_barycentric`] answers in f64 instead: the choice depends on triangle,
//! tile and sample alone. Constants made of f32 differences add errors of the
//! same kind. Worst of random triangles of 0.01 to 10 000 pixels (`tests/visibility/tile_forms.rs`): 3e-7
//! facing the eye, 1.2e-6 at a cosine of 0.1, 2.4e-6 at 0.05, 6e-6 at 0.02.

use super::barycentric::Forms;
use super::instance_transform::sides;
use super::window_rays::WindowRays;
use crate::types::TILE;
use luxel_math::{F64Lanes, Lanes, Mask, SUBPIXELS, Vec3};

/// How many numbers a [`TileForms`] is.
pub const TILE_FORMS: usize = 13;

/// Below this sum of weights f32 would tell less of the triangle than f64: see the error bound.
const LEAST_SUM: f32 = 1.0 / 512.0;

/// The weights of a triangle's corners as linear forms about its anchor, of one triangle or of one
/// for each lane.
#[derive(Clone, Copy, Debug)]
pub struct TileForms<N> {
    /// The anchor in pixels from the tile's first: a multiple of 1/256, and what is left.
    anchor: [N; 2],
    rest: [N; 2],
    a: [N; 3],
    b: [N; 3],
    c: [N; 3],
}

/// Barycentrics at a sample, and where f32 can't give them.
pub struct Barycentrics<N: Lanes> {
    /// The weights of the three corners: not negative, with the sum 1.
    pub weights: [N; 3],
    /// Where [`Forms::exact_barycentric`] has to answer.
    pub inexact: N::Mask,
}

impl<N: Lanes> TileForms<N> {
    /// The forms of a triangle within the tile whose first pixel is `tile`; `corners` are in view space,
    /// `sides` and `towards_eye` are [`sides`](crate::sides) and [`WindowRays::towards_eye`] of them.
    #[inline(always)]
    #[must_use]
    pub fn new(
        rays: &WindowRays,
        corners: &[[N::F64; 3]; 3],
        sides: [Vec3<N>; 2],
        towards_eye: N::F64,
        tile: [i32; 2],
    ) -> Self {
        let [tile_x, tile_y] = tile;
        let [x, y, depth] = rays.window_lanes(corners[0]);
        let (x, y) = (x - x.constant(tile_x.into()), y - y.constant(tile_y.into()));
        let anchor: Anchor<N> = Anchor::new(x, y);
        let simd = anchor.x;
        let (low, high) = (simd.zero(), simd.constant(TILE as f32));
        let (x, y) = (x.to_f32(), y.to_f32());
        let inside = low.less_or_equal(x)
            & x.less_or_equal(high)
            & low.less_or_equal(y)
            & y.less_or_equal(high)
            & depth.is_positive();
        // Weights are positive inside, whichever side is seen.
        let sign = simd.one().select((-towards_eye).is_positive(), -simd.one());
        let near = Self::about_first_corner(rays, &corners[0], sides, depth.to_f32(), anchor, sign);
        if inside.all() {
            return near;
        }
        let sign = if rays.is_parallel() { -sign } else { sign };
        let far = Self::about_anchor(rays, corners, tile, anchor, depth.is_positive(), sign);
        near.select(inside, &far)
    }

    /// The forms of a triangle whose first corner lies in the tile: there w_1 and w_2 are 0, so constants
    /// can be made of f32 differences of the corners.
    ///
    /// With e_k = p_k - p_0, d = p_0 over its depth (d_z = -1), u_k = e_kx + e_kz d_x and v_k = e_ky +
    /// e_kz d_y, the extents of the sides in the window times their depth: w_1 = depth d' . (e_2 x d), w_2 =
    /// depth d' . (d x e_1) and w_0 + w_1 + w_2 = d' . (e_1 x e_2) for the ray d' of a sample. Each
    /// constant is rounded a few times and not once, in units of the sides.
    #[inline(always)]
    fn about_first_corner(
        rays: &WindowRays,
        first: &[N::F64; 3],
        [e1, e2]: [Vec3<N>; 2],
        depth: N,
        anchor: Anchor<N>,
        sign: N,
    ) -> Self {
        let (one, zero) = (depth.one(), depth.zero());
        let inverse = one / depth;
        let parallel = rays.is_parallel();
        let (mut dx, mut dy) = (zero, zero);
        if !parallel {
            dx = first[0].to_f32() * inverse;
            dy = first[1].to_f32() * inverse;
        }
        let (u1, v1) = (e1.x + e1.z * dx, e1.y + e1.z * dy);
        let (u2, v2) = (e2.x + e2.z * dx, e2.y + e2.z * dy);
        let [step_x, step_y] = rays.steps();
        let (across, down) = (depth.constant(step_x), depth.constant(step_y));
        let (across_depth, down_depth) = (across * depth, down * depth);
        let (a1, b1) = (-(v2 * across_depth), u2 * down_depth);
        let (a2, b2) = (v1 * across_depth, -(u1 * down_depth));
        let (mut a0, mut b0) = (-(a1 + a2), -(b1 + b2));
        if !parallel {
            a0 = a0 + across * (e1.y * e2.z - e1.z * e2.y);
            b0 = b0 + down * (e1.z * e2.x - e1.x * e2.z);
        }
        let c0 = u2 * v1 - u1 * v2;
        // How far the corners lie from the anchor in the window.
        let (mut depth_1, mut depth_2) = (one, one);
        if !parallel {
            depth_1 = depth - e1.z;
            depth_2 = depth - e2.z;
        }
        let [reach_x1, reach_y1] = reach([u1, v1], depth_1, [step_x, step_y]);
        let [reach_x2, reach_y2] = reach([u2, v2], depth_2, [step_x, step_y]);
        let terms = (a0.abs() + a1.abs() + a2.abs()) * reach_x1.maximum(reach_x2)
            + (b0.abs() + b1.abs() + b2.abs()) * reach_y1.maximum(reach_y2)
            + c0.abs();
        let scale = sign / terms;
        Self {
            anchor: [anchor.x, anchor.y],
            rest: [anchor.rest_x, anchor.rest_y],
            a: [a0 * scale, a1 * scale, a2 * scale],
            b: [b0 * scale, b1 * scale, b2 * scale],
            c: [c0 * scale, zero, zero],
        }
    }

    /// The forms of any triangle, made in f64. Outlined: one copy per lane type.
    #[inline(never)]
    fn about_anchor(
        rays: &WindowRays,
        corners: &[[N::F64; 3]; 3],
        tile: [i32; 2],
        anchor: Anchor<N>,
        in_front: N::Mask,
        sign: N,
    ) -> Self {
        anchor.x.vectorized(
            #[inline(always)]
            || Self::about_anchor_lanes(rays, corners, tile, anchor, in_front, sign),
        )
    }

    #[inline(always)]
    fn about_anchor_lanes(
        rays: &WindowRays,
        corners: &[[N::F64; 3]; 3],
        [tile_x, tile_y]: [i32; 2],
        anchor: Anchor<N>,
        in_front: N::Mask,
        sign: N,
    ) -> Self {
        let forms = Forms::new(rays, *corners);
        let Anchor { x, y, rest_x, rest_y } = anchor;
        let far = x.constant(TILE as f32);
        // How far the rest of the triangle reaches from the anchor, within the tile.
        let [mut reach_x, mut reach_y] = [x.zero(), x.zero()];
        for corner in [corners[1], corners[2]] {
            let [other_x, other_y, depth] = rays.window_narrow(corner);
            let in_front = in_front & x.zero().less(depth);
            let along_x = (other_x - x.constant(tile_x as f32)).clamped(0.0, TILE as f32) - x;
            let along_y = (other_y - x.constant(tile_y as f32)).clamped(0.0, TILE as f32) - y;
            reach_x = reach_x.maximum(along_x.abs().select(in_front, far));
            reach_y = reach_y.maximum(along_y.abs().select(in_front, far));
        }
        let anchor_x = x.to_f64() + rest_x.to_f64();
        let anchor_y = y.to_f64() + rest_y.to_f64();
        let (a, b) = forms.linear().slopes();
        let at_anchor = forms.weights(
            anchor_x + anchor_x.constant(tile_x.into()),
            anchor_y + anchor_y.constant(tile_y.into()),
        );
        let [wide_x, wide_y] = [reach_x.to_f64(), reach_y.to_f64()];
        let mut terms = anchor_x.constant(0.0);
        for corner in 0..3 {
            terms = terms
                + a[corner].abs() * wide_x
                + b[corner].abs() * wide_y
                + at_anchor[corner].abs();
        }
        let scale = sign.to_f64() / terms;
        let (a, b, c) = (scaled(a, scale), scaled(b, scale), scaled(at_anchor, scale));
        Self { anchor: [x, y], rest: [rest_x, rest_y], a, b, c }
    }

    /// These forms where the mask is true, `other` elsewhere.
    #[inline(always)]
    fn select(&self, mask: N::Mask, other: &Self) -> Self {
        let (own, other) = (self.to_array(), other.to_array());
        Self::from_numbers(
            #[inline(always)]
            |index| own[index].select(mask, other[index]),
        )
    }

    /// The forms as numbers in a row.
    #[inline(always)]
    #[must_use]
    pub fn to_array(&self) -> [N; TILE_FORMS] {
        let Self { anchor: [x, y], rest: [x_rest, y_rest], a, b, c } = *self;
        [x, y, x_rest, y_rest, a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]]
    }

    /// The way back: number `i` of the row is `at(i)`. The closure is to be marked `#[inline(always)]`.
    #[inline(always)]
    #[must_use]
    pub fn from_numbers(at: impl Fn(usize) -> N) -> Self {
        Self {
            anchor: [at(0), at(1)],
            rest: [at(2), at(3)],
            a: [at(4), at(5), at(6)],
            b: [at(7), at(8), at(9)],
            c: [at(10), at(11), at(12)],
        }
    }

    /// The weights at (x, y), in pixels from the tile's first corner, multiples of 1/256.
    #[inline(always)]
    fn weights(&self, x: N, y: N) -> [N; 3] {
        let x = x - self.anchor[0] - self.rest[0];
        let y = y - self.anchor[1] - self.rest[1];
        let Self { a, b, c, .. } = self;
        [a[0] * x + b[0] * y + c[0], a[1] * x + b[1] * y + c[1], a[2] * x + b[2] * y + c[2]]
    }

    /// The barycentrics at (x, y), in pixels from the tile's first corner, multiples of 1/256.
    ///
    /// A sample that only the snapped triangle covers lies outside of the triangle itself: negative
    /// weights count as 0, and the sum of the others is 1 again.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, x: N, y: N) -> Barycentrics<N> {
        let [w0, w1, w2] = self.weights(x, y);
        let [w0, w1, w2] = [w0.positive_part(), w1.positive_part(), w2.positive_part()];
        let sum = w0 + w1 + w2;
        let scale = sum.one() / sum;
        // Comparisons with NaN are false.
        let inexact = !sum.constant(LEAST_SUM).less_or_equal(sum);
        Barycentrics { weights: [w0 * scale, w1 * scale, w2 * scale], inexact }
    }

    /// How the second and the third barycentric change from (x, y) to one pixel to the right, and to one
    /// below, in the triangle's plane: a pixel's footprint on textures. For [`interpolate_step`].
    ///
    /// With the weights w_i, their sum S, and what a pixel adds to them, a_i and A: (w_i + a_i) / (S + A) -
    /// w_i / S = (a_i S - w_i A) / (S (S + A)). The difference of two barycentrics would lose the digits
    /// that they share, and a footprint decides how many probes a texture gets.
    #[inline(always)]
    #[must_use]
    pub fn steps(&self, x: N, y: N) -> [[N; 2]; 2] {
        let [w0, w1, w2] = self.weights(x, y);
        let Self { a, b, .. } = self;
        let sum = w0 + w1 + w2;
        [step([w1, w2], sum, a), step([w1, w2], sum, b)]
    }
}

/// The place in the tile that forms are about: a multiple of 1/256 pixel, and what is left of it.
#[derive(Clone, Copy)]
struct Anchor<N> {
    x: N,
    y: N,
    rest_x: N,
    rest_y: N,
}

impl<N: Lanes> Anchor<N> {
    /// The nearest to a place, in pixels from the tile's first corner, which may be anything.
    #[inline(always)]
    fn new(x: N::F64, y: N::F64) -> Self {
        let ((x, rest_x), (y, rest_y)) = (split(x), split(y));
        Self { x, y, rest_x, rest_y }
    }
}

/// A coordinate within the tile as a multiple of 1/256 pixel in 0..=64, and what is left of it.
#[inline(always)]
fn split<D: F64Lanes>(at: D) -> (D::F32, D::F32) {
    let steps = SUBPIXELS as f32;
    let near = at.to_f32().clamped(0.0, TILE as f32);
    let whole = (near * near.constant(steps)).round_ties_even() * near.constant(1.0 / steps);
    // A little more than half a step: `near` is rounded before the step is chosen.
    let most = 0.75 / steps;
    (whole, (at - whole.to_f64()).to_f32().clamped(-most, most))
}

/// How far a corner lies from the first one in the window, in pixels: its extents times its depth are
/// given. At most a tile; that, too, where the corner isn't before the eye.
#[inline(always)]
fn reach<N: Lanes>([u, v]: [N; 2], depth: N, [step_x, step_y]: [f32; 2]) -> [N; 2] {
    let far = depth.constant(TILE as f32);
    let inverse = depth.one() / depth;
    let in_front = depth.zero().less(depth);
    let x = (u * inverse * depth.constant(1.0 / step_x)).abs().minimum(far);
    let y = (v * inverse * depth.constant(1.0 / step_y)).abs().minimum(far);
    [x.select(in_front, far), y.select(in_front, far)]
}

#[inline(always)]
fn scaled<D: F64Lanes>([x, y, z]: [D; 3], scale: D) -> [D::F32; 3] {
    [(x * scale).to_f32(), (y * scale).to_f32(), (z * scale).to_f32()]
}

/// See [`TileForms::steps`].
#[inline(always)]
fn step<N: Lanes>([w1, w2]: [N; 2], sum: N, [a0, a1, a2]: &[N; 3]) -> [N; 2] {
    let more = *a0 + *a1 + *a2;
    let scale = sum.one() / (sum * (sum + more));
    [(*a1 * sum - w1 * more) * scale, (*a2 * sum - w2 * more) * scale]
}

/// A value of a triangle's first corner and what the other two differ from it, at barycentrics:
/// v_0 + b_1 (v_1 - v_0) + b_2 (v_2 - v_0). What is the same at all corners stays the same.
#[inline(always)]
#[must_use]
pub fn interpolate<N: Lanes>(first: N, differences: [N; 2], [_, b1, b2]: &[N; 3]) -> N {
    first + differences[0] * *b1 + differences[1] * *b2
}

/// How [`interpolate`] changes with the second and the third barycentric: a step of both.
#[inline(always)]
#[must_use]
pub fn interpolate_step<N: Lanes>(differences: [N; 2], [b1, b2]: &[N; 2]) -> N {
    differences[0] * *b1 + differences[1] * *b2
}

/// [`interpolate_step`] of several values given at the corners of one triangle.
#[must_use]
pub fn interpolate_corners_step<const C: usize>(
    [first, second, third]: &[[f32; C]; 3],
    step: &[f32; 2],
) -> [f32; C] {
    std::array::from_fn(|at| {
        interpolate_step([second[at] - first[at], third[at] - first[at]], step)
    })
}

/// [`interpolate`] of several values given at the corners of one triangle.
#[must_use]
pub fn interpolate_corners<const C: usize>(
    [first, second, third]: &[[f32; C]; 3],
    barycentric: &[f32; 3],
) -> [f32; C] {
    std::array::from_fn(|at| {
        let differences = [second[at] - first[at], third[at] - first[at]];
        interpolate(first[at], differences, barycentric)
    })
}

/// One triangle alone.
impl Forms {
    /// The forms in f32 within the tile whose first pixel is `tile`.
    #[must_use]
    pub fn in_tile(&self, rays: &WindowRays, tile: [i32; 2]) -> TileForms<f32> {
        let corners = self.corners_in_lanes();
        TileForms::new(rays, &corners, sides(&corners), self.towards_eye(), tile)
    }

    /// The barycentrics of the sample at a position in steps of 1/256 pixel, which is not negative.
    /// What a frame's lanes hold, bit for bit.
    #[must_use]
    pub fn barycentric(&self, rays: &WindowRays, position: [i32; 2]) -> [f32; 3] {
        self.barycentric_within(&self.in_tile(rays, tile_of(position)), rays, position)
    }

    /// [`Self::barycentric`] from the forms within the tile that holds the position ([`tile_of`]), which
    /// samples of one triangle share.
    #[must_use]
    pub fn barycentric_within(
        &self,
        in_tile: &TileForms<f32>,
        rays: &WindowRays,
        position: [i32; 2],
    ) -> [f32; 3] {
        let (_, [x, y]) = within_tile(position);
        let found = in_tile.at(x, y);
        if found.inexact.any() { self.exact_barycentric(rays, position) } else { found.weights }
    }

    /// How the second and the third barycentric change from a position in steps of 1/256 pixel to one pixel
    /// to the right, and to one below. What a frame's lanes hold, bit for bit.
    #[must_use]
    pub fn steps(&self, rays: &WindowRays, position: [i32; 2]) -> [[f32; 2]; 2] {
        let (tile, [x, y]) = within_tile(position);
        let forms = self.in_tile(rays, tile);
        if forms.at(x, y).inexact.any() { self.exact_steps(position) } else { forms.steps(x, y) }
    }
}

/// The first pixel of the tile that holds a position in steps of 1/256 pixel.
#[must_use]
pub fn tile_of(position: [i32; 2]) -> [i32; 2] {
    within_tile(position).0
}

/// The first pixel of the tile that holds a position in steps of 1/256 pixel, and how far the position
/// lies from it, in pixels.
fn within_tile(position: [i32; 2]) -> ([i32; 2], [f32; 2]) {
    let side = TILE * SUBPIXELS;
    let tile = position.map(|steps| steps.div_euclid(side) * TILE);
    let inside = position.map(|steps| steps.rem_euclid(side) as f32 / SUBPIXELS as f32);
    (tile, inside)
}
