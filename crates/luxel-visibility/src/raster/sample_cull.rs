//! Drops triangles that hold no sample of a tile, as most of a fine mesh do, sixteen at a time.
//!
//! A triangle is dropped if its box holds none, and, if its box holds one, if the triangle misses that
//! one: of a million triangles in 640x480 two fifths have a sample in their box, and one fifth covers
//! it. To ask here saves three of 37 million instructions a frame, since what is left waits in queues,
//! which takes longer than to be dropped; in 1920x1080 it costs as much as it saves.

use super::tile_points::{self, PointsWith, SamplePixels};
use crate::types::{CullFaces, Region};
use luxel_math::{LANES, SUBPIXELS, Simd, i16x32, i32x16, prelude::*};

/// Classes of small triangles: less than 1, 2, 4 and 8 pixels wide and high.
pub(crate) const SIZES: usize = 4;
const _: () = assert!(SUBPIXELS == 1 << 8, "sizes are whole pixels, the bits above");

/// First corners of sixteen triangles, second ones and third ones, with their depths.
pub(crate) type Corners = [PointsWith; 3];

/// Sixteen triangles, one a lane.
#[repr(C, align(64))]
pub(crate) struct TriangleGroup {
    pub(crate) corners: Corners,
    /// Width or height of each in whole pixels, bit by bit: what is below a power of two here is
    /// less than as many pixels wide and high.
    sizes: [i32; LANES],
}

impl TriangleGroup {
    pub(crate) fn new() -> Self {
        Self { corners: [[[0; 2]; LANES]; 3], sizes: [0; LANES] }
    }

    /// The size class of a triangle; [`SIZES`] or more for one that isn't small.
    #[inline(always)]
    pub(crate) fn size(&self, lane: usize) -> usize {
        let pixels = (self.sizes[lane] as u32 >> SUBPIXELS.ilog2()) & 0xff;
        (u32::BITS - pixels.leading_zeros()) as usize
    }

    /// The triangles that may hold one of the samples at `offsets` of some pixel of the region, a bit
    /// each; without those known to be culled, which all small ones are.
    #[inline(always)]
    pub(crate) fn may_hold_samples<S: Simd>(
        &mut self,
        simd: S,
        region: Region,
        offsets: &[[i32; 2]],
        cull: CullFaces,
    ) -> u32 {
        let [a, b, c] = &self.corners;
        let (a, _) = tile_points::with_depths(simd, a);
        let (b, _) = tile_points::with_depths(simd, b);
        let (c, _) = tile_points::with_depths(simd, c);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let extent = high - low;
        // What holds a sample of the tile and is as small as that has its corners where they seem to be.
        let large = extent & i16x32::splat(simd, LARGE);
        let mut held = 0;
        for &offset in offsets {
            let SamplePixels { first, last } = SamplePixels::new(low, high, offset, region);
            let count = last - first;
            let boxed = !tile_points::negative(count);
            let single = (count | large).bitcast::<i32x16<S>>().simd_eq(0).to_bitmask() as u32;
            held |= if single == 0 {
                boxed
            } else {
                let sample = (first << SUBPIXELS.ilog2()) + tile_points::splat(simd, offset);
                boxed & !(single & misses(a, b, c, sample))
            };
        }
        let words: i32x16<S> = extent.bitcast();
        (words | (words >> 16)).store_slice(&mut self.sizes);
        if cull == CullFaces::None {
            return held;
        }
        // The doubled area tells the side that is seen.
        let area = tile_points::dot(tile_points::turned(b - a), c - a);
        let seen = match cull {
            CullFaces::CounterClockwise => area.simd_gt(0),
            _ => area.simd_lt(0),
        };
        held & (seen | !large.bitcast::<i32x16<S>>().simd_eq(0)).to_bitmask() as u32
    }
}

/// The small triangles that hold a sample neither inside nor on an edge, whichever way they turn: two
/// edge functions have opposite signs.
#[inline(always)]
fn misses<S: Simd>(a: i16x32<S>, b: i16x32<S>, c: i16x32<S>, sample: i16x32<S>) -> u32 {
    let (ab, ac, from_a) = (tile_points::turned(b - a), tile_points::turned(c - a), sample - a);
    let e_ab = tile_points::dot(ab, from_a);
    let e_ac = tile_points::dot(ac, from_a);
    // Edge functions of all three sides add up to the doubled area, which is ab x ac.
    let e_bc = tile_points::dot(ab, c - a) - e_ab + e_ac;
    let e_ca = -e_ac;
    let below = e_ab | e_bc | e_ca;
    let above = e_ac | -e_ab | -e_bc;
    (below & above).simd_lt(0).to_bitmask() as u32
}

/// Bits that extents below 64 pixels have not.
const LARGE: i16 = -(64 * SUBPIXELS as i16);
