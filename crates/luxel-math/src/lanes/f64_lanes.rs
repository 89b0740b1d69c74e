//! [`F64Lanes`]: the `f64` beside a [`Lanes`], for places that are far apart.
//!
//! Where coordinates of a scene meet those of a window, differences are much smaller than what they
//! are taken of, and `f32` would lose them. Such steps are written over `F64Lanes`, once for one value
//! and for sixteen lanes, and give the same bits in both.

use crate::{LANES, Lanes};
use fearless_simd::{
    Simd, f32x8, f32x16, f64x4, f64x8, mask32x8, mask32x16, mask64x4, mask64x8, prelude::*,
};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// One `f64`, or one for each lane.
pub trait F64Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The `f32` beside it.
    type F32: Lanes<F64 = Self>;

    /// `value` in every lane; `self` selects the lane type.
    fn constant(self, value: f64) -> Self;
    /// The value without its sign.
    fn abs(self) -> Self;
    /// The correctly rounded square root.
    fn sqrt(self) -> Self;
    /// `self` where the mask is true, `other` where it is false.
    fn select(self, mask: <Self::F32 as Lanes>::Mask, other: Self) -> Self;
    /// `then` where this is above 0, `otherwise` elsewhere. Faster than a mask, which has to become one for `f64` first.
    fn if_positive(self, then: Self, otherwise: Self) -> Self;
    /// Whether it is above 0.
    fn is_positive(self) -> <Self::F32 as Lanes>::Mask;
    /// Rounded to `f32`, ties to even.
    fn to_f32(self) -> Self::F32;
    /// Reads the values of all lanes; `self` selects the lane type.
    fn load(self, values: &[f64; LANES]) -> Self;
    /// Writes the values of all lanes.
    fn store(self, values: &mut [f64; LANES]);
    /// Loads a 4-component row for each lane: lane i of column c is component c of `row(i)`; `self`
    /// selects the lane type. Mark the closure `#[inline(always)]`.
    fn load_transposed<'r>(self, row: impl Fn(usize) -> &'r [f64; 4]) -> [Self; 4];
    /// The reverse of [`F64Lanes::load_transposed`]: calls `put(i, row)` for each lane i. Mark the
    /// closure `#[inline(always)]`.
    fn store_transposed(columns: [Self; 4], put: impl FnMut(usize, [f64; 4]));
}

impl F64Lanes for f64 {
    type F32 = f32;

    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::abs(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    #[inline(always)]
    fn select(self, mask: bool, other: Self) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self > 0.0 { then } else { otherwise }
    }
    #[inline(always)]
    fn is_positive(self) -> bool {
        self > 0.0
    }
    #[inline(always)]
    fn to_f32(self) -> f32 {
        self as f32
    }
    #[inline(always)]
    fn load(self, values: &[Self; LANES]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn store(self, values: &mut [Self; LANES]) {
        values[0] = self;
    }
    #[inline(always)]
    fn load_transposed<'r>(self, row: impl Fn(usize) -> &'r [Self; 4]) -> [Self; 4] {
        *row(0)
    }
    #[inline(always)]
    fn store_transposed(columns: [Self; 4], mut put: impl FnMut(usize, [Self; 4])) {
        put(0, columns);
    }
}

/// Four rows as four columns, by quarters, as those of `f32`.
#[inline(always)]
pub(super) fn transposed<S: Simd>([a, b, c, d]: [f64x4<S>; 4]) -> [f64x4<S>; 4] {
    let simd = a.simd;
    let ((a0, a2), (b0, b2)) = (simd.split_f64x4(a), simd.split_f64x4(b));
    let ((c0, c2), (d0, d2)) = (simd.split_f64x4(c), simd.split_f64x4(d));
    let ((first, second), (third, fourth)) = (a0.interleave(b0), a2.interleave(b2));
    let lower = (c0.interleave(d0), c2.interleave(d2));
    [
        simd.combine_f64x2(first, lower.0.0),
        simd.combine_f64x2(second, lower.0.1),
        simd.combine_f64x2(third, lower.1.0),
        simd.combine_f64x2(fourth, lower.1.1),
    ]
}

