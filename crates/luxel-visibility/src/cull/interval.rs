//! Intervals in lanes, which hold every rounded value of what lies in a box.

use crate::types::MAX_SIDE;
use luxel_math::{SUBPIXELS, Simd, f32x16, i32x16, mask32x16, prelude::*};

const SUBPIXEL_BITS: u32 = SUBPIXELS.ilog2();

/// An interval in every lane.
#[derive(Clone, Copy)]
pub(super) struct Interval<S: Simd> {
    pub(super) low: f32x16<S>,
    pub(super) high: f32x16<S>,
}

impl<S: Simd> Interval<S> {
    /// row . (x, y, z, 1) over a box, in the order of `row_times`.
    ///
    /// This and what follows are functions of their own at every level (`vectorize`): in one piece,
    /// sixteen lanes written out one by one take the compiler minutes.
    #[inline(always)]
    pub(super) fn row_times(row: &[f32; 4], axes: &[Self; 3]) -> Self {
        axes[0].low.simd.vectorize(
            #[inline(always)]
            || {
                let x = axes[0].scaled(row[0]);
                let y = axes[1].scaled(row[1]);
                let z = axes[2].scaled(row[2]);
                Self {
                    low: x.low + y.low + z.low + row[3],
                    high: x.high + y.high + z.high + row[3],
                }
            },
        )
    }

    #[inline(always)]
    pub(super) fn scaled(self, factor: f32) -> Self {
        let (low, high) = if factor < 0.0 { (self.high, self.low) } else { (self.low, self.high) };
        Self { low: low * factor, high: high * factor }
    }

    /// Divided by a positive interval.
    #[inline(always)]
    pub(super) fn divided_by(self, w: Self) -> Self {
        self.low.simd.vectorize(
            #[inline(always)]
            || {
                let zero = self.low.zero();
                let low = self.low / self.low.less(zero).select(w.low, w.high);
                let high = self.high / self.high.less(zero).select(w.high, w.low);
                Self { low, high }
            },
        )
    }

    /// Snapped to the window's grid, as vertices are.
    #[inline(always)]
    pub(super) fn snapped(self, centre: f32) -> Self {
        self.low.simd.vectorize(
            #[inline(always)]
            || Self {
                low: SimdFloat::round_ties_even(self.low + centre),
                high: SimdFloat::round_ties_even(self.high + centre),
            },
        )
    }

    #[inline(always)]
    pub(super) fn grown(self, by: f32x16<S>) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    /// Whether it lies within `low..=high`; never where it isn't a number.
    #[inline(always)]
    pub(super) fn within(self, low: f32, high: f32) -> mask32x16<S> {
        self.low.constant(low).less_or_equal(self.low)
            & self.high.less_or_equal(self.high.constant(high))
    }

    /// The pixels that hold a step of the interval, brought into 0..`size`, and whether there are
    /// any.
    #[inline(always)]
    pub(super) fn pixels(self, size: u32) -> (i32x16<S>, i32x16<S>, mask32x16<S>) {
        self.low.simd.vectorize(
            #[inline(always)]
            || {
                // Clamped to where the conversion to integers is exact; far outside stays outside.
                let limit = (2 * MAX_SIDE as i32 * SUBPIXELS) as f32;
                let low = i32x16::truncate_from(self.low.clamped(-limit, limit)) >> SUBPIXEL_BITS;
                let high = i32x16::truncate_from(self.high.clamped(-limit, limit)) >> SUBPIXEL_BITS;
                let last = size as i32 - 1;
                let inside = high.simd_ge(0) & low.simd_le(last);
                (low.max(0), high.min(last), inside)
            },
        )
    }
}
