//! [`Number`]: what one `f32` and sixteen lanes of them have in common.
//!
//! Formulas are written over `Number` once. Run for one value they answer a question about one
//! pixel, run for sixteen they draw; both give the same bits, because each operation here is one
//! IEEE 754 operation (or a comparison and a choice) in both.
//!
//! Functions over `Number` are `#[inline(always)]` and never closures: a call that isn't inlined
//! into the dispatched kernel loses its instruction set and passes vectors through memory.

use crate::lanes::{LANES, has_wide_registers};
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Level;
use fearless_simd::{
    ExtractToken, Simd, f32x8, f32x16, i32x8, i32x16, mask32x8, mask32x16, prelude::*, u32x8,
    u32x16,
};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

mod wide;

pub use wide::{Wide, Wide8, Wide16};

/// One truth value, or one for each lane.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// Whether any lane is true.
    fn any(self) -> bool;
    /// Whether every lane is true.
    fn all(self) -> bool;
    /// The same truth value in every lane.
    fn splat_like(self, value: bool) -> Self;
    /// A bit for each lane, the first lane's lowest; one bit for a `bool`.
    fn bits(self) -> u32;
}

/// Work that can be done on any part of sixteen lanes: see [`Number::piecewise`].
pub trait Piecewise {
    /// Does it from lane `first` on, for as many lanes as a `N` has; `like` tells only the kind.
    fn piece<N: Number>(&mut self, like: N, first: usize);
}

/// One `f32`, or one for each of sixteen lanes (or, for [a part](Number::piecewise) of them, eight).
///
/// `min`, `max` and `select` are defined by comparison (`a < b ? a : b`), so that a NaN has the
/// same effect everywhere: where it is the first operand, the second is the result.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The outcome of comparisons.
    type Mask: Mask;
    /// The `f64` beside it.
    type Wide: Wide<Narrow = Self>;

    /// The same value with the digits of an `f64`.
    fn widened(self) -> Self::Wide;
    /// `value` in every lane; `self` tells only the kind of number.
    fn constant(self, value: f32) -> Self;
    /// The correctly rounded square root.
    fn sqrt(self) -> Self;
    /// The value without its sign.
    fn abs(self) -> Self;
    /// The largest whole number not above the value.
    fn floor(self) -> Self;
    /// The nearest whole number, ties to even.
    fn round_ties_even(self) -> Self;
    /// `self < other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `self <= other`.
    fn less_or_equal(self, other: Self) -> Self::Mask;
    /// `self == other`.
    fn equal(self, other: Self) -> Self::Mask;
    /// `self` where the mask is true, `other` where it is false.
    fn select(self, mask: Self::Mask, other: Self) -> Self;

    /// For a positive normal number x = m 2^e with m in [sqrt(1/2), sqrt(2)): (m, e).
    fn mantissa_and_exponent(self) -> (Self, Self);
    /// `self` 2^e for a whole number `exponent` from -126 to 127.
    fn scale_by_exponent(self, exponent: Self) -> Self;
    /// The value of one lane (of the only one, for an `f32`).
    fn lane(self, lane: usize) -> f32;
    /// A number whose lane i has the value `of(i)`; only lane 0 is asked for an `f32`.
    fn each_lane(self, of: impl FnMut(usize) -> f32) -> Self;
    /// A number of values from the `first` on; `self` tells only the kind.
    fn load(self, values: &[f32; LANES], first: usize) -> Self;
    /// Rows as columns: lane i of number c is component c of `row(i)`; `self` tells only the kind.
    /// The closure is to be marked `#[inline(always)]`.
    fn columns<'r>(self, row: impl Fn(usize) -> &'r [f32; 8]) -> [Self; 8];
    /// Columns as rows: `put(i, row)` is called for each lane i, with its components in order. The
    /// closure is to be marked `#[inline(always)]`.
    fn rows(columns: [Self; 8], put: impl FnMut(usize, [f32; 8]));
    /// Writes the values of all lanes, from the `first` on.
    fn store(self, values: &mut [f32; LANES], first: usize);
    /// Writes whole numbers from 0 to 2^24 as integers, from the `first` on.
    fn store_whole(self, values: &mut [u32; LANES], first: usize);
    /// Calls `work` with each lane whose bit is set; an `f32` has only lane 0. `self` tells only the
    /// kind. The closure is to be marked `#[inline(always)]`.
    fn visit(self, lanes: u32, work: impl FnMut(usize));
    /// The number with another value in one lane; an `f32` has only lane 0.
    fn with_lane(self, lane: usize, value: f32) -> Self;
    /// The mask whose lane i is bit i; `self` tells only the kind of number.
    fn mask_of(self, bits: u32) -> Self::Mask;
    /// The lanes of `values` that are `value`, as bits; `self` tells only the kind of number:
    /// fewer lanes than all look at the first ones.
    fn lanes_equal(self, values: &[u32; LANES], value: u32) -> u32;
    /// Lanes of `values`, four rows of four, that neither the lane before them nor the one above has the
    /// value of, as bits: each value that occurs is in at least one of them. `self` tells only the
    /// kind of number: fewer lanes than all look at the first ones.
    fn lanes_that_begin(self, values: &[u32; LANES]) -> u32;
    /// Runs work with the instruction set of this kind of number. The closure is to be marked
    /// `#[inline(always)]`; around it a function may then stay out of its callers.
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R;

    /// Does work on all lanes that takes more values at once than there are registers: in pieces.
    fn piecewise(self, work: &mut impl Piecewise);

    /// A bit for each lane.
    #[inline(always)]
    fn all_lanes(self) -> u32 {
        self.zero().equal(self.zero()).bits()
    }

    /// 0 in every lane.
    #[inline(always)]
    fn zero(self) -> Self {
        self.constant(0.0)
    }

    /// 1 in every lane.
    #[inline(always)]
    fn one(self) -> Self {
        self.constant(1.0)
    }

    /// The smaller of two.
    #[inline(always)]
    fn minimum(self, other: Self) -> Self {
        self.select(self.less(other), other)
    }

    /// The larger of two.
    #[inline(always)]
    fn maximum(self, other: Self) -> Self {
        self.select(other.less(self), other)
    }

    /// The value brought into `low..=high`.
    #[inline(always)]
    fn limited(self, low: f32, high: f32) -> Self {
        self.maximum(self.constant(low)).minimum(self.constant(high))
    }

    /// max(x, 0), as the lighting equation wants it for cosines.
    #[inline(always)]
    fn positive_part(self) -> Self {
        self.maximum(self.zero())
    }

    /// `self` where the mask is true, 0 elsewhere.
    #[inline(always)]
    fn only_where(self, mask: Self::Mask) -> Self {
        self.select(mask, self.zero())
    }
}

