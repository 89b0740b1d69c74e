//! Triangles into the samples of a tile: sixteen pixels at a time.
//!
//! Among the triangles that cover a sample the nearest wins, and of equally near ones the one that
//! was submitted first. This is a total order, so the outcome depends neither on the order of
//! drawing nor on what was culled on the way.

use super::buffer::{Plane, Tile};
use super::setup::Triangle;
use crate::types::{Asked, BLOCK, BLOCKS, Holes, LANE_X, LANE_Y, Region, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, lanes_of, mask32x16, prelude::*, u32x16};

/// What decides beyond geometry.
pub(crate) struct Rules<'a> {
    /// The sample positions.
    pub(crate) offsets: &'a [[i32; 2]],
    /// The order in which triangles were submitted.
    pub(crate) submitted: &'a dyn Fn(TriangleId) -> u64,
    /// Holes in triangles, if there are any.
    pub(crate) holes: Option<&'a dyn Holes>,
    /// Only what lies behind these samples counts: the last layer peeled off.
    pub(crate) behind: Option<&'a [Plane]>,
}

/// So many pixels are faster asked one by one than sixteen at a time.
const FEW_PIXELS: i32 = 4;

/// Draws one triangle into all samples of a tile.
///
/// A function of its own: all that calls it shares one copy for each SIMD level, which the compiler
/// needs to be done in reasonable time.
#[inline(always)]
pub(crate) fn draw_triangle<S: Simd>(
    simd: S,
    triangle: &Triangle,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    simd.vectorize(
        #[inline(always)]
        || cover_samples(simd, triangle, id, rules, tile),
    );
}

#[inline(always)]
fn cover_samples<S: Simd>(
    simd: S,
    triangle: &Triangle,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    let tile_region = tile.region;
    for (sample, &offset) in rules.offsets.iter().enumerate() {
        let Some(pixels) = triangle.pixels(tile_region, offset) else { continue };
        if pixels.width * pixels.height <= FEW_PIXELS {
            cover_few(triangle, pixels, id, rules, tile, sample);
            continue;
        }
        // Whole blocks of the tile.
        let left = (pixels.x - tile_region.x) / BLOCK;
        let top = (pixels.y - tile_region.y) / BLOCK;
        let right = (pixels.x + pixels.width - 1 - tile_region.x) / BLOCK;
        let bottom = (pixels.y + pixels.height - 1 - tile_region.y) / BLOCK;
        let region = Region {
            x: tile_region.x + left * BLOCK,
            y: tile_region.y + top * BLOCK,
            width: (right - left + 1) * BLOCK,
            height: (bottom - top + 1) * BLOCK,
        };
        let Some(edges) = triangle.edges(region, offset) else { continue };

        let lane_x = i32x16::simd_from(simd, LANE_X);
        let lane_y = i32x16::simd_from(simd, LANE_Y);
        let inside_block = [
            lane_x * edges[0].step_x + lane_y * edges[0].step_y,
            lane_x * edges[1].step_x + lane_y * edges[1].step_y,
            lane_x * edges[2].step_x + lane_y * edges[2].step_y,
        ];
        let plane = &triangle.depth;
        let lane_dx = lane_x * SUBPIXELS + (region.x * SUBPIXELS + offset[0] - plane.x);
        let lane_dy = lane_y * SUBPIXELS + (region.y * SUBPIXELS + offset[1] - plane.y);
        let low = f32x16::splat(simd, plane.low);
        let high = f32x16::splat(simd, plane.high);
        let [e0, e1, e2] = edges;
        let mut row_starts = [e0.start, e1.start, e2.start];
        // The largest values of edge functions in sixteen blocks side by side, as many as a tile has.
        let lane = lane_x + lane_y * BLOCK;
        let highest = [
            lane * (e0.step_x * BLOCK) + e0.rise_in_block(),
            lane * (e1.step_x * BLOCK) + e1.rise_in_block(),
            lane * (e2.step_x * BLOCK) + e2.rise_in_block(),
        ];
        let columns = (2_u32 << (right - left)) - 1;
        for row in 0..=bottom - top {
            let [start0, start1, start2] = row_starts;
            row_starts[0] += e0.step_y * BLOCK;
            row_starts[1] += e1.step_y * BLOCK;
            row_starts[2] += e2.step_y * BLOCK;
            let reached = (highest[0] + start0) | (highest[1] + start1) | (highest[2] + start2);
            let reached = reached.simd_ge(0).to_bitmask() as u32 & columns;
            if reached == 0 {
                continue;
            }
            let dy = f32x16::float_from(lane_dy + row * (BLOCK * SUBPIXELS));
            let row_z = dy * plane.dz_dy;
            for column in lanes_of(reached) {
                let x = column as i32 * BLOCK;
                let covered = ((inside_block[0] + (start0 + e0.step_x * x))
                    | (inside_block[1] + (start1 + e1.step_x * x))
                    | (inside_block[2] + (start2 + e2.step_x * x)))
                    .simd_ge(0);
                let dx = f32x16::float_from(lane_dx + x * SUBPIXELS);
                let z = (dx * plane.dz_dx + plane.z + row_z).maximum(low).minimum(high);
                let block = ((top + row) * BLOCKS + left) as usize + column;
                draw_block(simd, covered, z, id, rules, tile, sample, block);
            }
        }
    }
}

