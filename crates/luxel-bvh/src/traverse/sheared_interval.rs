//! Which triangles of a block no ray of a packet passes.

use super::packet::RayInterval;
use super::target::RayTarget;
use crate::intersect::PADDING;
use crate::tree::{Block, VertexRows, WIDTH};
use luxel_math::{Simd, f32x8, prelude::*, u32x8};

/// The interval around a packet's rays in the form of the triangle test: see
/// [`ShearedRay`](crate::intersect::ShearedRay).
///
/// A ray that has all three vertices of a triangle on one side, left of it for example, misses it, and the test finds
/// so: its edge functions round, but don't turn their signs. It compares vertices that it has rounded: where a vertex
/// at X and Z lies beside a ray from x and z, by at most
///
/// ```text
/// 2^-24 (2 (|X| + |x|) + 3 (|Z| + |z|))
/// ```
///
/// The interval rounds by as much, and where rays share their reciprocal directions, their shears may still differ by
/// 2^-23. The margin is 12 times 2^-24 of both sums.
pub(super) struct ShearedInterval {
    least: [f32; 3],
    greatest: [f32; 3],
    shear: [[f32; 2]; 2],
    margin: [f32; 2],
}

impl ShearedInterval {
    #[inline(always)]
    pub(super) fn new(interval: &RayInterval, axes: [usize; 3], target: &RayTarget<'_>) -> Self {
        let (mut least, mut greatest, mut slack) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        for (to, axis) in axes.into_iter().enumerate() {
            let axis = axis.min(2);
            let [one, other] = [interval.near_origin[axis], interval.far_origin[axis]];
            (least[to], greatest[to]) = (one.min(other), one.max(other));
            let farthest = target.largest[axis] + one.abs().max(other.abs());
            slack[to] = PADDING * farthest;
        }
        let margin = [slack[0] + slack[2], slack[1] + slack[2]];
        Self { least, greatest, shear: interval.shear, margin }
    }

    /// The triangles of a block that rays may hit, a bit each.
    #[inline(always)]
    pub(super) fn passing<S: Simd>(&self, simd: S, block: Block<'_>, axes: [usize; 3]) -> u32 {
        let header = block.header();
        let all = u32::MAX >> (u32::BITS - header.count() as u32);
        if header.rows() != VertexRows::Shared {
            return all;
        }
        let row = |to: usize| u32x8::simd_from(simd, block.row(axes[to])).bitcast::<f32x8<S>>();
        let z = row(2);
        let (before, behind) = (z - self.greatest[2], z - self.least[2]);
        let mut sides = 0;
        for side in 0..2 {
            let [least, greatest] = self.shear[side];
            let (one, other) = (before * least, before * greatest);
            let (third, fourth) = (behind * least, behind * greatest);
            let low = one.min(other).min(third.min(fourth));
            let high = one.max(other).max(third.max(fourth));
            let at = row(side);
            let left = (at - self.least[side] - low).simd_lt(-self.margin[side]);
            let right = (at - self.greatest[side] - high).simd_gt(self.margin[side]);
            let bits = left.to_bitmask() as u32 | (right.to_bitmask() as u32) << WIDTH;
            sides |= bits << (2 * WIDTH * side);
        }
        // Which vertices a triangle has: three bits each.
        let words = block.triangle_words(simd);
        let sides = u32x8::splat(simd, sides);
        let last = u32x8::splat(simd, 7);
        let (a, b, c) = (words & last, (words >> 3) & last, (words >> 6) & last);
        let outside = (sides >> a) & (sides >> b) & (sides >> c) & 0x0101_0101;
        outside.simd_eq(0).to_bitmask() as u32 & all
    }
}
