//! Samples of a block become pixels: each distinct triangle of a pixel is lit once, at its covered
//! sample nearest the centre, and weighs its share of the samples.

use super::lane_compaction::Lit;
use crate::context::ShadingContext;
use crate::interpolate::Batch;
use crate::shade::{ThreadCache, shade, shade_together};
use crate::shadow::BATCHES;
use luxel_lighting::Silent;
use luxel_math::{LANES, Simd, f32x16, prelude::*, u32x16};
use luxel_visibility::{Tile, TriangleId};

/// Whether nothing is seen in a block.
pub(crate) fn is_empty(tile: &Tile, block: usize) -> bool {
    tile.planes().iter().all(|plane| plane.ids[block] == [TriangleId::NONE.0; LANES])
}

/// What all samples of a block see, if it is the same.
#[inline(always)]
pub(crate) fn single_triangle<S: Simd>(simd: S, tile: &Tile, block: usize) -> Option<u32> {
    let [first, others @ ..] = tile.planes() else { return None };
    let id = first.ids[block][0];
    let mut same = u32x16::simd_from(simd, first.ids[block]).simd_eq(id);
    for plane in others {
        same &= u32x16::simd_from(simd, plane.ids[block]).simd_eq(id);
    }
    same.all_true().then_some(id)
}

/// A pixel of a block where nothing is seen, if the backdrop is the same everywhere.
pub(crate) fn empty_pixel(scene: &ShadingContext<'_>) -> [f32; 4] {
    let [.., alpha] = scene.background;
    if alpha > 0.0 { scene.background } else { [0.0; 4] }
}

/// The pixels of a block where nothing is seen, if the backdrop is the same everywhere.
#[inline(always)]
pub(crate) fn empty_block<S: Simd>(simd: S, scene: &ShadingContext<'_>) -> [f32x16<S>; 4] {
    let [r, g, b, alpha] = empty_pixel(scene);
    let simd = f32x16::splat(simd, r);
    [simd, simd.constant(g), simd.constant(b), simd.constant(alpha)]
}

/// The pixels of a block all samples of whose pixels see the same; `is_single`: the same triangle in all
/// pixels. `within` a pixel lies the sample: [`nearest_sample`](crate::interpolate::nearest_sample).
#[inline(always)]
pub(crate) fn even_block<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    tile: &Tile,
    block: (usize, bool),
    within: [f32; 2],
    cache: &mut ThreadCache,
) -> [f32x16<S>; 4] {
    let batch = even_batch(tile, block, within);
    let lit = shade(f32x16::splat(simd, 0.0), scene, &batch, cache, &mut Silent);
    even_pixels(simd, lit)
}

/// [`even_block`] for blocks whose rays are traced together.
#[inline(always)]
pub(crate) fn even_blocks<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    tile: &Tile,
    [first, second]: [(usize, bool); BATCHES],
    within: [f32; 2],
    cache: &mut ThreadCache,
) -> [[f32x16<S>; 4]; BATCHES] {
    let batches = [even_batch(tile, first, within), even_batch(tile, second, within)];
    let [first, second] = shade_together(f32x16::splat(simd, 0.0), scene, &batches, cache);
    [even_pixels(simd, first), even_pixels(simd, second)]
}

/// The samples of a block all samples of whose pixels see the same.
#[inline(always)]
fn even_batch(tile: &Tile, (block, is_single): (usize, bool), within: [f32; 2]) -> Batch {
    Batch::even(tile, block, tile.planes()[0].ids[block], within, is_single)
}

/// Colours of a batch, with the backdrop's in the lanes that see nothing, if that isn't the same everywhere.
#[inline(always)]
pub(crate) fn over_backdrop<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    lit: [f32x16<S>; 4],
    cache: &mut ThreadCache,
) -> [f32x16<S>; 4] {
    let Some(backdrop) = scene.backdrop else { return lit };
    let vector = f32x16::splat(simd, 0.0);
    let unseen = vector.eq_mask(&batch.ids, TriangleId::NONE.0);
    if unseen == 0 {
        return lit;
    }
    let mut colors = [[0.0; LANES]; 4];
    for (stored, lanes) in colors.iter_mut().zip(lit) {
        lanes.store_slice(stored);
    }
    let position = |lane| batch.position(lane);
    backdrop.put(vector, unseen, &position, &mut cache.occlusion, &mut colors);
    let [r, g, b, alpha] = colors;
    [
        f32x16::simd_from(simd, r),
        f32x16::simd_from(simd, g),
        f32x16::simd_from(simd, b),
        f32x16::simd_from(simd, alpha),
    ]
}

/// Pixels of which each has one colour (straight) and alpha.
#[inline(always)]
pub(crate) fn even_pixels<S: Simd>(simd: S, lit: [f32x16<S>; 4]) -> [f32x16<S>; 4] {
    let [r, g, b, alpha] = lit;
    let zero = f32x16::splat(simd, 0.0);
    if alpha.equal(alpha.one()).all() {
        // All that is left of the sum below: -0 becomes 0.
        return [r + zero, g + zero, b + zero, alpha];
    }
    let mut sum = [zero; 4];
    add_share(&mut sum, lit, f32x16::splat(simd, 1.0));
    straight(sum)
}

/// The pixels of a block whose samples see several triangles.
#[inline(always)]
pub(crate) fn uneven_block<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    lit: &[Lit],
) -> [f32x16<S>; 4] {
    let share_of_one = 1.0 / scene.frame.samples().count() as f32;
    let mut sum = [f32x16::splat(simd, 0.0); 4];
    for Lit { shares, color, .. } in lit {
        let shares = f32x16::float_from(u32x16::simd_from(simd, *shares));
        let color = color.map(
            #[inline(always)]
            |channel| f32x16::simd_from(simd, channel),
        );
        add_share(&mut sum, color, shares * share_of_one);
    }
    straight(sum)
}

/// Adds what a part of the samples sees: colour times alpha, and alpha.
#[inline(always)]
pub(crate) fn add_share<N: Lanes>(sum: &mut [N; 4], [r, g, b, alpha]: [N; 4], share: N) {
    let weight = share * alpha;
    *sum = [sum[0] + r * weight, sum[1] + g * weight, sum[2] + b * weight, sum[3] + weight];
}

/// Divides colours by alpha; black where alpha is 0.
#[inline(always)]
pub(crate) fn straight<N: Lanes>([r, g, b, alpha]: [N; 4]) -> [N; 4] {
    let seen = alpha.zero().less(alpha);
    let divisor = alpha.select(seen, alpha.one());
    [r / divisor, g / divisor, b / divisor, alpha]
}
