//! Matrices as rows of `f32`, which vectors are multiplied with in lanes.

use glam::DMat4;
use luxel_math::Lanes;

/// The rows of a matrix.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MatrixRows(pub(crate) [[f32; 4]; 4]);

impl MatrixRows {
    pub(crate) fn new(matrix: &DMat4) -> Self {
        Self([0, 1, 2, 3].map(|row| matrix.row(row).as_vec4().to_array()))
    }

    /// The matrix times a column.
    #[inline(always)]
    pub(crate) fn times<N: Lanes>(&self, [x, y, z, w]: [N; 4]) -> [N; 4] {
        let row = |[a, b, c, d]: [f32; 4]| {
            x * x.constant(a) + y * x.constant(b) + z * x.constant(c) + w * x.constant(d)
        };
        let [r0, r1, r2, r3] = self.0;
        [row(r0), row(r1), row(r2), row(r3)]
    }

    /// The first three rows' first three numbers times a column.
    #[inline(always)]
    pub(crate) fn times_direction<N: Lanes>(&self, [x, y, z]: [N; 3]) -> [N; 3] {
        let row =
            |[a, b, c, _]: [f32; 4]| x * x.constant(a) + y * x.constant(b) + z * x.constant(c);
        let [r0, r1, r2, _] = self.0;
        [row(r0), row(r1), row(r2)]
    }
}
