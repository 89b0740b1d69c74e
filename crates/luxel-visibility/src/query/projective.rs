//! Attributes of primitives with perspective, as quotients of linear forms over the window.

use super::barycentric::PackedForms;
use super::linear_form::{linear_form, step};
use luxel_math::F64Lanes;

/// Three values over a window that a fourth one divides, all linear forms: attributes of a primitive with perspective.
///
/// They come from [`LinearForms`](super::LinearForms) and values w_i q_i at corners: sum w_i s_i over sum w_i q_i. In f64
/// throughout, so that a primitive whose corners lie far outside of the window has exact values within.
#[derive(Clone, Copy, Debug)]
pub struct ProjectiveForms<D = f64> {
    a: [D; 4],
    b: [D; 4],
    c: [D; 4],
}

impl ProjectiveForms {
    /// The rows of a primitive with corners' weights and four values each, of which the last divides.
    #[must_use]
    pub fn pack(weights: &PackedForms, corners: [[f32; 4]; 3]) -> PackedForms {
        let mut rows = PackedForms::default();
        for (row, weights) in rows.iter_mut().zip(weights) {
            for (weight, corner) in weights.iter().zip(corners) {
                for (sum, value) in row.iter_mut().zip(corner) {
                    *sum += weight * f64::from(value);
                }
            }
        }
        rows
    }
}

impl<D: F64Lanes> ProjectiveForms<D> {
    /// One primitive's rows in every lane; `simd` selects the lane type.
    #[inline(always)]
    #[must_use]
    pub fn everywhere(simd: D, rows: &PackedForms) -> Self {
        let mut forms = [[simd; 4]; 3];
        for (form, row) in forms.iter_mut().zip(rows) {
            for (value, number) in form.iter_mut().zip(row) {
                *value = simd.constant(*number);
            }
        }
        let [a, b, c] = forms;
        Self { a, b, c }
    }

    /// Each lane's own rows. The closure is to be marked `#[inline(always)]`.
    #[inline(always)]
    #[must_use]
    pub fn unpacked<'p>(simd: D, packed: impl Fn(usize) -> &'p PackedForms) -> Self {
        let a = simd.load_transposed(
            #[inline(always)]
            |lane| &packed(lane)[0],
        );
        let b = simd.load_transposed(
            #[inline(always)]
            |lane| &packed(lane)[1],
        );
        let c = simd.load_transposed(
            #[inline(always)]
            |lane| &packed(lane)[2],
        );
        Self { a, b, c }
    }

    /// The three values at window position (x, y) in pixels, and how much they grow from there to a pixel to the right
    /// and to the next row.
    #[inline(always)]
    #[must_use]
    pub fn values(&self, x: D, y: D) -> ([D::F32; 3], [[D::F32; 3]; 2]) {
        let Self { a, b, c } = self;
        let mut forms = *c;
        for (axis, form) in forms.iter_mut().enumerate() {
            *form = linear_form([a[axis], b[axis], c[axis]], x, y);
        }
        let [s, t, r, divisor] = forms;
        let numerators = [s, t, r];
        let scale = divisor.constant(1.0) / divisor;
        let values = [(s * scale).to_f32(), (t * scale).to_f32(), (r * scale).to_f32()];
        let right = step(numerators, divisor, [a[0], a[1], a[2]], a[3]);
        let next = step(numerators, divisor, [b[0], b[1], b[2]], b[3]);
        (values, [right, next])
    }
}
