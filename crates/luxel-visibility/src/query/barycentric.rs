//! Where on its triangle a sample lies, as a ray through the sample finds it.
//!
//! Coverage and the depth test go by snapped corners; attributes are interpolated on the triangle
//! itself. For corners p_0, p_1, p_2 in view space and the ray t d from the eye, Cramer's rule
//! gives weights w_i = d . (p_j x p_k), with barycentrics b_i = w_i / (w_0 + w_1 + w_2). The ray's
//! direction is linear in window x and y, and so are the weights: three linear forms a triangle
//! ("perspective-correct interpolation", Olano and Greer 1997), also for parallel rays.
//!
//! Forms are made and evaluated in f64, and only barycentrics are rounded to f32: they are
//! right to the last digits also on triangles of a hundredth of a pixel.

use super::linear_form::{linear_form, step};
use super::window_rays::WindowRays;
use glam::DVec3;
use luxel_math::{
    F64Lanes, F64x16, Lanes, SUBPIXELS, Simd, f32x16, f64x4, prelude::*, wide_columns,
};

/// A triangle in view space, and the weights of its corners as linear forms over the window.
///
/// Of one triangle, or of sixteen (`D` = [`F64x16`](luxel_math::F64x16)).
#[derive(Clone, Copy, Debug)]
pub struct Forms<D = f64> {
    /// In view space.
    corners: [[D; 3]; 3],
    linear: LinearForms<D>,
    /// Positive where the corners run counterclockwise as seen from the eye.
    towards_eye: D,
}

/// The weights of a triangle's corners as linear forms over the window: w_i = a_i X + b_i Y + c_i.
#[derive(Clone, Copy, Debug)]
pub struct LinearForms<D = f64> {
    a: [D; 3],
    b: [D; 3],
    c: [D; 3],
    /// Below this sum of weights, rounding would tell more than the triangle.
    least_sum: D,
}

/// The forms of one triangle as rows, of which four fill a register: a, b, c and what else there is.
pub type PackedForms = [[f64; 4]; 3];

/// What the sum of weights must be, in parts of the largest terms that it may be made of.
const TOLD: f64 = 1e-9;

impl<D: F64Lanes> Forms<D> {
    /// The forms of a triangle given in view space.
    #[inline(always)]
    #[must_use]
    pub fn new(rays: &WindowRays, corners: [[D; 3]; 3]) -> Self {
        let simd = corners[0][0];
        let zero = simd.constant(0.0);
        let [mut a, mut b, mut c] = [[zero; 3]; 3];
        let mut terms = zero;
        for i in 0..3 {
            let (p, q) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            let area = p[0] * q[1] - p[1] * q[0];
            let n = if rays.parallel {
                // Twice the area of (o, p_j, p_k) for the ray's origin o.
                [p[1] - q[1], q[0] - p[0], -area]
            } else {
                [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], area]
            };
            a[i] = n[0] * simd.constant(rays.dx);
            b[i] = n[1] * simd.constant(rays.dy);
            c[i] = n[0] * simd.constant(rays.x0) + n[1] * simd.constant(rays.y0) - n[2];
            let [width, height] = rays.size;
            terms = terms
                + a[i].abs() * simd.constant(width)
                + b[i].abs() * simd.constant(height)
                + c[i].abs();
        }
        let linear = LinearForms { a, b, c, least_sum: terms * simd.constant(TOLD) };
        Self { corners, linear, towards_eye: rays.towards_eye(&corners) }
    }

    /// The corners in view space.
    #[inline(always)]
    pub(crate) fn corners_in_lanes(&self) -> [[D; 3]; 3] {
        self.corners
    }

    /// The weights alone.
    #[inline(always)]
    #[must_use]
    pub fn linear(&self) -> &LinearForms<D> {
        &self.linear
    }

    /// Positive where the corners run counterclockwise as seen from the eye, negative where they run
    /// clockwise.
    #[inline(always)]
    #[must_use]
    pub fn towards_eye(&self) -> D {
        self.towards_eye
    }

    /// The weights at window position (x, y) in pixels: see [`LinearForms::weights`].
    #[inline(always)]
    #[must_use]
    pub fn weights(&self, x: D, y: D) -> [D; 3] {
        self.linear.weights(x, y)
    }

    /// The barycentrics at window position (x, y) in pixels: see [`LinearForms::barycentrics`].
    #[inline(always)]
    #[must_use]
    pub fn barycentrics(&self, x: D, y: D) -> ([D::F32; 3], <D::F32 as Lanes>::Mask) {
        self.linear.barycentrics(x, y)
    }
}

