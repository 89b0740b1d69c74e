//! Blocks: up to eight triangles of a leaf, with copies of their vertices.
//!
//! A ray in a large tree mostly waits for memory, so a block stores the positions of its triangles'
//! vertices beside them. Neighbours share most vertices: four triangles have about six. All blocks
//! lie in one list of 32-bit words. A block is
//!
//! | words | contents |
//! | --- | --- |
//! | 1 | its [`BlockHeader`] |
//! | one per triangle | three bits for the local index of each corner's vertex; above them the triangle's number, relative to the first number in the header |
//! | three rows, one word per vertex | x of all vertices, then y, then z |
//!
//! Eight vertices are the lanes of a vector: a kernel transforms each vertex once and distributes the
//! results to corners with lane permutations. With large pages, random rays one at a time take three
//! fifths of the time at a million triangles and seven eighths at 100 000, compared with leaves that
//! store vertex numbers only.
//!
//! Triangles that share too few vertices have rows of corners instead: x, y and z of the first
//! corners, then of the second and the third ones. Where copies would exceed the tree's memory budget,
//! the leaves that rays reach the least store only vertex numbers, one row per corner. A leaf that
//! doesn't fit into one block continues in the next.

use super::node::{MAX_TRIANGLES, WIDTH};
use luxel_math::{Simd, prelude::*, u32x8};

/// Words of the longest block. Lists end with as much padding, so that this many words can be read
/// wherever a block begins.
pub(crate) const BLOCK: usize = 1 + WIDTH + 9 * WIDTH;

/// Up to eight triangles of a leaf, with their vertices.
///
/// Borrows as many words as the longest block has, whatever follows it.
#[derive(Clone, Copy)]
pub struct Block<'t>(pub(crate) &'t [u32; BLOCK]);

/// The first word of a block: three bits for the number of triangles, less one, three for that of
/// vertices, less one, a bit for whether the leaf continues, one for whether triangles have rows of
/// their own, and the lowest triangle number divided by eight, rounded down.
#[derive(Clone, Copy)]
pub(crate) struct BlockHeader(u32);

/// What the rows of a block store.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum VertexRows {
    /// Vertices that triangles share.
    Shared,
    /// The corners of each triangle.
    Separate,
    /// Vertex numbers.
    Numbers,
}

pub(crate) const MORE_FOLLOW: u32 = 1 << 6;
pub(crate) const HAS_OWN_ROWS: u32 = 1 << 7;
/// Together with [`HAS_OWN_ROWS`]: the rows store vertex numbers.
pub(crate) const HAS_NUMBERS: u32 = 1 << 3;
pub(crate) const FIRST_AT: u32 = 8;
/// The bit of a triangle's word at which its number begins.
pub(crate) const NUMBER_AT: u32 = 9;
/// Triangle numbers that a block can express, from its first one on.
pub(crate) const SPAN: u32 = 1 << (32 - NUMBER_AT);

const _: () = assert!(MAX_TRIANGLES.div_ceil(WIDTH) <= 1 << (32 - FIRST_AT));

impl BlockHeader {
    /// The number of triangles.
    #[inline(always)]
    pub(crate) fn count(self) -> usize {
        (self.0 & 7) as usize + 1
    }

    /// Words per row.
    #[inline(always)]
    pub(crate) fn row_length(self) -> usize {
        if self.0 & HAS_OWN_ROWS == 0 { (self.0 >> 3 & 7) as usize + 1 } else { self.count() }
    }

    #[inline(always)]
    pub(crate) fn rows(self) -> VertexRows {
        if self.0 & HAS_OWN_ROWS == 0 {
            VertexRows::Shared
        } else if self.0 & HAS_NUMBERS == 0 {
            VertexRows::Separate
        } else {
            VertexRows::Numbers
        }
    }

    /// Whether the leaf continues in the next block.
    #[inline(always)]
    pub(crate) fn more_follow(self) -> bool {
        self.0 & MORE_FOLLOW != 0
    }

    #[inline(always)]
    fn first(self) -> u32 {
        self.0 >> FIRST_AT << 3
    }

    /// Words of the block.
    #[inline(always)]
    pub(crate) fn len(self) -> usize {
        let rows = if self.rows() == VertexRows::Separate { 9 } else { 3 };
        1 + self.count() + rows * self.row_length()
    }
}

