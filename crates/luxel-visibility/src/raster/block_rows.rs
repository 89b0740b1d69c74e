//! A triangle into the blocks of a tile, row by row of blocks.
//!
//! Sixteen blocks side by side are tested at once: whether the triangle may reach them, and whether they
//! are hidden; then sixteen pixels at a time are covered. Where more than depth decides at a sample,
//! another copy does it, which leaves the registers to the plain one: a block takes 57 instructions,
//! and 33 more where something is put, instead of 120.

use super::buffer::{Plane, Tile};
use super::rules::{Rules, ask, comes_first, passed};
use super::setup::{DepthPlane, Edge};
use crate::types::{BLOCK, BLOCKS, BLOCKS_OF_TILE, LANE_X, LANE_Y, Region, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, lanes_of, mask32x16, prelude::*, u32x16};

/// The blocks of a tile about a triangle, for one of its samples.
pub(super) struct BlockRows {
    /// Whole blocks.
    pub(super) region: Region,
    /// The first one: column and row.
    pub(super) first: [i32; 2],
    pub(super) edges: [Edge; 3],
    pub(super) offset: [i32; 2],
    pub(super) sample: usize,
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

/// Puts a triangle where it wins.
#[inline(always)]
pub(super) fn cover<S: Simd>(
    simd: S,
    rows: &BlockRows,
    plane: &DepthPlane,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    if rules.behind.is_none() && rules.holes.is_none() {
        cover_rows::<S, true>(simd, rows, plane, id, rules, tile);
    } else {
        cover_by_all_rules(simd, rows, plane, id, rules, tile);
    }
}

/// Covers blocks where more than depth decides at samples: outlined, so that the
/// common case has the registers for itself.
#[inline(never)]
fn cover_by_all_rules<S: Simd>(
    simd: S,
    rows: &BlockRows,
    plane: &DepthPlane,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    simd.vectorize(
        #[inline(always)]
        || cover_rows::<S, false>(simd, rows, plane, id, rules, tile),
    );
}

/// Covers blocks row by row. `PLAIN` where depth alone decides.
#[inline(always)]
fn cover_rows<S: Simd, const PLAIN: bool>(
    simd: S,
    rows: &BlockRows,
    plane: &DepthPlane,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    let BlockRows { region, first: [left, top], edges: [e0, e1, e2], offset, sample } = *rows;
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
    let low = f32x16::splat(simd, plane.low);
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
        let mut reached = tile.visible_blocks(simd, top + row, reached << left, high, asks) >> left;
        if reached != 0 {
            tile.summary.touch_blocks((top + row) as usize, reached << left);
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
                let z = (dx * plane.dz_dx + plane.z + row_z).maximum(low).minimum(high);
                let block = (first_block as usize + column) & (BLOCKS_OF_TILE - 1);
                if PLAIN {
                    put_nearer(simd, covered, z, id, rules, &mut tile.planes[sample], block);
                } else {
                    draw_block(simd, covered, z, id, rules, tile, sample, block);
                }
            }
        }
        starts[0] += e0.step_y * BLOCK;
        starts[1] += e1.step_y * BLOCK;
        starts[2] += e2.step_y * BLOCK;
    }
}

/// Puts a triangle into one block of a plane, where it is nearer.
#[inline(always)]
fn put_nearer<S: Simd>(
    simd: S,
    covered: mask32x16<S>,
    z: f32x16<S>,
    id: TriangleId,
    rules: &Rules<'_>,
    plane: &mut Plane,
    block: usize,
) {
    let (depths, ids) = (&mut plane.depth[block], &mut plane.ids[block]);
    let depth = f32x16::from_slice(simd, depths);
    let seen = covered & depth.simd_le(z);
    if !seen.any_true() {
        return;
    }
    let equal = seen & depth.simd_eq(z);
    if equal.any_true() {
        settle(equal.to_bitmask() as u32, &z.into(), id, rules, depths, ids);
    }
    let nearer = covered & depth.simd_lt(z);
    let depth = f32x16::from_slice(simd, depths);
    nearer.select(z, depth).store_slice(depths);
    let before = u32x16::from_slice(simd, ids);
    nearer.select(u32x16::splat(simd, id.0), before).store_slice(ids);
}

/// Puts a triangle into those lanes of a block in which another one is equally near, where it was
/// submitted first.
#[cold]
#[inline(never)]
fn settle(
    equal: u32,
    z: &[f32; LANES],
    id: TriangleId,
    rules: &Rules<'_>,
    depths: &mut [f32; LANES],
    ids: &mut [u32; LANES],
) {
    for lane in lanes_of(equal) {
        if comes_first(id, TriangleId(ids[lane]), rules) {
            (depths[lane], ids[lane]) = (z[lane], id.0);
        }
    }
}

/// Puts a triangle into one block of a plane, where it wins, by all rules.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "the inner loop's state, kept in registers")]
fn draw_block<S: Simd>(
    simd: S,
    covered: mask32x16<S>,
    z: f32x16<S>,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
    sample: usize,
    block: usize,
) {
    let plane = &mut tile.planes[sample];
    let depth = f32x16::from_slice(simd, &plane.depth[block]);
    let nearer = covered & depth.simd_lt(z);
    let equal = covered & z.simd_eq(depth);
    let ids = u32x16::from_slice(simd, &plane.ids[block]);
    let mut wins = nearer.to_bitmask() as u32;
    for lane in lanes_of(equal.to_bitmask() as u32) {
        let first = comes_first(id, TriangleId(plane.ids[block][lane]), rules);
        wins |= u32::from(first) << lane;
    }
    if let Some(behind) = rules.behind {
        for lane in lanes_of(wins) {
            wins &= !(u32::from(!passed(&behind[sample], block, lane, id, z[lane], rules)) << lane);
        }
    }
    if wins == 0 {
        return;
    }
    if let Some(holes) = rules.holes {
        let block_x = tile.region.x + block as i32 % BLOCKS * BLOCK;
        let block_y = tile.region.y + block as i32 / BLOCKS * BLOCK;
        let offset = rules.offsets[sample];
        let x = (i32x16::simd_from(simd, LANE_X) + block_x) * SUBPIXELS + offset[0];
        let y = (i32x16::simd_from(simd, LANE_Y) + block_y) * SUBPIXELS + offset[1];
        wins &= !ask(holes, [id; LANES], [x, y], wins);
        if wins == 0 {
            return;
        }
    }
    let mask = mask32x16::from_bitmask(simd, u64::from(wins));
    mask.select(z, depth).store_slice(&mut plane.depth[block]);
    mask.select(u32x16::splat(simd, id.0), ids).store_slice(&mut plane.ids[block]);
}