impl<D: F64Lanes> LinearForms<D> {
    /// The forms of corners in homogeneous window coordinates h_i = (x_i w_i, y_i w_i, w_i), for any projection and w of
    /// either sign: the weight of corner i at p = (x, y, 1) is p . (h_j x h_k) (Olano and Greer 1997).
    ///
    /// [`Forms`] has the same of corners in view space, whose rays are known. Of a line, the third corner is any point
    /// beside it.
    #[inline(always)]
    #[must_use]
    pub fn from_homogeneous(corners: [[D; 3]; 3]) -> Self {
        let zero = corners[0][0].constant(0.0);
        let [mut a, mut b, mut c] = [[zero; 3]; 3];
        for i in 0..3 {
            let (p, q) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            a[i] = p[1] * q[2] - p[2] * q[1];
            b[i] = p[2] * q[0] - p[0] * q[2];
            c[i] = p[0] * q[1] - p[1] * q[0];
        }
        Self { a, b, c, least_sum: zero }
    }

    /// The barycentrics at window position (x, y) in pixels; weights that are negative there count as 0, since what the
    /// snapped triangle covers may lie 1/512 pixel beside the triangle. (1, 0, 0) where rounding leaves none.
    #[inline(always)]
    #[must_use]
    pub fn clamped_barycentrics(&self, x: D, y: D) -> [D::F32; 3] {
        clamped_by_sum(self.weights(x, y))
    }

    /// The weights at window position (x, y) in pixels; divided by their sum they are barycentrics,
    /// also outside of the triangle.
    #[inline(always)]
    #[must_use]
    pub fn weights(&self, x: D, y: D) -> [D; 3] {
        [self.weight(0, x, y), self.weight(1, x, y), self.weight(2, x, y)]
    }

    /// How the weights grow a pixel to the right, and a pixel down.
    #[inline(always)]
    pub(crate) fn slopes(&self) -> ([D; 3], [D; 3]) {
        (self.a, self.b)
    }

    #[inline(always)]
    fn weight(&self, i: usize, x: D, y: D) -> D {
        linear_form([self.a[i], self.b[i], self.c[i]], x, y)
    }

    /// The barycentrics at window position (x, y) in pixels, and where they lie outside the triangle
    /// or rounding would tell more than the triangle (edge-on) and [`Forms::nearest_on_edges`] has
    /// to answer.
    #[inline(always)]
    #[must_use]
    pub fn barycentrics(&self, x: D, y: D) -> ([D::F32; 3], <D::F32 as Lanes>::Mask) {
        let [w0, w1, w2] = self.weights(x, y);
        let scale = x.constant(1.0) / (w0 + w1 + w2);
        let [b0, b1, b2] = [(w0 * scale).to_f32(), (w1 * scale).to_f32(), (w2 * scale).to_f32()];
        // Comparisons with NaN are false: what can't be told counts as outside.
        let zero = b0.zero();
        let inside = zero.less_or_equal(b0)
            & zero.less_or_equal(b1)
            & zero.less_or_equal(b2)
            & (self.least_sum * scale.abs()).to_f32().less(b0.one());
        ([b0, b1, b2], !inside)
    }

    /// How the second and the third barycentric change from (x, y) to one pixel to the right, and to one
    /// below, in the triangle's plane: what a pixel covers of a texture.
    #[inline(always)]
    #[must_use]
    pub fn steps(&self, x: D, y: D) -> [[D::F32; 2]; 2] {
        let [w0, w1, w2] = self.weights(x, y);
        let sum = w0 + w1 + w2;
        let ([a0, a1, a2], [b0, b1, b2]) = (self.a, self.b);
        [step([w1, w2], sum, [a1, a2], a0 + a1 + a2), step([w1, w2], sum, [b1, b2], b0 + b1 + b2)]
    }