/// The block that begins at `start`.
#[inline(always)]
pub(crate) fn block_at(words: &[u32], start: usize) -> Option<Block<'_>> {
    words.get(start..)?.first_chunk().map(Block)
}

/// A window of eight words from `WIDTH - count` on masks the first `count` lanes.
const LANE_MASK: [u32; 2 * WIDTH] = {
    let mut mask = [0; 2 * WIDTH];
    let mut lane = 0;
    while lane < WIDTH {
        mask[lane] = u32::MAX;
        lane += 1;
    }
    mask
};

/// All bits in the first `count` of eight words, none in the others.
#[inline(always)]
pub(crate) fn lane_mask(count: usize) -> [u32; WIDTH] {
    let mut mask = [0; WIDTH];
    let start = WIDTH - count.min(WIDTH);
    mask.copy_from_slice(&LANE_MASK[start..start + WIDTH]);
    mask
}

impl Block<'_> {
    #[inline(always)]
    pub(crate) fn header(&self) -> BlockHeader {
        BlockHeader(self.0[0])
    }

    /// The number of triangles, from 1 to 8.
    #[must_use]
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.header().count()
    }

    /// The number of a triangle in its mesh, by its lane.
    #[must_use]
    #[inline(always)]
    pub fn triangle(&self, lane: usize) -> u32 {
        self.header().first() + (self.0[1 + (lane & (WIDTH - 1))] >> NUMBER_AT)
    }

    /// The corners of a triangle, by its lane. `positions` are those of the mesh.
    #[must_use]
    #[inline(always)]
    pub fn corners(&self, lane: usize, positions: &[[f32; 3]]) -> [[f32; 3]; 3] {
        self.corners_by_axes(lane, positions, [0, 1, 2])
    }

    /// The corners of a triangle with their coordinates in a given order of axes. Permuting a copy
    /// afterwards would stall on loads of values that were just stored: that made each hit of a
    /// packet wait twenty nanoseconds.
    #[inline(always)]
    pub(crate) fn corners_by_axes(
        &self,
        lane: usize,
        positions: &[[f32; 3]],
        axes: [usize; 3],
    ) -> [[f32; 3]; 3] {
        let header = self.header();
        let mut corners = [[0.0; 3]; 3];
        for corner in 0..3 {
            let at = self.corner_at(lane, corner);
            for (to, axis) in axes.into_iter().enumerate() {
                corners[corner][to] = if header.rows() == VertexRows::Numbers {
                    positions[self.0[at] as usize][axis]
                } else {
                    f32::from_bits(self.0[at + axis * header.row_length()])
                };
            }
        }
        corners
    }

    /// The word that holds a corner's x, whose y and z follow at the distance of a row; or the word
    /// that holds its vertex number.
    #[inline(always)]
    pub(crate) fn corner_at(&self, lane: usize, corner: usize) -> usize {
        let header = self.header();
        let start = 1 + header.count();
        let lane = lane & (WIDTH - 1);
        match header.rows() {
            VertexRows::Shared => start + (self.0[1 + lane] >> (3 * corner) & 7) as usize,
            VertexRows::Separate => start + 3 * corner * header.row_length() + lane,
            VertexRows::Numbers => start + corner * header.row_length() + lane,
        }
    }

    /// Eight words from the beginning of a row, whatever follows it.
    #[inline(always)]
    pub(crate) fn row(&self, row: usize) -> [u32; WIDTH] {
        let header = self.header();
        let start = 1 + header.count() + row.min(8) * header.row_length();
        let mut words = [0; WIDTH];
        words.copy_from_slice(&self.0[start..start + WIDTH]);
        words
    }

    /// The places of a triangle's vertices in the rows, where triangles share them.
    #[inline(always)]
    pub(crate) fn vertices_of(&self, lane: usize) -> [usize; 3] {
        let word = self.0[1 + (lane & (WIDTH - 1))];
        [word, word >> 3, word >> 6].map(|word| (word & 7) as usize)
    }

    /// The words of the triangles, 0 in lanes beyond them. What follows a block may decode to
    /// subnormal numbers, with which some processors take a hundred times as long.
    #[inline(always)]
    pub(crate) fn triangle_words<S: Simd>(&self, simd: S) -> u32x8<S> {
        let mask = lane_mask(self.count());
        let [_, a, b, c, d, e, f, g, h, ..] = *self.0;
        u32x8::simd_from(simd, [a, b, c, d, e, f, g, h]) & u32x8::simd_from(simd, mask)
    }
}
