//! What is hidden in a tile, and what is known of its blocks for that.
//!
//! The farthest depth of every block is kept, a row of sixteen blocks side by side, so that one
//! comparison asks all of them. Drawing only tells which blocks it may have touched; their farthest
//! depth is found again when somebody asks and the old one doesn't do. Depths only come nearer, so an
//! old one is a bound. Blocks that aren't hidden as a whole have those of their pixels asked that
//! matter: clusters of a fine mesh are a few blocks large, and many hidden ones lie at a rim. Beside
//! asking all pixels, it takes 6 of 83 million instructions off a million triangles in 1920x1080.

use super::buffer::Tile;
use crate::types::{BLOCK, BLOCKS, BLOCKS_OF_TILE, Region, TILE};
use luxel_math::{LANES, Lanes, Simd, f32x16, prelude::*};

const ROWS: usize = BLOCKS as usize;
/// All blocks of a row, or all rows.
const ALL: u32 = (1 << BLOCKS) - 1;
const _: () = assert!(ROWS == LANES, "a row of blocks is one vector");

/// What is known of a tile's blocks.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct BlockSummary {
    /// No sample of a block is farther than this, row by row.
    farthest: [[f32; LANES]; ROWS],
    /// Blocks that something was drawn into since, a bit each.
    stale: [u32; ROWS],
    /// Rows of blocks that aren't clear, or may not be: a bit each. Half of the tiles that clusters reach
    /// have none, as clusters aren't as large as their boxes.
    touched: u32,
}

impl BlockSummary {
    pub(super) fn new() -> Self {
        Self { farthest: [[0.0; LANES]; ROWS], stale: [0; ROWS], touched: 0 }
    }

    /// The rows of blocks that may not be clear, a bit each.
    pub(super) fn touched_rows(&self) -> u32 {
        self.touched
    }

    /// All blocks are clear.
    pub(super) fn clear(&mut self) {
        for row in luxel_math::lanes_of(self.touched) {
            self.farthest[row] = [0.0; LANES];
        }
        self.stale = [0; ROWS];
        self.touched = 0;
    }

    /// Something is drawn into pixels left, top, right and bottom of the tile.
    #[inline(always)]
    pub(super) fn touch(&mut self, [left, top, right, bottom]: [i32; 4]) {
        let columns = blocks_between(left, right);
        self.touched |= blocks_between(top, bottom);
        for row in top / BLOCK..=bottom / BLOCK {
            self.stale[row as usize & (ROWS - 1)] |= columns;
        }
    }

    /// Something is drawn into blocks of a row, a bit each.
    #[inline(always)]
    pub(super) fn touch_blocks(&mut self, row: usize, blocks: u32) {
        self.touched |= 1 << row;
        self.stale[row & (ROWS - 1)] |= blocks;
    }

    /// The blocks of a row of which every sample is nearer than a depth, as far as is known.
    #[inline(always)]
    pub(super) fn nearer_blocks<S: Simd>(&self, row: usize, depth: f32x16<S>) -> u32 {
        let farthest = f32x16::from_slice(depth.simd, &self.farthest[row & (ROWS - 1)]);
        farthest.simd_gt(depth).to_bitmask() as u32
    }
}

/// The blocks of a row, or the rows, with pixels `first..=last` of the tile.
#[inline(always)]
fn blocks_between(first: i32, last: i32) -> u32 {
    (ALL << (first / BLOCK)) & (ALL >> (BLOCKS - 1 - last / BLOCK))
}

/// The lanes of a block in rows `first..=last`, which need not all be the block's.
#[inline(always)]
fn rows_between(first: i32, last: i32) -> u32 {
    (ALL_LANES << (first.max(0) * BLOCK)) & (ALL_LANES >> ((BLOCK - 1 - last).max(0) * BLOCK))
}

/// The lanes of a block in columns `first..=last`.
#[inline(always)]
fn columns_between(first: i32, last: i32) -> u32 {
    ((0xf << first.max(0)) & (0xf >> (BLOCK - 1 - last).max(0))) * 0x1111
}

const ALL_LANES: u32 = (1 << LANES) - 1;

