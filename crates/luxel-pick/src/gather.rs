//! Vertices of a leaf's triangles, gathered side by side: four are read at a time and transposed.

use crate::bvh::{Record, WIDTH};
use luxel_math::{Simd, f32x4, f32x8, prelude::*};

/// The vertices of up to eight triangles: x of the three corners, side by side, then y and z; and a
/// fourth, so that a number of two bits is always one of them.
pub(crate) type Gathered = [[[f32; WIDTH]; 3]; 4];

/// Gathers the vertices of the first `count` of eight triangles; of the others, anything.
#[inline(always)]
pub(crate) fn gather<S: Simd>(
    simd: S,
    records: &[Record; WIDTH],
    count: usize,
    positions: &[[f32; 3]],
) -> Gathered {
    let mut gathered = [[[0.0; WIDTH]; 3]; 4];
    for corner in 0..3 {
        let rows = if count <= WIDTH / 2 {
            eight::<S, false>(simd, records, corner, positions)
        } else {
            eight::<S, true>(simd, records, corner, positions)
        };
        for axis in 0..3 {
            rows[axis].store_slice(&mut gathered[axis][corner]);
        }
    }
    gathered
}

/// A corner of eight triangles side by side, axis by axis; of the last four only if `ALL`.
#[inline(always)]
pub(crate) fn eight<S: Simd, const ALL: bool>(
    simd: S,
    [a, b, c, d, e, f, g, h]: &[Record; WIDTH],
    corner: usize,
    positions: &[[f32; 3]],
) -> [f32x8<S>; 3] {
    let [x, y, z] = four(simd, [a, b, c, d], corner, positions);
    if ALL {
        let [more_x, more_y, more_z] = four(simd, [e, f, g, h], corner, positions);
        [x.combine(more_x), y.combine(more_y), z.combine(more_z)]
    } else {
        [x.combine(x), y.combine(y), z.combine(z)]
    }
}

/// A corner of four triangles side by side, axis by axis.
#[inline(always)]
fn four<S: Simd>(
    simd: S,
    [a, b, c, d]: [&Record; 4],
    corner: usize,
    positions: &[[f32; 3]],
) -> [f32x4<S>; 3] {
    let a = place(simd, a[corner], positions);
    let b = place(simd, b[corner], positions);
    let c = place(simd, c[corner], positions);
    let d = place(simd, d[corner], positions);
    let [x, y, z, _] = transposed(a, b, c, d);
    [x, y, z]
}

/// Rows as columns.
#[inline(always)]
pub(crate) fn transposed<S: Simd>(
    a: f32x4<S>,
    b: f32x4<S>,
    c: f32x4<S>,
    d: f32x4<S>,
) -> [f32x4<S>; 4] {
    let (even, odd) = (a.zip_low(c), b.zip_low(d));
    let (more_even, more_odd) = (a.zip_high(c), b.zip_high(d));
    [
        even.zip_low(odd),
        even.zip_high(odd),
        more_even.zip_low(more_odd),
        more_even.zip_high(more_odd),
    ]
}

/// Where a vertex lies: x, y, z and 0.
#[inline(always)]
fn place<S: Simd>(simd: S, vertex: u32, positions: &[[f32; 3]]) -> f32x4<S> {
    let [x, y, z] = positions[vertex as usize];
    f32x4::simd_from(simd, [x, y, z, 0.0])
}
