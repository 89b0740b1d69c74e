//! A triangle into the blocks of a tile, row by row of blocks.
//!
//! Sixteen blocks side by side are tested at once: whether the triangle may reach them, and whether they
//! are hidden; then sixteen pixels at a time are covered, and what takes them decides the rest.

use super::setup::{DepthPlane, Edge};
use super::sink::Sink;
use crate::types::{BLOCK, BLOCKS, BLOCKS_OF_TILE, LANE_X, LANE_Y, Region};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, prelude::*};

/// The blocks of a tile about a triangle, for one of its samples.
pub(super) struct BlockRows {
    /// Whole blocks.
    pub(super) region: Region,
    /// The first one: column and row.
    pub(super) first: [i32; 2],
    pub(super) edges: [Edge; 3],
    pub(super) offset: [i32; 2],
}

/// Triangles whose box has so many blocks are worth finding the farthest depths of blocks again. For all
/// of them, 100 000 triangles in 1920x1080 take 49 million instructions instead of 46.
const MANY_BLOCKS: i32 = 24;

/// Pixels from the first block of a row to each of it, in steps of 1/256.
const COLUMNS: [f32; LANES] = {
    let mut columns = [0.0; LANES];
    let mut column = 0;
    while column < LANES {
        columns[column] = (column as i32 * BLOCK * SUBPIXELS) as f32;
        column += 1;
    }
    columns
};

/// Covers blocks row by row.
#[inline(always)]
pub(super) fn cover<S: Simd>(simd: S, rows: &BlockRows, plane: &DepthPlane, sink: &mut impl Sink) {
    let BlockRows { region, first: [left, top], edges: [e0, e1, e2], offset } = *rows;
    let lane_x = i32x16::simd_from(simd, LANE_X);
    let lane_y = i32x16::simd_from(simd, LANE_Y);
    let inside_block = [
        lane_x * e0.step_x + lane_y * e0.step_y,
        lane_x * e1.step_x + lane_y * e1.step_y,
        lane_x * e2.step_x + lane_y * e2.step_y,
    ];
    // Differences of positions are exact in f32, and so are these sums.
    let lane_dx =
        f32x16::float_from(lane_x * SUBPIXELS + (region.x * SUBPIXELS + offset[0] - plane.x));
    let lane_dy = lane_y * SUBPIXELS + (region.y * SUBPIXELS + offset[1] - plane.y);
    let high = f32x16::splat(simd, plane.high);
    // Edge functions in sixteen blocks side by side, as many as a tile has: at the first pixel, and
    // how much larger they are at most.
    let lane = lane_x + lane_y * BLOCK;
    let mut starts = [
        lane * (e0.step_x * BLOCK) + e0.start,
        lane * (e1.step_x * BLOCK) + e1.start,
        lane * (e2.step_x * BLOCK) + e2.start,
    ];
    let rises = [e0.rise_in_block(), e1.rise_in_block(), e2.rise_in_block()];
    let columns = (1_u32 << (region.width / BLOCK)) - 1;
    let asks = region.width * region.height >= MANY_BLOCKS * (BLOCK * BLOCK);
    for row in 0..region.height / BLOCK {
        let reached = (starts[0] + rises[0]) | (starts[1] + rises[1]) | (starts[2] + rises[2]);
        let reached = !reached.simd_lt(0).to_bitmask() as u32 & columns;
        let mut reached = sink.blocks(simd, top + row, reached << left, high, asks) >> left;
        if reached != 0 {
            let starts: [[i32; LANES]; 3] = [starts[0].into(), starts[1].into(), starts[2].into()];
            let dy = f32x16::float_from(lane_dy + row * (BLOCK * SUBPIXELS));
            let row_z = dy * plane.dz_dy;
            let first_block = (top + row) * BLOCKS + left;
            while reached != 0 {
                let column = reached.trailing_zeros() as usize & (LANES - 1);
                reached &= reached - 1;
                let covered = ((inside_block[0] + starts[0][column])
                    | (inside_block[1] + starts[1][column])
                    | (inside_block[2] + starts[2][column]))
                    .simd_ge(0);
                let dx = lane_dx + COLUMNS[column];
                let z = plane.depth(dx, row_z);
                let block = (first_block as usize + column) & (BLOCKS_OF_TILE - 1);
                sink.block(simd, covered, z, block);
            }
        }
        starts[0] += e0.step_y * BLOCK;
        starts[1] += e1.step_y * BLOCK;
        starts[2] += e2.step_y * BLOCK;
    }
}
