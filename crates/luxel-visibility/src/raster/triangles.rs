//! Triangles one by one into the samples of a tile.
//!
//! Where more than depth decides at a sample, another copy does it, which leaves the registers to the plain one: a block
//! takes 57 instructions, and 33 more where something is put, instead of 120.

use super::buffer::{Plane, Tile};
use super::rules::{Rules, ask, comes_first, passed, put, wins};
use super::setup::Triangle;
use super::sink::{Sink, cover};
use crate::types::{Asked, BLOCK, BLOCKS, Holes, LANE_X, LANE_Y, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, lanes_of, mask32x16, prelude::*, u32x16};

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
    if rules.holes.is_none()
        && rules.behind.is_none()
        && tile.last_drawn.repeats(triangle, id, |first| comes_first(first, id, rules))
    {
        return;
    }
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
    let region = tile.region;
    for (sample, &offset) in rules.offsets.iter().enumerate() {
        if rules.behind.is_none() && rules.holes.is_none() {
            let sink = &mut SampleSink::<true> { id, rules, tile, sample };
            cover(simd, triangle, region, offset, sink);
        } else {
            cover_by_all_rules(simd, triangle, &mut SampleSink { id, rules, tile, sample });
        }
    }
}

/// Covers samples where more than depth decides at them: outlined, so that the
/// common case has the registers for itself.
#[inline(never)]
fn cover_by_all_rules<S: Simd>(simd: S, triangle: &Triangle, sink: &mut SampleSink<'_, false>) {
    let (region, offset) = (sink.tile.region, sink.rules.offsets[sink.sample]);
    simd.vectorize(
        #[inline(always)]
        || cover(simd, triangle, region, offset, sink),
    );
}

/// Puts a triangle into one sample of a tile's pixels where it wins; `PLAIN` where depth alone decides.
struct SampleSink<'t, const PLAIN: bool> {
    id: TriangleId,
    rules: &'t Rules<'t>,
    tile: &'t mut Tile,
    sample: usize,
}

impl<const PLAIN: bool> Sink for SampleSink<'_, PLAIN> {
    #[inline(always)]
    fn few(&mut self, pixels: [i32; 4]) {
        self.tile.touch(pixels);
    }

    #[inline(always)]
    fn blocks<S: Simd>(
        &mut self,
        simd: S,
        row: i32,
        blocks: u32,
        high: f32x16<S>,
        many: bool,
    ) -> u32 {
        let visible = self.tile.visible_blocks(simd, row, blocks, high, many);
        if visible != 0 {
            self.tile.summary.touch_blocks(row as usize, visible);
        }
        visible
    }

    #[inline(always)]
    fn block<S: Simd>(&mut self, simd: S, covered: mask32x16<S>, z: f32x16<S>, block: usize) {
        let Self { id, rules, sample, .. } = *self;
        if PLAIN {
            put_nearer(simd, covered, z, id, rules, &mut self.tile.planes[sample], block);
        } else {
            draw_block(simd, covered, z, id, rules, self.tile, sample, block);
        }
    }

    #[inline(always)]
    fn sample(&mut self, [column, row]: [i32; 2], position: [i32; 2], z: f32) {
        let place = Tile::place(column, row);
        if !wins(self.id, z, place, self.rules, self.tile, self.sample) {
            return;
        }
        let is_hole = |holes: &dyn Holes| holes.holes(&Asked::one(self.id, position)) != 0;
        if !PLAIN && self.rules.holes.is_some_and(is_hole) {
            return;
        }
        put(self.id, z, place, self.tile, self.sample);
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
