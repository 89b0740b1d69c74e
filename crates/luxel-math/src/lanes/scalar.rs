//! One `f32` as one lane.

use super::{EXPONENT_BIAS, Lanes, MANTISSA_BITS, Mask, SQRT_HALF_BITS, SplitLanes};
use crate::simd_level::LANES;

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

impl Lanes for f32 {
    type Mask = bool;
    type F64 = f64;
    const IS_SPECIALIZED: bool = false;

    #[inline(always)]
    fn to_f64(self) -> f64 {
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
    fn load_transposed<'r>(self, row: impl Fn(usize) -> &'r [Self; 8]) -> [Self; 8] {
        *row(0)
    }
    #[inline(always)]
    fn store_transposed(columns: [Self; 8], mut put: impl FnMut(usize, [Self; 8])) {
        put(0, columns);
    }
    #[inline(always)]
    fn store(self, values: &mut [Self; LANES], first: usize) {
        values[first] = self;
    }
    #[inline(always)]
    fn store_whole(self, values: &mut [u32; LANES], first: usize) {
        values[first] = (self as i32).cast_unsigned();
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
    fn eq_mask(self, values: &[u32; LANES], value: u32) -> u32 {
        u32::from(values[0] == value)
    }
    #[inline(always)]
    fn run_starts(self, _values: &[u32; LANES]) -> u32 {
        1
    }
    #[inline(always)]
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
    #[inline(always)]
    fn all_lanes(self) -> u32 {
        1
    }
    #[inline(always)]
    fn in_parts(self, work: &mut impl SplitLanes) {
        work.part(self, 0);
    }
}