impl Mask for bool {
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn splat_like(self, value: bool) -> Self {
        value
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(self)
    }
}

/// Bits of the mantissa of an `f32`.
const MANTISSA_BITS: u32 = 23;
/// What the exponent field of an `f32` holds for 2^0.
const EXPONENT_BIAS: i32 = 127;
/// The bits of sqrt(1/2), rounded up: where the mantissa's range begins.
const SQRT_HALF_BITS: i32 = 0x3f35_04f4;

impl Number for f32 {
    type Mask = bool;
    type Wide = f64;

    #[inline(always)]
    fn widened(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn constant(self, value: f32) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::abs(self)
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Self::floor(self)
    }
    #[inline(always)]
    fn round_ties_even(self) -> Self {
        Self::round_ties_even(self)
    }
    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn equal(self, other: Self) -> bool {
        self == other
    }
    #[inline(always)]
    fn select(self, mask: bool, other: Self) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn mantissa_and_exponent(self) -> (Self, Self) {
        let bits = self.to_bits() as i32;
        let exponent = (bits - SQRT_HALF_BITS) >> MANTISSA_BITS;
        let mantissa = Self::from_bits((bits - (exponent << MANTISSA_BITS)) as u32);
        (mantissa, exponent as Self)
    }
    #[inline(always)]
    fn scale_by_exponent(self, exponent: Self) -> Self {
        let bits = (exponent as i32 + EXPONENT_BIAS) << MANTISSA_BITS;
        self * Self::from_bits(bits as u32)
    }
    #[inline(always)]
    fn lane(self, _lane: usize) -> f32 {
        self
    }
    #[inline(always)]
    fn each_lane(self, mut of: impl FnMut(usize) -> Self) -> Self {
        of(0)
    }
    #[inline(always)]
    fn load(self, values: &[Self; LANES], first: usize) -> Self {
        values[first]
    }
    #[inline(always)]
    fn columns<'r>(self, row: impl Fn(usize) -> &'r [Self; 8]) -> [Self; 8] {
        *row(0)
    }
    #[inline(always)]
    fn rows(columns: [Self; 8], mut put: impl FnMut(usize, [Self; 8])) {
        put(0, columns);
    }
    #[inline(always)]
    fn store(self, values: &mut [Self; LANES], first: usize) {
        values[first] = self;
    }
    #[inline(always)]
    fn store_whole(self, values: &mut [u32; LANES], first: usize) {
        values[first] = self as u32;
    }
    #[inline(always)]
    fn visit(self, lanes: u32, mut work: impl FnMut(usize)) {
        if lanes & 1 == 1 {
            work(0);
        }
    }
    #[inline(always)]
    fn with_lane(self, lane: usize, value: Self) -> Self {
        if lane == 0 { value } else { self }
    }
    #[inline(always)]
    fn mask_of(self, bits: u32) -> bool {
        bits & 1 == 1
    }
    #[inline(always)]
    fn lanes_equal(self, values: &[u32; LANES], value: u32) -> u32 {
        u32::from(values[0] == value)
    }
    #[inline(always)]
    fn lanes_that_begin(self, _values: &[u32; LANES]) -> u32 {
        1
    }
    #[inline(always)]
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
    #[inline(always)]
    fn piecewise(self, work: &mut impl Piecewise) {
        work.piece(self, 0);
    }
}

