//! Vertices of a block's triangles side by side.

use crate::bvh::{Block, Head, Rows, WIDTH, row, triangle_words};
use luxel_math::{Simd, f32x4, f32x8, permuted, prelude::*, u32x8};

/// The vertices of up to eight triangles: x of the three corners, side by side, then y and z; and a
/// fourth, so that a number of two bits is always one of them.
pub(crate) type Gathered = [[[f32; WIDTH]; 3]; 4];

/// Gathers the vertices of a block's triangles; in lanes beyond those is anything.
#[inline(always)]
pub(crate) fn gather<S: Simd>(simd: S, block: &Block, positions: &[[f32; 3]]) -> Gathered {
    let mut gathered = [[[0.0; WIDTH]; 3]; 4];
    match Head::of(block).rows() {
        Rows::Shared => {
            let words = triangle_words(simd, block);
            for axis in 0..3 {
                let places = places(simd, block, axis);
                permuted(simd, places, words).store_slice(&mut gathered[axis][0]);
                permuted(simd, places, words >> 3).store_slice(&mut gathered[axis][1]);
                permuted(simd, places, words >> 6).store_slice(&mut gathered[axis][2]);
            }
        }
        Rows::Apart => {
            for corner in 0..3 {
                for axis in 0..3 {
                    let places = places(simd, block, 3 * corner + axis);
                    places.store_slice(&mut gathered[axis][corner]);
                }
            }
        }
        Rows::Numbers => {
            for corner in 0..3 {
                let rows = eight(simd, block, corner, positions);
                for axis in 0..3 {
                    rows[axis].store_slice(&mut gathered[axis][corner]);
                }
            }
        }
    }
    gathered
}

/// Places along an axis from one of a block's rows on.
#[inline(always)]
pub(crate) fn places<S: Simd>(simd: S, block: &Block, of: usize) -> f32x8<S> {
    u32x8::simd_from(simd, row(block, of)).bitcast()
}

/// A corner of a block's triangles side by side, axis by axis, where the block has vertices'
/// numbers: four are read at a time and transposed.
#[inline(always)]
pub(crate) fn eight<S: Simd>(
    simd: S,
    block: &Block,
    corner: usize,
    positions: &[[f32; 3]],
) -> [f32x8<S>; 3] {
    vertices_in_rows(simd, row(block, corner), Head::of(block).count(), positions)
}

/// The places of some of eight vertices side by side, axis by axis; anything in the other lanes.
#[inline(always)]
pub(crate) fn vertices_in_rows<S: Simd>(
    simd: S,
    [a, b, c, d, e, f, g, h]: [u32; WIDTH],
    count: usize,
    positions: &[[f32; 3]],
) -> [f32x8<S>; 3] {
    let [x, y, z] = four(simd, [a, b, c, d], positions);
    // Most leaves have no more than half.
    if count <= WIDTH / 2 {
        return [x.combine(x), y.combine(y), z.combine(z)];
    }
    let [more_x, more_y, more_z] = four(simd, [e, f, g, h], positions);
    [x.combine(more_x), y.combine(more_y), z.combine(more_z)]
}

/// Four vertices side by side, axis by axis.
#[inline(always)]
fn four<S: Simd>(simd: S, [a, b, c, d]: [u32; 4], positions: &[[f32; 3]]) -> [f32x4<S>; 3] {
    let a = place(simd, a, positions);
    let b = place(simd, b, positions);
    let c = place(simd, c, positions);
    let d = place(simd, d, positions);
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

/// Where a vertex lies: x, y, z and 0; anything for what is no vertex.
#[inline(always)]
fn place<S: Simd>(simd: S, vertex: u32, positions: &[[f32; 3]]) -> f32x4<S> {
    let [x, y, z] = positions.get(vertex as usize).copied().unwrap_or_default();
    f32x4::simd_from(simd, [x, y, z, 0.0])
}
