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
    pub(crate) fn times<N: Lanes>(&self, column: [N; 4]) -> [N; 4] {
        let [r0, r1, r2, r3] = &self.0;
        [row_times(r0, column), row_times(r1, column), row_times(r2, column), row_times(r3, column)]
    }

    /// The first three rows' first three numbers times a column.
    #[inline(always)]
    pub(crate) fn times_direction<N: Lanes>(&self, column: [N; 3]) -> [N; 3] {
        let [r0, r1, r2, _] = &self.0;
        [direction_times(r0, column), direction_times(r1, column), direction_times(r2, column)]
    }
}

// Functions rather than closures: those are not inlined into kernels.

#[inline(always)]
fn row_times<N: Lanes>(row: &[f32; 4], [x, y, z, w]: [N; 4]) -> N {
    x * x.constant(row[0])
        + y * x.constant(row[1])
        + z * x.constant(row[2])
        + w * x.constant(row[3])
}

#[inline(always)]
fn direction_times<N: Lanes>(row: &[f32; 4], [x, y, z]: [N; 3]) -> N {
    x * x.constant(row[0]) + y * x.constant(row[1]) + z * x.constant(row[2])
}
