//! [`Lanes`]: the operations that one `f32` and sixteen of them share.
//!
//! Formulas are written over `Lanes` once. Run for one value they answer a question about one
//! pixel, run for sixteen they draw; both give the same bits, because each operation here is one
//! IEEE 754 operation (or a comparison and a choice) in both.
//!
//! Functions over `Lanes` are `#[inline(always)]` and never closures: a call that isn't inlined
//! into the dispatched kernel loses its instruction set and passes vectors through memory.

use crate::simd_level::LANES;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

mod f64_lanes;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod pseudo_min_max;
mod rows;
mod scalar;
mod vector;

pub use f64_lanes::{F64Lanes, F64x8, F64x16};
pub use rows::{columns, wide_columns};

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

/// A kernel that runs on any part of sixteen lanes: see [`Lanes::in_parts`].
pub trait SplitLanes {
    /// Processes the lanes of an `N` from lane `first` on; `simd` selects the lane type.
    fn part<N: Lanes>(&mut self, simd: N, first: usize);
}

/// One `f32`, or one for each of sixteen lanes (or of eight, [a half](Lanes::in_parts) of them).
///
/// A method whose doc says so reads nothing of `self` but its type: `simd.constant(0.5)` is 0.5 in
/// every lane. Such a value is called `simd` throughout.
///
/// `minimum`, `maximum` and `select` are defined by comparison (`a < b ? a : b`), so that a NaN has
/// the same effect everywhere: where it is the first operand, the second is the result.
pub trait Lanes:
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
    type F64: F64Lanes<F32 = Self>;

    /// Whether a long kernel is worth a second copy for its frequent case: see
    /// [`is_specialized`](crate::is_specialized); single lanes are not.
    const IS_SPECIALIZED: bool;

    /// The same value as an `f64`, exactly.
    fn to_f64(self) -> Self::F64;
    /// `value` in every lane; `self` selects the lane type.
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
    /// Writes `self` to a place in memory where the mask is true.
    #[inline(always)]
    fn put(self, mask: Self::Mask, place: &mut Self) {
        *place = self.select(mask, *place);
    }

    /// For a positive normal number x = m 2^e with m in [sqrt(1/2), sqrt(2)): (m, e).
    fn mantissa_and_exponent(self) -> (Self, Self);
    /// `self` 2^e for a whole number `exponent` from -126 to 127.
    fn scale_by_exponent(self, exponent: Self) -> Self;
    /// The value of one lane (of the only one, for an `f32`).
    fn lane(self, lane: usize) -> f32;
    /// Lane i has the value `of(i)`; an `f32` calls it for lane 0 alone.
    fn each_lane(self, of: impl FnMut(usize) -> f32) -> Self;
    /// Reads consecutive values from index `first` on; `self` selects the lane type.
    fn load(self, values: &[f32; LANES], first: usize) -> Self;
    /// Loads an 8-component row for each lane: lane i of column c is component c of `row(i)`; `self`
    /// selects the lane type. Mark the closure `#[inline(always)]`.
    fn load_transposed<'r>(self, row: impl Fn(usize) -> &'r [f32; 8]) -> [Self; 8];
    /// The reverse of [`Lanes::load_transposed`]: calls `put(i, row)` for each lane i. Mark the
    /// closure `#[inline(always)]`.
    fn store_transposed(columns: [Self; 8], put: impl FnMut(usize, [f32; 8]));
    /// Writes the values of all lanes to consecutive places from index `first` on.
    fn store(self, values: &mut [f32; LANES], first: usize);
    /// Writes whole numbers from -2^24 to 2^24 as the bits of `i32`, from index `first` on.
    fn store_whole(self, values: &mut [u32; LANES], first: usize);
    /// Calls `work` with each lane whose bit is set; an `f32` has only lane 0. `self` selects the
    /// lane type. Mark the closure `#[inline(always)]`.
    fn visit(self, lanes: u32, work: impl FnMut(usize));
    /// Replaces the value of one lane; an `f32` has only lane 0.
    fn with_lane(self, lane: usize, value: f32) -> Self;
    /// The mask whose lane i is bit i; `self` selects the lane type.
    fn mask_of(self, bits: u32) -> Self::Mask;
    /// A bit for each lane of `values` that equals `value`; `self` selects the lane type, and lane
    /// types of fewer lanes compare the first ones.
    fn eq_mask(self, values: &[u32; LANES], value: u32) -> u32;
    /// A bit for each lane of `values`, four rows of four, that differs from its left and its upper
    /// neighbour: the first lanes of runs of equal values, so that every value that occurs has at
    /// least one. `self` selects the lane type, and lane types of fewer lanes compare the first ones.
    fn run_starts(self, values: &[u32; LANES]) -> u32;
    /// Runs `work` with the instruction set of this lane type, so that the function around it need
    /// not be inlined into its callers. Mark the closure `#[inline(always)]`.
    fn vectorized<R>(self, work: impl FnOnce() -> R) -> R;

    /// A bit for each lane; `self` selects the lane type.
    fn all_lanes(self) -> u32;

    /// Runs `work` on all lanes, as two halves where a kernel with many live values would spill.
    fn in_parts(self, work: &mut impl SplitLanes);

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

    /// The value clamped to `low..=high`.
    #[inline(always)]
    fn clamped(self, low: f32, high: f32) -> Self {
        self.maximum(self.constant(low)).minimum(self.constant(high))
    }

    /// max(x, 0), the lighting equation's clamp of cosines.
    #[inline(always)]
    fn positive_part(self) -> Self {
        self.maximum(self.zero())
    }

    /// `self` where the mask is true, 0 elsewhere.
    #[inline(always)]
    fn masked(self, mask: Self::Mask) -> Self {
        self.select(mask, self.zero())
    }
}

/// Bits of the mantissa of an `f32`.
const MANTISSA_BITS: u32 = 23;
/// What the exponent field of an `f32` holds for 2^0.
const EXPONENT_BIAS: i32 = 127;
/// The bits of sqrt(1/2), rounded up: where the mantissa's range begins.
const SQRT_HALF_BITS: i32 = 0x3f35_04f4;

#[cfg(test)]
mod tests;