impl Tile {
    /// Pixels of the window, left, top, right and bottom, as the tile's own.
    #[inline(always)]
    fn within(&self, [left, top, right, bottom]: [i32; 4]) -> [i32; 4] {
        let Region { x, y, .. } = self.region;
        let [left, top] = [(left - x).max(0), (top - y).max(0)];
        [left, top, (right - x).min(TILE - 1), (bottom - y).min(TILE - 1)]
    }

    /// Something is drawn into pixels left, top, right and bottom of the window, some of which are
    /// the tile's.
    #[inline(always)]
    pub(crate) fn touch(&mut self, pixels: [i32; 4]) {
        self.summary.touch(self.within(pixels));
    }

    /// Whether everything drawn so far in the pixels left..=right, top..=bottom of the window is
    /// nearer than `nearest`, as far as they are the tile's.
    #[inline(always)]
    pub(crate) fn occludes<S: Simd>(&mut self, simd: S, pixels: [i32; 4], nearest: f32) -> bool {
        let [left, top, right, bottom] = self.within(pixels);
        if left > right || top > bottom {
            return true;
        }
        let columns = blocks_between(left, right);
        let depth = f32x16::splat(simd, nearest);
        for row in top / BLOCK..=bottom / BLOCK {
            let mut left_over = columns & !self.summary.nearer_blocks(row as usize, depth);
            while left_over != 0 {
                let column = left_over.trailing_zeros() as i32;
                left_over &= left_over - 1;
                if self.refreshed(simd, row, column) > nearest {
                    continue;
                }
                let asked = rows_between(top - row * BLOCK, bottom - row * BLOCK)
                    & columns_between(left - column * BLOCK, right - column * BLOCK);
                if asked == ALL_LANES || !self.hides(asked, row, column, depth) {
                    return false;
                }
            }
        }
        true
    }

    /// Those blocks of a row, a bit each, of which a sample isn't nearer than a depth. With `asks` what was
    /// drawn last is taken into account.
    #[inline(always)]
    pub(super) fn visible_blocks<S: Simd>(
        &mut self,
        simd: S,
        row: i32,
        blocks: u32,
        depth: f32x16<S>,
        asks: bool,
    ) -> u32 {
        let at = row as usize & (ROWS - 1);
        let visible = blocks & !self.summary.nearer_blocks(at, depth);
        let mut unknown = visible & self.summary.stale[at];
        if !asks || unknown == 0 {
            return visible;
        }
        while unknown != 0 {
            self.refreshed(simd, row, unknown.trailing_zeros() as i32);
            unknown &= unknown - 1;
        }
        visible & !self.summary.nearer_blocks(at, depth)
    }

    /// The farthest depth of a block.
    #[inline(always)]
    fn refreshed<S: Simd>(&mut self, simd: S, row: i32, column: i32) -> f32 {
        let (row, column) = (row as usize & (ROWS - 1), column as usize & (ROWS - 1));
        let BlockSummary { farthest, stale, .. } = &mut self.summary;
        if stale[row] >> column & 1 == 1 {
            stale[row] &= !(1 << column);
            let block = row * ROWS + column;
            let mut least = f32x16::splat(simd, f32::INFINITY);
            if let Some((plane, others)) = self.planes.split_first() {
                least = f32x16::from_slice(simd, &plane.depth[block]);
                for plane in others {
                    least = least.minimum(f32x16::from_slice(simd, &plane.depth[block]));
                }
            }
            farthest[row][column] = least_lane(least);
        }
        farthest[row][column]
    }

    /// Whether all planes are nearer in some lanes of a block.
    #[inline(always)]
    fn hides<S: Simd>(&self, asked: u32, row: i32, column: i32, depth: f32x16<S>) -> bool {
        let block = (row * BLOCKS + column) as usize & (BLOCKS_OF_TILE - 1);
        let mut hidden = asked;
        for plane in &self.planes {
            let here = f32x16::from_slice(depth.simd, &plane.depth[block]);
            hidden &= here.simd_gt(depth).to_bitmask() as u32;
        }
        hidden == asked
    }
}

/// The least of sixteen numbers.
#[inline(always)]
fn least_lane<S: Simd>(lanes: f32x16<S>) -> f32 {
    let (lower, upper) = lanes.split();
    let (lower, upper) = lower.minimum(upper).split();
    let four: [f32; 4] = lower.min(upper).into();
    let [a, b] = [Lanes::minimum(four[0], four[1]), Lanes::minimum(four[2], four[3])];
    Lanes::minimum(a, b)
}
