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
//! with the cosine between its plane and the ray. Where s < [`LEAST_SUM`], a cosine of about 1/70 (or a
//! sliver as thin), [`Forms::exact_barycentric`] answers in f64 instead: the choice hangs on triangle,
//! tile and sample alone. Random triangles reach a fifth of the bound (`tests/visibility/tile_forms.rs`).

use crate::barycentric::{Forms, WindowRays};
use crate::buffer::TILE;
use luxel_math::{Mask, Number, SUBPIXELS, Wide};

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
pub struct Barycentrics<N: Number> {
    /// The weights of the three corners: not negative, with the sum 1.
    pub weights: [N; 3],
    /// Where [`Forms::exact_barycentric`] has to answer.
    pub inexact: N::Mask,
}

impl<N: Number> TileForms<N> {
    /// The forms of a triangle within the tile whose first pixel is `tile`.
    #[inline(always)]
    #[must_use]
    pub fn new(forms: &Forms<N::Wide>, rays: &WindowRays, [tile_x, tile_y]: [i32; 2]) -> Self {
        let corners = forms.corners_in_lanes();
        let [x, y, depth] = rays.window_lanes(corners[0]);
        let side = TILE as f32;
        let in_front = depth.is_positive();
        let like = x.narrow();
        let (x, x_rest) = split(x - x.constant(tile_x.into()));
        let (y, y_rest) = split(y - y.constant(tile_y.into()));
        // How far the rest of the triangle reaches from the anchor, within the tile.
        let mut reach = [like.zero(), like.zero()];
        for corner in [corners[1], corners[2]] {
            let [other_x, other_y, depth] = rays.window_narrow(corner);
            let in_front = in_front & like.zero().less(depth);
            let along_x = (other_x - like.constant(tile_x as f32)).limited(0.0, side) - x;
            let along_y = (other_y - like.constant(tile_y as f32)).limited(0.0, side) - y;
            let far = like.constant(side);
            reach[0] = reach[0].maximum(along_x.abs().select(in_front, far));
            reach[1] = reach[1].maximum(along_y.abs().select(in_front, far));
        }
        let anchor_x = x.widened() + x_rest.widened();
        let anchor_y = y.widened() + y_rest.widened();
        let (a, b) = forms.linear().slopes();
        let at_anchor = forms.weights(
            anchor_x + anchor_x.constant(tile_x.into()),
            anchor_y + anchor_y.constant(tile_y.into()),
        );
        let [reach_x, reach_y] = [reach[0].widened(), reach[1].widened()];
        let mut terms = anchor_x.constant(0.0);
        for corner in 0..3 {
            terms = terms
                + a[corner].abs() * reach_x
                + b[corner].abs() * reach_y
                + at_anchor[corner].abs();
        }
        // Weights are positive inside, whichever side is seen.
        let sign = like.one().select(forms.sum_sign(rays).is_positive(), -like.one());
        let scale = sign.widened() / terms;
        let (a, b, c) = (scaled(a, scale), scaled(b, scale), scaled(at_anchor, scale));
        Self { anchor: [x, y], rest: [x_rest, y_rest], a, b, c }
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

    /// The barycentrics one pixel to the right of (x, y), and one below, in the triangle's plane and
    /// not brought into the triangle: a pixel's footprint on textures.
    #[inline(always)]
    #[must_use]
    pub fn neighbours(&self, x: N, y: N) -> [[N; 3]; 2] {
        let [w0, w1, w2] = self.weights(x, y);
        let Self { a, b, .. } = self;
        [
            by_their_sum([w0 + a[0], w1 + a[1], w2 + a[2]]),
            by_their_sum([w0 + b[0], w1 + b[1], w2 + b[2]]),
        ]
    }
}

/// A coordinate within the tile as a multiple of 1/256 pixel in 0..=64, and what is left of it; the
/// coordinate itself may be anything.
#[inline(always)]
fn split<D: Wide>(at: D) -> (D::Narrow, D::Narrow) {
    let steps = SUBPIXELS as f32;
    let near = at.narrow().limited(0.0, TILE as f32);
    let whole = (near * near.constant(steps)).round_ties_even() * near.constant(1.0 / steps);
    let half = 0.5 / steps;
    (whole, (at - whole.widened()).narrow().limited(-half, half))
}

#[inline(always)]
fn scaled<D: Wide>([x, y, z]: [D; 3], scale: D) -> [D::Narrow; 3] {
    [(x * scale).narrow(), (y * scale).narrow(), (z * scale).narrow()]
}

/// Weights divided by their sum.
#[inline(always)]
fn by_their_sum<N: Number>([w0, w1, w2]: [N; 3]) -> [N; 3] {
    let scale = w0.one() / (w0 + w1 + w2);
    [w0 * scale, w1 * scale, w2 * scale]
}

/// A value of a triangle's first corner and what the other two differ from it, at barycentrics:
/// v_0 + b_1 (v_1 - v_0) + b_2 (v_2 - v_0). What is the same at all corners stays the same.
#[inline(always)]
#[must_use]
pub fn interpolate<N: Number>(first: N, differences: [N; 2], [_, b1, b2]: &[N; 3]) -> N {
    first + differences[0] * *b1 + differences[1] * *b2
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
    /// The barycentrics of the sample at a position in steps of 1/256 pixel, which is not negative.
    /// What a frame's lanes hold, bit for bit.
    #[must_use]
    pub fn barycentric(&self, rays: &WindowRays, position: [i32; 2]) -> [f32; 3] {
        let (tile, [x, y]) = within_tile(position);
        let found = TileForms::new(self, rays, tile).at(x, y);
        if found.inexact.any() { self.exact_barycentric(rays, position) } else { found.weights }
    }

    /// The barycentrics one pixel to the right of a position in steps of 1/256 pixel, and one below, in
    /// the triangle's plane. What a frame's lanes hold, bit for bit.
    #[must_use]
    pub fn neighbours(&self, rays: &WindowRays, position: [i32; 2]) -> [[f32; 3]; 2] {
        let (tile, [x, y]) = within_tile(position);
        let forms = TileForms::new(self, rays, tile);
        if forms.at(x, y).inexact.any() {
            self.exact_neighbours(position)
        } else {
            forms.neighbours(x, y)
        }
    }
}

/// The first pixel of the tile that holds a position in steps of 1/256 pixel, and how far the position
/// lies from it, in pixels.
fn within_tile(position: [i32; 2]) -> ([i32; 2], [f32; 2]) {
    let side = TILE * SUBPIXELS;
    let tile = position.map(|steps| steps.div_euclid(side) * TILE);
    let inside = position.map(|steps| steps.rem_euclid(side) as f32 / SUBPIXELS as f32);
    (tile, inside)
}