    /// Each lane's own forms, from `packed(lane)`; `simd` selects the lane type. The closure
    /// is to be marked `#[inline(always)]`.
    #[inline(always)]
    #[must_use]
    pub fn unpacked<'p>(simd: D, packed: impl Fn(usize) -> &'p PackedForms) -> Self {
        let [a0, a1, a2, least_sum] = simd.load_transposed(
            #[inline(always)]
            |lane| &packed(lane)[0],
        );
        let [b0, b1, b2, _] = simd.load_transposed(
            #[inline(always)]
            |lane| &packed(lane)[1],
        );
        let [c0, c1, c2, _] = simd.load_transposed(
            #[inline(always)]
            |lane| &packed(lane)[2],
        );
        Self { a: [a0, a1, a2], b: [b0, b1, b2], c: [c0, c1, c2], least_sum }
    }

    /// The way back: `put(lane, row, values)` for each lane and each row of [`PackedForms`]. The
    /// closure is to be marked `#[inline(always)]`.
    #[inline(always)]
    pub fn pack(&self, mut put: impl FnMut(usize, usize, [f64; 4])) {
        let zero = self.least_sum.constant(0.0);
        let rest = [self.least_sum, zero, zero];
        for (row, ([first, second, third], rest)) in
            [self.a, self.b, self.c].into_iter().zip(rest).enumerate()
        {
            D::store_transposed(
                [first, second, third, rest],
                #[inline(always)]
                |lane, values| put(lane, row, values),
            );
        }
    }

    /// One triangle's forms in every lane; `simd` selects the lane type.
    #[inline(always)]
    #[must_use]
    pub fn everywhere(simd: D, [a, b, c]: &PackedForms) -> Self {
        let [a0, a1, a2, least_sum] = a;
        let [b0, b1, b2, _] = b;
        let [c0, c1, c2, _] = c;
        Self {
            a: in_lanes(simd, &[*a0, *a1, *a2]),
            b: in_lanes(simd, &[*b0, *b1, *b2]),
            c: in_lanes(simd, &[*c0, *c1, *c2]),
            least_sum: simd.constant(*least_sum),
        }
    }
}

impl<S: Simd> LinearForms<F64x16<S>> {
    /// [`Self::clamped_barycentrics`] of each lane's own forms, from `packed(lane)`, at its own window position. Mark
    /// both closures `#[inline(always)]`.
    ///
    /// Forms are evaluated where they lie, a triangle's in one register: of twelve numbers a lane, [`Self::unpacked`]
    /// transposes all.
    #[inline(always)]
    #[must_use]
    pub fn own_clamped_barycentrics<'p>(
        simd: S,
        packed: impl Fn(usize) -> &'p PackedForms,
        position: impl Fn(usize) -> [f64; 2],
    ) -> [f32x16<S>; 3] {
        let [w0, w1, w2, _] = wide_columns(
            simd,
            #[inline(always)]
            |lane| {
                let [x, y] = position(lane);
                let [a, b, c] = packed(lane);
                let row = [
                    f64x4::simd_from(simd, *a),
                    f64x4::simd_from(simd, *b),
                    f64x4::simd_from(simd, *c),
                ];
                linear_form(row, f64x4::splat(simd, x), f64x4::splat(simd, y))
            },
        );
        clamped_by_sum([w0, w1, w2])
    }
}

/// The barycentrics by weights, of which negative ones count as 0.
#[inline(always)]
fn clamped_by_sum<D: F64Lanes>(mut weights: [D; 3]) -> [D::F32; 3] {
    let sum = weights[0] + weights[1] + weights[2];
    let (zero, one) = (sum.constant(0.0), sum.constant(1.0));
    // The sum has the sign of all weights inside.
    let sign = sum.if_positive(one, sum.constant(-1.0));
    for weight in &mut weights {
        let signed = *weight * sign;
        *weight = signed.if_positive(signed, zero);
    }
    let [w0, w1, w2] = weights;
    let sum = w0 + w1 + w2;
    let scale = one / sum.if_positive(sum, one);
    [
        sum.if_positive(w0 * scale, one).to_f32(),
        sum.if_positive(w1 * scale, zero).to_f32(),
        sum.if_positive(w2 * scale, zero).to_f32(),
    ]
}

