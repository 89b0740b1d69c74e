//! Sixteen `f32`, and eight, as lanes of a vector.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use super::pseudo_min_max::PseudoMinMax;
use super::{EXPONENT_BIAS, F64x8, F64x16, Lanes, MANTISSA_BITS, Mask, SQRT_HALF_BITS, SplitLanes};
use crate::simd_level::{LANES, has_wide_registers, is_specialized};
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Level;
use fearless_simd::{
    ExtractToken, Simd, f32x4, f32x8, f32x16, i32x8, i32x16, mask32x8, mask32x16, prelude::*,
    u32x8, u32x16,
};

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

/// What lies in memory, before some of its lanes are replaced there: read whole, chosen from, and written whole.
///
/// LLVM turns that into a store of single lanes, which AMD's processors with AVX2 execute in microcode. There
/// the value is hidden from it, and stays the same.
#[inline(always)]
fn loaded_whole<S: Simd, V>(simd: S, stored: V) -> V {
    match simd.level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(_) => std::hint::black_box(stored),
        _ => stored,
    }
}

/// Eight rows as eight columns, by quarters of four rows and four columns: x86 shuffles lanes within 128 bits faster
/// than across them.
#[inline(always)]
fn transposed<S: Simd>(lines: [f32x8<S>; 8]) -> [f32x8<S>; 8] {
    let simd = lines[0].simd;
    let mut columns = lines;
    let [a, b, c, d, e, f, g, h] = lines;
    let ((a0, a4), (b0, b4)) = (simd.split_f32x8(a), simd.split_f32x8(b));
    let ((c0, c4), (d0, d4)) = (simd.split_f32x8(c), simd.split_f32x8(d));
    let ((e0, e4), (f0, f4)) = (simd.split_f32x8(e), simd.split_f32x8(f));
    let ((g0, g4), (h0, h4)) = (simd.split_f32x8(g), simd.split_f32x8(h));
    let upper_left = transposed_quarter([a0, b0, c0, d0]);
    let lower_left = transposed_quarter([e0, f0, g0, h0]);
    let upper_right = transposed_quarter([a4, b4, c4, d4]);
    let lower_right = transposed_quarter([e4, f4, g4, h4]);
    for at in 0..4 {
        columns[at] = simd.combine_f32x4(upper_left[at], lower_left[at]);
        columns[4 + at] = simd.combine_f32x4(upper_right[at], lower_right[at]);
    }
    columns
}

/// Four rows as four columns.
#[inline(always)]
pub(super) fn transposed_quarter<S: Simd>([a, b, c, d]: [f32x4<S>; 4]) -> [f32x4<S>; 4] {
    let ((ac_low, ac_high), (bd_low, bd_high)) = (a.interleave(c), b.interleave(d));
    let ((first, second), (third, fourth)) =
        (ac_low.interleave(bd_low), ac_high.interleave(bd_high));
    [first, second, third, fourth]
}

/// Implements [`Lanes`] and [`Mask`] for one vector length.
macro_rules! vector_lanes {
    ($count:literal, $Lanes:ident, $Mask:ident, $Ints:ident, $Words:ident, $F64Lanes:ident) => {
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

        impl<S: Simd> Lanes for $Lanes<S> {
            type Mask = $Mask<S>;
            type F64 = $F64Lanes<S>;
            const IS_SPECIALIZED: bool = is_specialized::<S>();

            #[inline(always)]
            fn to_f64(self) -> $F64Lanes<S> {
                $F64Lanes::of(self)
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
            fn put(self, mask: $Mask<S>, place: &mut Self) {
                *place = self.select(mask, loaded_whole(self.simd, *place));
            }
            #[inline(always)]
            fn minimum(self, other: Self) -> Self {
                if compares_in_min_and_max(self.simd) {
                    return self.min(other);
                }
                #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
                return self.pseudo_minimum(other);
                #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
                self.select(self.less(other), other)
            }
            #[inline(always)]
            fn maximum(self, other: Self) -> Self {
                if compares_in_min_and_max(self.simd) {
                    return self.max(other);
                }
                #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
                return self.pseudo_maximum(other);
                #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
                self.select(other.less(self), other)
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
            fn load_transposed<'r>(self, row: impl Fn(usize) -> &'r [f32; 8]) -> [Self; 8] {
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
                let mut lanes = [self; 8];
                for (lane, column) in lanes.iter_mut().zip(columns) {
                    *lane = Self::simd_from(self.simd, column);
                }
                lanes
            }
            #[inline(always)]
            fn store_transposed(columns: [Self; 8], mut put: impl FnMut(usize, [f32; 8])) {
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
            fn eq_mask(self, values: &[u32; LANES], value: u32) -> u32 {
                let values = $Words::from_slice(self.simd, &values[..$count]);
                values.simd_eq($Words::splat(self.simd, value)).to_bitmask() as u32
            }
            #[inline(always)]
            fn run_starts(self, values: &[u32; LANES]) -> u32 {
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
            fn all_lanes(self) -> u32 {
                (1 << $count) - 1
            }
            #[inline(always)]
            fn in_parts(self, work: &mut impl SplitLanes) {
                if $count == LANES && !has_wide_registers(self.simd) {
                    let eight = f32x8::splat(self.simd, 0.0);
                    for first in [0, LANES / 2] {
                        work.part(eight, first);
                    }
                } else {
                    work.part(self, 0);
                }
            }
        }
    };
}

vector_lanes!(16, f32x16, mask32x16, i32x16, u32x16, F64x16);
vector_lanes!(8, f32x8, mask32x8, i32x8, u32x8, F64x8);