/// Lanes with the digits of an `f64`, in two halves.
macro_rules! wide_lanes {
    (
        $F64Lanes:ident, $Lanes:ident, $Mask:ident, $half:literal, $Half:ident, $HalfMask:ident,
        $widen:ident, $narrow:ident
    ) => {
        #[doc = concat!("The wide side of [`", stringify!($Lanes), "`]: as many `f64`.")]
        #[derive(Clone, Copy, Debug)]
        pub struct $F64Lanes<S: Simd> {
            pub(super) low: $Half<S>,
            pub(super) high: $Half<S>,
        }

        impl<S: Simd> $F64Lanes<S> {
            /// The exact values of so many `f32`.
            #[inline(always)]
            pub(crate) fn of(narrow: $Lanes<S>) -> Self {
                let (low, high) = narrow.simd.$widen(narrow);
                Self { low, high }
            }
        }

        impl<S: Simd> F64Lanes for $F64Lanes<S> {
            type F32 = $Lanes<S>;

            #[inline(always)]
            fn constant(self, value: f64) -> Self {
                let half = $Half::splat(self.low.simd, value);
                Self { low: half, high: half }
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self { low: self.low.abs(), high: self.high.abs() }
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self { low: self.low.sqrt(), high: self.high.sqrt() }
            }
            #[inline(always)]
            fn select(self, mask: $Mask<S>, other: Self) -> Self {
                let (simd, bits) = (self.low.simd, mask.to_bitmask());
                let low = $HalfMask::from_bitmask(simd, bits & ((1 << $half) - 1));
                let high = $HalfMask::from_bitmask(simd, bits >> $half);
                Self {
                    low: low.select(self.low, other.low),
                    high: high.select(self.high, other.high),
                }
            }
            #[inline(always)]
            fn if_positive(self, then: Self, otherwise: Self) -> Self {
                let zero = $Half::splat(self.low.simd, 0.0);
                Self {
                    low: self.low.simd_gt(zero).select(then.low, otherwise.low),
                    high: self.high.simd_gt(zero).select(then.high, otherwise.high),
                }
            }
            #[inline(always)]
            fn is_positive(self) -> $Mask<S> {
                let simd = self.low.simd;
                let zero = $Half::splat(simd, 0.0);
                let low = self.low.simd_gt(zero).to_bitmask();
                let high = self.high.simd_gt(zero).to_bitmask();
                $Mask::from_bitmask(simd, low | high << $half)
            }
            #[inline(always)]
            fn to_f32(self) -> $Lanes<S> {
                self.low.simd.$narrow(self.low, self.high)
            }
            #[inline(always)]
            fn load(self, values: &[f64; LANES]) -> Self {
                let simd = self.low.simd;
                let low = $Half::from_slice(simd, &values[..$half]);
                Self { low, high: $Half::from_slice(simd, &values[$half..2 * $half]) }
            }
            #[inline(always)]
            fn store(self, values: &mut [f64; LANES]) {
                self.low.store_slice(&mut values[..$half]);
                self.high.store_slice(&mut values[$half..2 * $half]);
            }
            #[inline(always)]
            fn load_transposed<'r>(self, row: impl Fn(usize) -> &'r [f64; 4]) -> [Self; 4] {
                let simd = self.low.simd;
                let mut columns = [[0.0; 2 * $half]; 4];
                for four in (0..2 * $half).step_by(4) {
                    let mut lines = [f64x4::splat(simd, 0.0); 4];
                    for (at, line) in lines.iter_mut().enumerate() {
                        *line = f64x4::simd_from(simd, *row(four + at));
                    }
                    for (column, lanes) in columns.iter_mut().zip(transposed(lines)) {
                        lanes.store_slice(&mut column[four..four + 4]);
                    }
                }
                let mut lanes = [self; 4];
                for (lane, column) in lanes.iter_mut().zip(columns) {
                    lane.low = $Half::from_slice(simd, &column[..$half]);
                    lane.high = $Half::from_slice(simd, &column[$half..]);
                }
                lanes
            }
            #[inline(always)]
            fn store_transposed(columns: [Self; 4], mut put: impl FnMut(usize, [f64; 4])) {
                let simd = columns[0].low.simd;
                let mut stored = [[0.0; 2 * $half]; 4];
                for (stored, column) in stored.iter_mut().zip(columns) {
                    column.low.store_slice(&mut stored[..$half]);
                    column.high.store_slice(&mut stored[$half..]);
                }
                for four in (0..2 * $half).step_by(4) {
                    let mut lines = [f64x4::splat(simd, 0.0); 4];
                    for (line, stored) in lines.iter_mut().zip(&stored) {
                        *line = f64x4::from_slice(simd, &stored[four..four + 4]);
                    }
                    for (at, line) in transposed(lines).into_iter().enumerate() {
                        put(four + at, line.into());
                    }
                }
            }
        }

        impl<S: Simd> Add for $F64Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self { low: self.low + other.low, high: self.high + other.high }
            }
        }

        impl<S: Simd> Sub for $F64Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self { low: self.low - other.low, high: self.high - other.high }
            }
        }

        impl<S: Simd> Mul for $F64Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self { low: self.low * other.low, high: self.high * other.high }
            }
        }

        impl<S: Simd> Div for $F64Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                Self { low: self.low / other.low, high: self.high / other.high }
            }
        }

        impl<S: Simd> Neg for $F64Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self { low: -self.low, high: -self.high }
            }
        }
    };
}

