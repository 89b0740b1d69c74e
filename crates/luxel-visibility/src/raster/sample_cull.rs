//! Drops triangles that hold no sample of a tile, as most of a fine mesh do, sixteen at a time.

use crate::types::{CullFaces, Region};
use luxel_math::{LANES, SUBPIXELS, Simd, i32x16, mask32x16, prelude::*};

/// Size classes of small triangles: less than 1, 2, 4 and 8 pixels wide and high.
pub(crate) const SIZES: [i32; 4] = [SUBPIXELS, 2 * SUBPIXELS, 4 * SUBPIXELS, 8 * SUBPIXELS];

/// First corners of sixteen triangles, second ones and third ones: x and y, in steps of 1/256 pixel,
/// side by side, so that they are moved at once.
pub(crate) type Corners = [[[i32; 2]; LANES]; 3];

/// Sixteen triangles, one a lane.
pub(crate) struct TriangleGroup {
    pub(crate) corners: Corners,
}

/// Result of the sample-coverage cull, a bit for each triangle.
pub(crate) struct SampleCull {
    /// Those that may hold a sample.
    pub(crate) held: u32,
    /// The first of [`SIZES`] that each is less wide and high than, whether it holds one or not; as
    /// many as there are if none.
    pub(crate) sizes: [i32; LANES],
}

/// The extent of triangles in one direction.
struct Extent<S: Simd> {
    low: i32x16<S>,
    high: i32x16<S>,
}

impl TriangleGroup {
    pub(crate) fn new() -> Self {
        Self { corners: [[[0; 2]; LANES]; 3] }
    }

    /// The triangles whose box holds one of the samples at `offsets` of some pixel of the region;
    /// without those known to be culled or to have no area, which all small ones are.
    #[inline(always)]
    pub(crate) fn may_hold_samples<S: Simd>(
        &self,
        simd: S,
        region: Region,
        offsets: &[[i32; 2]],
        cull: CullFaces,
    ) -> SampleCull {
        let [(ax, ay), (bx, by), (cx, cy)] = in_lanes(simd, &self.corners);
        let across = Extent::of(ax, bx, cx);
        let down = Extent::of(ay, by, cy);
        let mut held = mask32x16::splat(simd, false);
        for offset in offsets {
            held |= across.holds(offset[0], region.x, region.width)
                & down.holds(offset[1], region.y, region.height);
        }

        // Where products of extents fit i32, the doubled area tells the side that is seen.
        let small =
            (across.high - across.low).simd_lt(SMALL) & (down.high - down.low).simd_lt(SMALL);
        let area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        let culled = match cull {
            CullFaces::None => area.simd_eq(0),
            CullFaces::Clockwise => area.simd_ge(0),
            CullFaces::CounterClockwise => area.simd_le(0),
        };
        let held = held & !(small & culled);
        let extent = (across.high - across.low).max(down.high - down.low);
        let (zero, one) = (i32x16::splat(simd, 0), i32x16::splat(simd, 1));
        let mut size = zero;
        for limit in SIZES {
            size += extent.simd_lt(limit).select(zero, one);
        }
        let mut sizes = [0; LANES];
        size.store_slice(&mut sizes);
        SampleCull { held: held.to_bitmask() as u32, sizes }
    }
}

/// x and y of each corner.
#[inline(always)]
pub(crate) fn in_lanes<S: Simd>(simd: S, [a, b, c]: &Corners) -> [(i32x16<S>, i32x16<S>); 3] {
    [apart(simd, a), apart(simd, b), apart(simd, c)]
}

#[inline(always)]
fn apart<S: Simd>(simd: S, corners: &[[i32; 2]; LANES]) -> (i32x16<S>, i32x16<S>) {
    let (first, second) = corners.as_flattened().split_at(LANES);
    simd.deinterleave_i32x16(i32x16::from_slice(simd, first), i32x16::from_slice(simd, second))
}

/// The difference of two products of numbers below this fits i32.
const SMALL: i32 = 1 << 15;

impl<S: Simd> Extent<S> {
    #[inline(always)]
    fn of(a: i32x16<S>, b: i32x16<S>, c: i32x16<S>) -> Self {
        Self { low: a.min(b).min(c), high: a.max(b).max(c) }
    }

    /// Whether the extent holds the place at `offset` in one of `count` pixels from `first` on.
    #[inline(always)]
    fn holds(&self, offset: i32, first: i32, count: i32) -> mask32x16<S> {
        let shift = SUBPIXELS.ilog2();
        // low <= 256 pixel + offset <= high
        let from = (self.low + (SUBPIXELS - 1 - offset)) >> shift;
        let to = (self.high - offset) >> shift;
        from.simd_le(to) & from.simd_lt(first + count) & to.simd_ge(first)
    }
}
