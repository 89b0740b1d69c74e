//! Positions about the middle of a tile: x and y as the halves of one word.
//!
//! In steps of 1/256 pixel a tile reaches 2^13 from its middle, and small triangles that hold one of
//! its samples hardly farther. So both coordinates are moved, compared and subtracted at once, and a
//! sum of products of halves is an exact edge function: a million triangles in 640x480 take 42
//! million instructions instead of 49. Positions too far away for a half are brought to [`LIMIT`]: they
//! stay outside of the tile, on the side that they were on.

use crate::types::{Region, TILE};
use luxel_math::{SUBPIXELS, Simd, f32x16, i16x32, i32x16, prelude::*, u32x16};

/// Coordinates are from -LIMIT to LIMIT: samples' offsets can be added without overflow.
const LIMIT: i32 = (1 << 15) - 2 * SUBPIXELS;
const SHIFT: u32 = SUBPIXELS.ilog2();
const HALF: u32 = 16;

/// The middle pixel of a tile, of which the first pixel is known.
#[inline(always)]
pub(crate) fn middle_of(region: Region) -> [i32; 2] {
    [region.x + TILE / 2, region.y + TILE / 2]
}

/// One point in all lanes; coordinates fit their halves.
#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, [x, y]: [i32; 2]) -> i16x32<S> {
    i32x16::splat(simd, y << HALF | x & 0xffff).bitcast()
}

/// Window positions about a pixel.
#[inline(always)]
pub(crate) fn about<S: Simd>(
    x: i32x16<S>,
    y: i32x16<S>,
    [middle_x, middle_y]: [i32; 2],
) -> u32x16<S> {
    let x = (x - middle_x * SUBPIXELS).max(-LIMIT).min(LIMIT);
    let y = (y - middle_y * SUBPIXELS).max(-LIMIT).min(LIMIT);
    ((y << HALF) | (x & 0xffff)).bitcast()
}

#[inline(always)]
pub(crate) fn x_of<S: Simd>(points: i16x32<S>) -> i32x16<S> {
    (points.bitcast::<i32x16<S>>() << HALF) >> HALF
}

#[inline(always)]
pub(crate) fn y_of<S: Simd>(points: i16x32<S>) -> i32x16<S> {
    points.bitcast::<i32x16<S>>() >> HALF
}

/// (-y, x): turned by a right angle. Its product with another vector is the doubled signed area of
/// the triangle that both span.
#[inline(always)]
pub(crate) fn turned<S: Simd>(vectors: i16x32<S>) -> i16x32<S> {
    let negative = i16x32::splat(vectors.simd, 0) - vectors;
    let x_above = vectors.bitcast::<u32x16<S>>() << HALF;
    (x_above | (negative.bitcast::<u32x16<S>>() >> HALF)).bitcast()
}

/// The sum of products of both coordinates.
#[inline(always)]
pub(crate) fn dot<S: Simd>(a: i16x32<S>, b: i16x32<S>) -> i32x16<S> {
    a.pairwise_dot_product(b)
}

/// A bit for each lane of which a coordinate is negative.
#[inline(always)]
pub(crate) fn negative<S: Simd>(points: i16x32<S>) -> u32 {
    let words: i32x16<S> = points.bitcast();
    (words | (words << HALF)).simd_lt(0).to_bitmask() as u32
}

/// The pixels of a tile whose samples, at one offset, lie in boxes: first and last ones, about the
/// tile's middle. There are none where a last one lies before the first.
#[derive(Clone, Copy)]
pub(crate) struct SamplePixels<S: Simd> {
    pub(crate) first: i16x32<S>,
    pub(crate) last: i16x32<S>,
}

impl<S: Simd> SamplePixels<S> {
    #[inline(always)]
    pub(crate) fn new(
        low: i16x32<S>,
        high: i16x32<S>,
        [offset_x, offset_y]: [i32; 2],
        region: Region,
    ) -> Self {
        let simd = low.simd;
        // low <= 256 pixel + offset <= high
        let up = splat(simd, [SUBPIXELS - 1 - offset_x, SUBPIXELS - 1 - offset_y]);
        let down = splat(simd, [offset_x, offset_y]);
        let end = [region.width - 1 - TILE / 2, region.height - 1 - TILE / 2];
        Self {
            first: ((low + up) >> SHIFT).max(splat(simd, [-TILE / 2; 2])),
            last: ((high - down) >> SHIFT).min(splat(simd, end)),
        }
    }
}

/// Sixteen points and what is kept with each, side by side.
pub(crate) type PointsWith = [[u32; 2]; luxel_math::LANES];

/// Points, and the depths beside them.
#[inline(always)]
pub(crate) fn with_depths<S: Simd>(simd: S, lanes: &PointsWith) -> (i16x32<S>, f32x16<S>) {
    let (first, second) = lanes.as_flattened().split_at(luxel_math::LANES);
    let (points, depths) =
        simd.deinterleave_u32x16(u32x16::from_slice(simd, first), u32x16::from_slice(simd, second));
    (points.bitcast(), depths.bitcast())
}

/// Keeps points, and depths beside them.
#[inline(always)]
pub(crate) fn store_with_depths<S: Simd>(
    points: u32x16<S>,
    depths: f32x16<S>,
    lanes: &mut PointsWith,
) {
    let (first, second) = lanes.as_flattened_mut().split_at_mut(luxel_math::LANES);
    let (lower, upper) = points.simd.interleave_u32x16(points, depths.bitcast());
    lower.store_slice(first);
    upper.store_slice(second);
}