/// Draws one triangle into one sample of a few pixels: the same numbers as in blocks.
#[inline(always)]
fn cover_few(
    triangle: &Triangle,
    pixels: Region,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
    sample: usize,
) {
    let offset = rules.offsets[sample];
    let Some([e0, e1, e2]) = triangle.edges(pixels, offset) else { return };
    for y in 0..pixels.height {
        for x in 0..pixels.width {
            if (e0.at(x, y) | e1.at(x, y) | e2.at(x, y)) < 0 {
                continue;
            }
            let position =
                [(pixels.x + x) * SUBPIXELS + offset[0], (pixels.y + y) * SUBPIXELS + offset[1]];
            let z = triangle.depth.at(position);
            let (column, row) = (pixels.x + x - tile.region.x, pixels.y + y - tile.region.y);
            let place = Tile::place(column, row);
            if !wins(id, z, place, rules, tile, sample) {
                continue;
            }
            if rules.holes.is_some_and(|holes| holes.holes(&Asked::one(id, position)) != 0) {
                continue;
            }
            put(id, z, place, tile, sample);
        }
    }
}

/// Whether one sample of a triangle wins in its block and lane, but for holes.
#[inline(always)]
pub(crate) fn wins(
    id: TriangleId,
    z: f32,
    place: (usize, usize),
    rules: &Rules<'_>,
    tile: &Tile,
    sample: usize,
) -> bool {
    let (block, lane) = within_plane(place);
    let target = &tile.planes[sample];
    let depth = target.depth[block][lane];
    let nearer =
        depth < z || depth == z && comes_first(id, TriangleId(target.ids[block][lane]), rules);
    nearer && rules.behind.is_none_or(|behind| passed(&behind[sample], block, lane, id, z, rules))
}

/// Puts one sample of a triangle into its block and lane.
#[inline(always)]
pub(crate) fn put(id: TriangleId, z: f32, place: (usize, usize), tile: &mut Tile, sample: usize) {
    let (block, lane) = within_plane(place);
    let target = &mut tile.planes[sample];
    target.depth[block][lane] = z;
    target.ids[block][lane] = id.0;
}

/// Block and lane, as the compiler can see them to be within a plane.
#[inline(always)]
fn within_plane((block, lane): (usize, usize)) -> (usize, usize) {
    (block & (BLOCKS * BLOCKS - 1) as usize, lane & (LANES - 1))
}

/// Puts a triangle into one block of a plane, where it wins.
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
    if rules.behind.is_none() && rules.holes.is_none() && !equal.any_true() {
        // Nearly always.
        if !nearer.any_true() {
            return;
        }
        nearer.select(z, depth).store_slice(&mut plane.depth[block]);
        nearer.select(u32x16::splat(simd, id.0), ids).store_slice(&mut plane.ids[block]);
        return;
    }
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

/// Which of some samples, at positions in steps of 1/256 pixel, lie in holes of their triangles.
#[inline(always)]
pub(crate) fn ask<S: Simd>(
    holes: &dyn Holes,
    ids: [TriangleId; LANES],
    position: [i32x16<S>; 2],
    lanes: u32,
) -> u32 {
    let [mut x, mut y] = [[0.0; LANES]; 2];
    let [across, down] = position;
    let step = 1.0 / SUBPIXELS as f32;
    (f32x16::float_from(across) * step).store_slice(&mut x);
    (f32x16::float_from(down) * step).store_slice(&mut y);
    holes.holes(&Asked { ids, x, y, lanes })
}

/// Whether a triangle wins over an equally near one.
fn comes_first(id: TriangleId, other: TriangleId, rules: &Rules<'_>) -> bool {
    other == TriangleId::NONE || (rules.submitted)(id) < (rules.submitted)(other)
}

/// Whether a triangle comes after the last layer peeled off, in one lane of a block.
fn passed(
    behind: &Plane,
    block: usize,
    lane: usize,
    id: TriangleId,
    z: f32,
    rules: &Rules<'_>,
) -> bool {
    let (depth, other) = (behind.depth[block][lane], TriangleId(behind.ids[block][lane]));
    z < depth
        || z == depth
            && other != TriangleId::NONE
            && (rules.submitted)(id) > (rules.submitted)(other)
}