/// One triangle alone.
impl Forms {
    /// The same triangle in every lane; `simd` selects the lane type.
    #[inline(always)]
    #[must_use]
    pub fn in_lanes<D: F64Lanes>(&self, simd: D) -> Forms<D> {
        let [p, q, r] = &self.corners;
        Forms {
            corners: [in_lanes(simd, p), in_lanes(simd, q), in_lanes(simd, r)],
            linear: LinearForms {
                a: in_lanes(simd, &self.linear.a),
                b: in_lanes(simd, &self.linear.b),
                c: in_lanes(simd, &self.linear.c),
                least_sum: simd.constant(self.linear.least_sum),
            },
            towards_eye: simd.constant(self.towards_eye),
        }
    }

    /// The triangle's corners in view space.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 3] {
        self.corners.map(DVec3::from_array)
    }

    /// How much a corner's weight grows a pixel: 0 for a triangle seen edge-on.
    #[must_use]
    pub fn steepness(&self, corner: usize) -> f64 {
        let LinearForms { a, b, .. } = &self.linear;
        (a[corner] * a[corner] + b[corner] * b[corner]).sqrt()
    }

    /// The barycentrics of the place on the triangle's edges that lies nearest, in the window, to
    /// position (x, y) in pixels.
    ///
    /// For samples that the snapped triangle covers and the triangle itself doesn't: they lie
    /// within 1/512 pixel of an edge.
    #[must_use]
    pub fn nearest_on_edges(&self, rays: &WindowRays, x: f64, y: f64) -> [f32; 3] {
        let corners = self.corners.map(DVec3::from_array);
        let mut best = (f64::INFINITY, [1.0, 0.0, 0.0]);
        for i in 0..3 {
            let j = (i + 1) % 3;
            let Some((start, end)) = rays.visible_part(corners[i], corners[j]) else {
                continue;
            };
            let [p, q] = [start, end].map(|at| rays.window(corners[i].lerp(corners[j], at)));
            let (Some(p), Some(q)) = (p, q) else { continue };
            let (along_x, along_y) = (q[0] - p[0], q[1] - p[1]);
            let squared = along_x * along_x + along_y * along_y;
            let dot = (x - p[0]) * along_x + (y - p[1]) * along_y;
            let t = if squared > 0.0 { (dot / squared).clamp(0.0, 1.0) } else { 0.0 };
            let (off_x, off_y) = (p[0] + t * along_x - x, p[1] + t * along_y - y);
            let distance = off_x * off_x + off_y * off_y;
            if distance < best.0 {
                // A step along the window's edge is perspective on the triangle's.
                let depth = |at: f64| {
                    let z = corners[i].z + (corners[j].z - corners[i].z) * at;
                    if rays.parallel { 1.0 } else { -z }
                };
                let (from, to) = ((1.0 - t) / depth(start), t / depth(end));
                let along = start + (end - start) * (to / (from + to));
                let mut barycentric = [0.0; 3];
                barycentric[i] = 1.0 - along;
                barycentric[j] = along;
                best = (distance, barycentric);
            }
        }
        best.1.map(|value| value as f32)
    }

    /// The barycentrics of the sample at a position in steps of 1/256 pixel, in f64: where the ray
    /// meets the triangle, or else [`Forms::nearest_on_edges`].
    #[must_use]
    pub fn exact_barycentric(&self, rays: &WindowRays, position: [i32; 2]) -> [f32; 3] {
        let [x, y] = position.map(|steps| f64::from(steps) / f64::from(SUBPIXELS));
        let (barycentric, outside) = self.barycentrics(x, y);
        if outside { self.nearest_on_edges(rays, x, y) } else { barycentric }
    }

    /// How the second and the third barycentric change from a position in steps of 1/256 pixel to one
    /// pixel to the right, and to one below, in f64.
    #[must_use]
    pub fn exact_steps(&self, position: [i32; 2]) -> [[f32; 2]; 2] {
        let [x, y] = position.map(|steps| f64::from(steps) / f64::from(SUBPIXELS));
        self.linear.steps(x, y)
    }
}

#[inline(always)]
fn in_lanes<D: F64Lanes>(simd: D, [x, y, z]: &[f64; 3]) -> [D; 3] {
    [simd.constant(*x), simd.constant(*y), simd.constant(*z)]
}
