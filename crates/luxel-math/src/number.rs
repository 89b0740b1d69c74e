//! [`Number`]: what one `f32` and sixteen lanes of them have in common.
//!
//! Formulas are written over `Number` once. Run for one value they answer a question about one
//! pixel, run for sixteen they draw; both give the same bits, because each operation here is one
//! IEEE 754 operation (or a comparison and a choice) in both.
//!
//! Functions over `Number` are `#[inline(always)]` and never closures: a call that isn't inlined
//! into the dispatched kernel loses its instruction set and passes vectors through memory.

use crate::LANES;
use crate::wide::{Wide, Wide16};
use fearless_simd::{ExtractToken, Simd, f32x16, i32x16, mask32x16, prelude::*, u32x16};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

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

/// One `f32`, or one for each of sixteen lanes.
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
    /// A number with these lanes, of which an `f32` takes the first; `self` tells only the kind.
    fn of_lanes(self, values: &[f32; LANES]) -> Self;
    /// The values of all lanes, of which an `f32` fills the first.
    fn to_lanes(self, values: &mut [f32; LANES]);
    /// The number with another value in one lane; an `f32` has only lane 0.
    fn with_lane(self, lane: usize, value: f32) -> Self;
    /// The mask whose lane i is bit i; `self` tells only the kind of number.
    fn mask_of(self, bits: u32) -> Self::Mask;
    /// The lanes of `values` that are `value`, as bits; `self` tells only the kind of number, of
    /// which an `f32` looks at the first lane alone.
    fn lanes_equal(self, values: &[u32; LANES], value: u32) -> u32;
    /// Runs work with the instruction set of this kind of number. The closure is to be marked
    /// `#[inline(always)]`; around it a function may then stay out of its callers.
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R;

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

impl<S: Simd> Mask for mask32x16<S> {
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
    fn of_lanes(self, values: &[Self; LANES]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn to_lanes(self, values: &mut [Self; LANES]) {
        values[0] = self;
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
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
}

impl<S: Simd> Number for f32x16<S> {
    type Mask = mask32x16<S>;
    type Wide = Wide16<S>;

    #[inline(always)]
    fn widened(self) -> Wide16<S> {
        Wide16::of(self)
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
    fn less(self, other: Self) -> mask32x16<S> {
        self.simd_lt(other)
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> mask32x16<S> {
        self.simd_le(other)
    }
    #[inline(always)]
    fn equal(self, other: Self) -> mask32x16<S> {
        self.simd_eq(other)
    }
    #[inline(always)]
    fn select(self, mask: mask32x16<S>, other: Self) -> Self {
        mask.select(self, other)
    }
    #[inline(always)]
    fn mantissa_and_exponent(self) -> (Self, Self) {
        let bits: i32x16<S> = self.bitcast();
        let exponent = (bits - SQRT_HALF_BITS) >> MANTISSA_BITS;
        let mantissa: Self = (bits - (exponent << MANTISSA_BITS)).bitcast();
        (mantissa, Self::float_from(exponent))
    }
    #[inline(always)]
    fn scale_by_exponent(self, exponent: Self) -> Self {
        let bits = (i32x16::truncate_from(exponent) + EXPONENT_BIAS) << MANTISSA_BITS;
        self * bits.bitcast::<Self>()
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f32 {
        self[lane]
    }
    #[inline(always)]
    fn each_lane(self, mut of: impl FnMut(usize) -> f32) -> Self {
        let mut lanes = [0.0; 16];
        for (lane, value) in lanes.iter_mut().enumerate() {
            *value = of(lane);
        }
        Self::simd_from(self.simd, lanes)
    }
    #[inline(always)]
    fn of_lanes(self, values: &[f32; LANES]) -> Self {
        Self::simd_from(self.simd, *values)
    }
    #[inline(always)]
    fn to_lanes(self, values: &mut [f32; LANES]) {
        self.store_slice(values);
    }
    #[inline(always)]
    fn with_lane(mut self, lane: usize, value: f32) -> Self {
        self[lane] = value;
        self
    }
    #[inline(always)]
    fn mask_of(self, bits: u32) -> mask32x16<S> {
        mask32x16::from_bitmask(self.simd, u64::from(bits))
    }
    #[inline(always)]
    fn lanes_equal(self, values: &[u32; LANES], value: u32) -> u32 {
        let values = u32x16::simd_from(self.simd, *values);
        values.simd_eq(u32x16::splat(self.simd, value)).to_bitmask() as u32
    }
    #[inline(always)]
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R {
        self.simd.vectorize(work)
    }
}