/// Whether the instruction set's own minimum and maximum are `a < b ? a : b` and `a > b ? a : b`, bit
/// for bit, with NaN and both zeros: x86's are, others treat NaN in ways of their own.
#[inline(always)]
fn compares_in_min_and_max<S: Simd>(simd: S) -> bool {
    match simd.level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Sse2(_) | Level::Sse4_2(_) | Level::Avx2(_) | Level::Avx512(_) => true,
        _ => false,
    }
}

/// Eight rows as eight columns: an index of three bits for the row and three for the column, whose
/// six bits each perfect shuffle turns by one (Stone 1971).
#[inline(always)]
fn transposed<S: Simd>(mut lines: [f32x8<S>; 8]) -> [f32x8<S>; 8] {
    for _ in 0..3 {
        let before = lines;
        for at in 0..4 {
            (lines[2 * at], lines[2 * at + 1]) = before[at].interleave(before[at + 4]);
        }
    }
    lines
}

/// Lanes as a kind of number.
macro_rules! number_of_lanes {
    ($count:literal, $Lanes:ident, $Mask:ident, $Ints:ident, $Words:ident, $Wide:ident) => {
        impl<S: Simd> Mask for $Mask<S> {
            #[inline(always)]
            fn any(self) -> bool {
                self.any_true()
            }
            #[inline(always)]
            fn all(self) -> bool {
                self.all_true()
            }
            #[inline(always)]
            fn splat_like(self, value: bool) -> Self {
                Self::splat(self.token(), value)
            }
            #[inline(always)]
            fn bits(self) -> u32 {
                self.to_bitmask() as u32
            }
        }

        impl<S: Simd> Number for $Lanes<S> {
            type Mask = $Mask<S>;
            type Wide = $Wide<S>;

            #[inline(always)]
            fn widened(self) -> $Wide<S> {
                $Wide::of(self)
            }

            #[inline(always)]
            fn constant(self, value: f32) -> Self {
                Self::splat(self.simd, value)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                SimdFloat::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                SimdBase::abs(self)
            }
            #[inline(always)]
            fn floor(self) -> Self {
                SimdFloat::floor(self)
            }
            #[inline(always)]
            fn round_ties_even(self) -> Self {
                SimdFloat::round_ties_even(self)
            }
            #[inline(always)]
            fn less(self, other: Self) -> $Mask<S> {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> $Mask<S> {
                self.simd_le(other)
            }
            #[inline(always)]
            fn equal(self, other: Self) -> $Mask<S> {
                self.simd_eq(other)
            }
            #[inline(always)]
            fn select(self, mask: $Mask<S>, other: Self) -> Self {
                mask.select(self, other)
            }
            #[inline(always)]
            fn minimum(self, other: Self) -> Self {
                if compares_in_min_and_max(self.simd) {
                    self.min(other)
                } else {
                    self.select(self.less(other), other)
                }
            }
            #[inline(always)]
            fn maximum(self, other: Self) -> Self {
                if compares_in_min_and_max(self.simd) {
                    self.max(other)
                } else {
                    self.select(other.less(self), other)
                }
            }
            #[inline(always)]
            fn mantissa_and_exponent(self) -> (Self, Self) {
                let bits: $Ints<S> = self.bitcast();
                let exponent = (bits - SQRT_HALF_BITS) >> MANTISSA_BITS;
                let mantissa: Self = (bits - (exponent << MANTISSA_BITS)).bitcast();
                (mantissa, Self::float_from(exponent))
            }
            #[inline(always)]
            fn scale_by_exponent(self, exponent: Self) -> Self {
                let bits = ($Ints::truncate_from(exponent) + EXPONENT_BIAS) << MANTISSA_BITS;
                self * bits.bitcast::<Self>()
            }
            #[inline(always)]
            fn lane(self, lane: usize) -> f32 {
                self[lane]
            }
            #[inline(always)]
            fn each_lane(self, mut of: impl FnMut(usize) -> f32) -> Self {
                let mut lanes = [0.0; $count];
                for (lane, value) in lanes.iter_mut().enumerate() {
                    *value = of(lane);
                }
                Self::simd_from(self.simd, lanes)
            }
            #[inline(always)]
            fn load(self, values: &[f32; LANES], first: usize) -> Self {
                Self::from_slice(self.simd, &values[first..first + $count])
            }
            #[inline(always)]
            fn columns<'r>(self, row: impl Fn(usize) -> &'r [f32; 8]) -> [Self; 8] {
                let mut columns = [[0.0; $count]; 8];
                for eight in (0..$count).step_by(8) {
                    let mut lines = [f32x8::splat(self.simd, 0.0); 8];
                    for (at, line) in lines.iter_mut().enumerate() {
                        *line = f32x8::simd_from(self.simd, *row(eight + at));
                    }
                    for (column, lanes) in columns.iter_mut().zip(transposed(lines)) {
                        lanes.store_slice(&mut column[eight..eight + 8]);
                    }
                }
                let mut numbers = [self; 8];
                for (number, column) in numbers.iter_mut().zip(columns) {
                    *number = Self::simd_from(self.simd, column);
                }
                numbers
            }
            #[inline(always)]
            fn rows(columns: [Self; 8], mut put: impl FnMut(usize, [f32; 8])) {
                let simd = columns[0].simd;
                let mut stored = [[0.0; $count]; 8];
                for (stored, column) in stored.iter_mut().zip(columns) {
                    column.store_slice(stored);
                }
                for eight in (0..$count).step_by(8) {
                    let mut lines = [f32x8::splat(simd, 0.0); 8];
                    for (line, stored) in lines.iter_mut().zip(&stored) {
                        *line = f32x8::from_slice(simd, &stored[eight..eight + 8]);
                    }
                    for (at, line) in transposed(lines).into_iter().enumerate() {
                        put(eight + at, line.into());
                    }
                }
            }
            #[inline(always)]
            fn store(self, values: &mut [f32; LANES], first: usize) {
                self.store_slice(&mut values[first..first + $count]);
            }
            #[inline(always)]
            fn store_whole(self, values: &mut [u32; LANES], first: usize) {
                let whole: $Words<S> = $Ints::truncate_from(self).bitcast();
                whole.store_slice(&mut values[first..first + $count]);
            }
            #[inline(always)]
            fn visit(self, lanes: u32, mut work: impl FnMut(usize)) {
                let mut left = lanes;
                while left != 0 {
                    work(left.trailing_zeros() as usize & ($count - 1));
                    left &= left - 1;
                }
            }
            #[inline(always)]
            fn with_lane(mut self, lane: usize, value: f32) -> Self {
                self[lane] = value;
                self
            }
            #[inline(always)]
            fn mask_of(self, bits: u32) -> $Mask<S> {
                $Mask::from_bitmask(self.simd, u64::from(bits))
            }
            #[inline(always)]
            fn lanes_equal(self, values: &[u32; LANES], value: u32) -> u32 {
                let values = $Words::from_slice(self.simd, &values[..$count]);
                values.simd_eq($Words::splat(self.simd, value)).to_bitmask() as u32
            }
            #[inline(always)]
            fn lanes_that_begin(self, values: &[u32; LANES]) -> u32 {
                // All lanes but the first of each row, and all rows but the first.
                const HAVE_LEFT: u32 = 0xeeee;
                const HAVE_ABOVE: u32 = 0xfff0;
                let values = $Words::from_slice(self.simd, &values[..$count]);
                let left = values.slide_within_blocks::<3>(values);
                let above = values.slide::<{ $count - 4 }>(values);
                let as_left = values.simd_eq(left).to_bitmask() as u32 & HAVE_LEFT;
                let as_above = values.simd_eq(above).to_bitmask() as u32 & HAVE_ABOVE;
                !(as_left | as_above) & ((1 << $count) - 1)
            }
            #[inline(always)]
            fn vectorized<R>(self, work: impl FnOnce() -> R) -> R {
                self.simd.vectorize(work)
            }
            #[inline(always)]
            fn piecewise(self, work: &mut impl Piecewise) {
                if $count == LANES && !has_wide_registers(self.simd) {
                    let eight = f32x8::splat(self.simd, 0.0);
                    for first in [0, LANES / 2] {
                        work.piece(eight, first);
                    }
                } else {
                    work.piece(self, 0);
                }
            }
        }
    };
}

number_of_lanes!(16, f32x16, mask32x16, i32x16, u32x16, Wide16);
number_of_lanes!(8, f32x8, mask32x8, i32x8, u32x8, Wide8);

#[cfg(test)]
mod tests;
