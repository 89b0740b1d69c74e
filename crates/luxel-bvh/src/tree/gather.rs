//! Loads the vertices of a block's triangles into lanes.

use super::block::{Block, VertexRows, lane_mask};
use super::node::WIDTH;
use luxel_math::{Simd, f32x4, f32x8, permuted, prelude::*, u32x8};

/// The vertices of up to eight triangles: x of the three corners in rows of eight, then y and z. The
/// fourth entry is unused and makes any two bits a valid index.
pub(crate) type Gathered = [[[f32; WIDTH]; 3]; 4];

/// Gathers the vertices of a block's triangles; lanes beyond those are arbitrary.
#[inline(always)]
pub(crate) fn gather<S: Simd>(simd: S, block: Block<'_>, positions: &[[f32; 3]]) -> Gathered {
    let mut gathered = [[[0.0; WIDTH]; 3]; 4];
    match block.header().rows() {
        VertexRows::Shared => {
            let words = block.triangle_words(simd);
            for axis in 0..3 {
                let row = load_row(simd, block, axis);
                permuted(simd, row, words).store_slice(&mut gathered[axis][0]);
                permuted(simd, row, words >> 3).store_slice(&mut gathered[axis][1]);
                permuted(simd, row, words >> 6).store_slice(&mut gathered[axis][2]);
            }
        }
        VertexRows::Separate => {
            for corner in 0..3 {
                for axis in 0..3 {
                    let row = load_row(simd, block, 3 * corner + axis);
                    row.store_slice(&mut gathered[axis][corner]);
                }
            }
        }
        VertexRows::Numbers => {
            for corner in 0..3 {
                let rows = gather_corner(simd, block, corner, positions);
                for axis in 0..3 {
                    rows[axis].store_slice(&mut gathered[axis][corner]);
                }
            }
        }
    }
    gathered
}

/// A function of vertices, for [`Block::map_corners`].
///
/// A trait and not a closure: only a method can be marked `#[inline(always)]`, and vector code that isn't
/// inlined loses its instruction set.
pub trait VertexMap<const N: usize> {
    /// Maps x, y and z of eight vertices to N values each. Mark it `#[inline(always)]`.
    fn map<S: Simd>(&self, position: [f32x8<S>; 3]) -> [f32x8<S>; N];
}

impl Block<'_> {
    /// Maps the vertices of the block's triangles and returns the results for the first, second and
    /// third corners, one triangle per lane; lanes beyond [`Self::count`] are arbitrary.
    ///
    /// Maps eight vertices at a time. Vertices that triangles share are mapped once.
    #[inline(always)]
    pub fn map_corners<S: Simd, const N: usize>(
        &self,
        simd: S,
        positions: &[[f32; 3]],
        map: &impl VertexMap<N>,
    ) -> [[f32x8<S>; N]; 3] {
        let mut corners = [[f32x8::splat(simd, 0.0); N]; 3];
        match self.header().rows() {
            VertexRows::Shared => {
                let mapped = map.map(self.vertices(simd, 0));
                let words = self.triangle_words(simd);
                for (corner, at) in [words, words >> 3, words >> 6].into_iter().enumerate() {
                    for value in 0..N {
                        corners[corner][value] = permuted(simd, mapped[value], at);
                    }
                }
            }
            VertexRows::Separate => {
                for (corner, mapped) in corners.iter_mut().enumerate() {
                    *mapped = map.map(self.vertices(simd, 3 * corner));
                }
            }
            VertexRows::Numbers => {
                for (corner, mapped) in corners.iter_mut().enumerate() {
                    *mapped = map.map(gather_corner(simd, *self, corner, positions));
                }
            }
        }
        corners
    }

    /// Three rows of coordinates from a given one on, 0 in lanes beyond the block's vertices.
    ///
    /// What follows a row may decode to subnormal numbers: each product with one takes an Intel Xeon 25 ns,
    /// and mapping a block by the rows of a matrix took four. Without them, the triangle of a sample is found
    /// in 0.6 of the time.
    #[inline(always)]
    pub(crate) fn vertices<S: Simd>(&self, simd: S, row: usize) -> [f32x8<S>; 3] {
        let count = self.header().row_length();
        [
            load_first(simd, *self, row, count),
            load_first(simd, *self, row + 1, count),
            load_first(simd, *self, row + 2, count),
        ]
    }
}

/// A row of coordinates.
#[inline(always)]
pub(crate) fn load_row<S: Simd>(simd: S, block: Block<'_>, row: usize) -> f32x8<S> {
    u32x8::simd_from(simd, block.row(row)).bitcast()
}

/// The first `count` coordinates of a row, and 0 in the other lanes.
#[inline(always)]
fn load_first<S: Simd>(simd: S, block: Block<'_>, row: usize, count: usize) -> f32x8<S> {
    let words = u32x8::simd_from(simd, block.row(row));
    (words & u32x8::simd_from(simd, lane_mask(count))).bitcast()
}

/// One corner of each triangle, axis by axis, in a block that stores vertex numbers.
#[inline(always)]
pub(crate) fn gather_corner<S: Simd>(
    simd: S,
    block: Block<'_>,
    corner: usize,
    positions: &[[f32; 3]],
) -> [f32x8<S>; 3] {
    load_vertices(simd, block.row(corner), block.count(), positions)
}

/// The positions of the first `count` of eight vertices, axis by axis; other lanes are arbitrary.
/// Loads four vertices at a time and transposes them.
#[inline(always)]
pub(crate) fn load_vertices<S: Simd>(
    simd: S,
    [a, b, c, d, e, f, g, h]: [u32; WIDTH],
    count: usize,
    positions: &[[f32; 3]],
) -> [f32x8<S>; 3] {
    let [x, y, z] = load_four(simd, [a, b, c, d], positions);
    // Most leaves have no more than half.
    if count <= WIDTH / 2 {
        return [x.combine(x), y.combine(y), z.combine(z)];
    }
    let [more_x, more_y, more_z] = load_four(simd, [e, f, g, h], positions);
    [x.combine(more_x), y.combine(more_y), z.combine(more_z)]
}

/// Four vertices, axis by axis.
#[inline(always)]
fn load_four<S: Simd>(simd: S, [a, b, c, d]: [u32; 4], positions: &[[f32; 3]]) -> [f32x4<S>; 3] {
    let a = load_vertex(simd, a, positions);
    let b = load_vertex(simd, b, positions);
    let c = load_vertex(simd, c, positions);
    let d = load_vertex(simd, d, positions);
    let [x, y, z, _] = transpose(a, b, c, d);
    [x, y, z]
}

/// Transposes four rows of four.
#[inline(always)]
pub(crate) fn transpose<S: Simd>(
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

/// A vertex: x, y, z and 0. An index out of range gives 0.
#[inline(always)]
fn load_vertex<S: Simd>(simd: S, vertex: u32, positions: &[[f32; 3]]) -> f32x4<S> {
    let [x, y, z] = positions.get(vertex as usize).copied().unwrap_or_default();
    f32x4::simd_from(simd, [x, y, z, 0.0])
}