wide_lanes!(F64x16, f32x16, mask32x16, 8, f64x8, mask64x8, widen_f32x16, narrow_f64x8);
wide_lanes!(F64x8, f32x8, mask32x8, 4, f64x4, mask64x4, widen_f32x8, narrow_f64x4);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LANES, SimdLevel};
    use fearless_simd::dispatch;

    #[inline(always)]
    fn worked<N: Lanes>(a: N, b: N) -> [N; 8] {
        let (a, b) = (a.to_f64(), b.to_f64());
        let far = a.constant(1e8) + b;
        let mut stored = [0.0; LANES];
        far.store(&mut stored);
        [
            (far - a.constant(1e8)).to_f32(),
            (-a * b).to_f32(),
            (b / far).to_f32(),
            (a.abs() + b.abs()).to_f32(),
            a.abs().sqrt().to_f32(),
            a.select(b.is_positive(), b).to_f32(),
            b.if_positive(a, b).to_f32(),
            (a.load(&stored) - a.constant(1e8)).to_f32(),
        ]
    }

    #[inline(always)]
    fn sixteen<S: Simd>(simd: S, a: [f32; LANES], b: [f32; LANES]) -> ([[f32; LANES]; 8], u64) {
        let [a, b] = [a, b].map(|lanes| f32x16::simd_from(simd, lanes));
        let worked = worked(a, b).map(|result| std::array::from_fn(|lane| result.lane(lane)));
        (worked, a.to_f64().is_positive().to_bitmask())
    }

    #[test]
    fn lanes_have_the_bits_of_one_value_at_a_time() {
        for round in 0..100 {
            let value = |lane: usize, seed: u32| {
                let bits = (round * 16 + lane as u32 + 1).wrapping_mul(seed);
                (bits as f32 / u32::MAX as f32 - 0.5)
                    * [1e-10, 1e-3, 1.0, 1e5, 1e10][round as usize % 5]
            };
            let a: [f32; LANES] = std::array::from_fn(|lane| value(lane, 2_654_435_761));
            let b: [f32; LANES] = std::array::from_fn(|lane| value(lane, 2_246_822_519));
            for level in SimdLevel::available() {
                let level = level.resolve().expect("it is available");
                let (lanes, positive) = dispatch!(level, simd => sixteen(simd, a, b));
                for lane in 0..LANES {
                    let one = worked(a[lane], b[lane]);
                    for (lanes, one) in lanes.iter().zip(one) {
                        assert_eq!(lanes[lane].to_bits(), one.to_bits());
                    }
                    assert_eq!(positive >> lane & 1 == 1, a[lane] > 0.0);
                }
            }
        }
    }

    /// Rows through columns and back, and the sum of columns 1 and 2 weighted to tell them apart.
    #[inline(always)]
    fn through_columns<N: Lanes>(simd: N, rows: &[[f64; 4]; LANES]) -> [([f64; 4], f32); LANES] {
        let columns = simd.to_f64().load_transposed(
            #[inline(always)]
            |lane| &rows[lane],
        );
        let mut back = [([0.0; 4], 0.0); LANES];
        F64Lanes::store_transposed(
            columns,
            #[inline(always)]
            |lane, row| back[lane].0 = row,
        );
        let told = (columns[1] + columns[2] * columns[2].constant(1000.0)).to_f32();
        for (lane, (_, value)) in back.iter_mut().enumerate() {
            if simd.all_lanes() >> lane & 1 == 1 {
                *value = told.lane(lane);
            }
        }
        back
    }

    #[test]
    fn a_lane_of_a_column_is_a_component_of_its_row_and_the_way_back_finds_it() {
        let rows = std::array::from_fn(|row| std::array::from_fn(|at| (row * 4 + at) as f64));
        for level in SimdLevel::available() {
            let level = level.resolve().unwrap();
            let found = [
                (LANES, dispatch!(level, simd => through_columns(f32x16::splat(simd, 0.0), &rows))),
                (8, dispatch!(level, simd => through_columns(f32x8::splat(simd, 0.0), &rows))),
                (1, through_columns(0.0_f32, &rows)),
            ];
            for (lanes, found) in found {
                for lane in 0..lanes {
                    let told = (rows[lane][1] + rows[lane][2] * 1000.0) as f32;
                    assert_eq!(found[lane], (rows[lane], told), "{lanes} lanes at {level:?}");
                }
            }
        }
    }

    #[test]
    fn what_f32_would_lose_is_kept() {
        let [kept, ..] = worked(1.0_f32, 0.25);
        assert_eq!(kept, 0.25);
    }
}
