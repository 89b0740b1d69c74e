//! Elementary functions with the same bits everywhere, made of the operations of [`Lanes`].
//!
//! Relative errors below are against the exact value, measured over the stated range by the tests
//! of this module. Trigonometry is needed on f64 only, outside the kernels: the `libm` crate, a
//! port of musl's functions that calls nothing of the platform, does it.

use crate::Lanes;

/// log2 x for positive normal x; relative error below 4e-7, also next to 1.
///
/// x = m 2^e with m in [sqrt(1/2), sqrt(2)); with s = (m - 1) / (m + 1),
/// ln m = 2 (s + s^3/3 + s^5/5 + ...), |s| < 0.172 (the series of atanh; Abramowitz and Stegun
/// 1964, 4.1.27).
#[inline(always)]
pub fn log2<N: Lanes>(x: N) -> N {
    const FACTOR: f64 = 2.0 * std::f64::consts::LOG2_E;
    let (mantissa, exponent) = x.mantissa_and_exponent();
    let s = (mantissa - x.one()) / (mantissa + x.one());
    let z = s * s;
    let mut series = x.constant((FACTOR / 9.0) as f32);
    series = series * z + x.constant((FACTOR / 7.0) as f32);
    series = series * z + x.constant((FACTOR / 5.0) as f32);
    series = series * z + x.constant((FACTOR / 3.0) as f32);
    series = series * z + x.constant(FACTOR as f32);
    series * s + exponent
}

/// 2^y; 0 below -126 and the largest power, 2^127, above; relative error below 3e-7.
///
/// y = n + r with whole n and |r| <= 1/2; 2^r by the exponential series (Abramowitz and Stegun
/// 1964, 4.2.1) up to the seventh power.
#[inline(always)]
pub fn exp2<N: Lanes>(y: N) -> N {
    const LN_2: f64 = std::f64::consts::LN_2;
    let limited = y.clamped(-126.0, 127.0);
    let whole = limited.round_ties_even();
    let t = (limited - whole) * y.constant(LN_2 as f32);
    let mut series = y.constant((1.0 / 5040.0) as f32);
    series = series * t + y.constant((1.0 / 720.0) as f32);
    series = series * t + y.constant((1.0 / 120.0) as f32);
    series = series * t + y.constant((1.0 / 24.0) as f32);
    series = series * t + y.constant((1.0 / 6.0) as f32);
    series = series * t + y.constant(0.5);
    series = series * t + y.one();
    series = series * t + y.one();
    series.scale_by_exponent(whole).masked(y.constant(-126.0).less_or_equal(y))
}

/// x^n for x >= 0; x^0 = 1 for every x, 0^n = 0 for n > 0.
///
/// The relative error is about n |log2 x| 4e-7: below 1e-5 wherever the result is above 1e-7.
#[inline(always)]
pub fn power<N: Lanes>(x: N, n: N) -> N {
    // The smallest normal number stands in for zero, so that the logarithm is finite.
    let base = x.maximum(x.constant(f32::MIN_POSITIVE));
    let result = exp2(log2(base) * n);
    let zero_base = x.less(x.constant(f32::MIN_POSITIVE));
    let zero_exponent = n.equal(n.zero());
    x.one().select(zero_exponent, x.zero().select(zero_base, result))
}

/// x^n for x >= 0 and one exponent for all lanes; x^0 = 1 for every x, 0^n = 0 for n > 0.
///
/// Whole exponents up to 1024 by repeated squaring (Knuth, *The Art of Computer
/// Programming*, section 4.6.3): at most 2 log2 n products instead of a logarithm, a division and an
/// exponential. The relative error is below n 2^-24, as large as what the rounding of x makes of x^n.
/// Others by [`power`].
#[inline(always)]
pub fn power_of_one_exponent<N: Lanes>(x: N, n: f32) -> N {
    let whole = n as u32;
    if whole > MOST_MULTIPLIED || whole as f32 != n {
        return power(x, x.constant(n));
    }
    if whole == 0 {
        return x.one();
    }
    // Most exponents are powers of 2: squares alone.
    let mut square = x;
    let mut left = whole;
    while left & 1 == 0 {
        square = square * square;
        left >>= 1;
    }
    let mut result = square;
    while left > 1 {
        square = square * square;
        left >>= 1;
        if left & 1 == 1 {
            result = result * square;
        }
    }
    result
}

/// Above this exponent a logarithm has the smaller error.
const MOST_MULTIPLIED: u32 = 1024;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SimdLevel;
    use fearless_simd::{Simd, dispatch, f32x16, prelude::*};

    fn relative_error(value: f32, exact: f64) -> f64 {
        ((f64::from(value) - exact) / exact).abs()
    }

    #[test]
    fn log2_is_accurate_from_tiny_to_huge_and_next_to_one() {
        let mut worst = 0.0_f64;
        for step in 1..200_000_u32 {
            for x in [step as f32 * 1e-5, 1.0 + step as f32 * 1e-7, step as f32 * 1e30] {
                if x != 1.0 {
                    worst = worst.max(relative_error(log2(x), libm::log2(f64::from(x))));
                }
            }
        }
        assert!(worst < 4e-7, "worst relative error {worst:e}");
        assert_eq!(log2(1.0_f32), 0.0);
    }

    #[test]
    fn exp2_is_accurate_and_saturates() {
        let mut worst = 0.0_f64;
        for step in -125_999..127_000 {
            let y = step as f32 * 1e-3;
            worst = worst.max(relative_error(exp2(y), libm::exp2(f64::from(y))));
        }
        assert!(worst < 3e-7, "worst relative error {worst:e}");
        assert_eq!(exp2(-200.0_f32), 0.0);
        assert_eq!(exp2(1000.0_f32), exp2(127.0_f32));
    }

    #[test]
    fn powers_follow_the_rules_at_zero_and_one() {
        assert_eq!(power(0.0_f32, 0.0), 1.0);
        assert_eq!(power(0.0_f32, 5.0), 0.0);
        assert_eq!(power(0.7_f32, 0.0), 1.0);
        assert_eq!(power(1.0_f32, 1000.0), 1.0);
        assert_eq!(power(0.5_f32, 3.0), 0.125);
    }

    #[test]
    fn powers_for_highlights_are_accurate() {
        for n in [1.0_f32, 5.0, 32.0, 200.0, 1000.0] {
            for step in 1..=10_000 {
                let x = step as f32 / 10_000.0;
                let exact = libm::pow(f64::from(x), f64::from(n));
                if exact > 1e-7 {
                    assert!(relative_error(power(x, n), exact) < 1e-5, "{x}^{n}");
                }
            }
        }
    }

    #[test]
    fn powers_of_one_exponent_are_accurate_and_follow_the_rules_at_zero() {
        for n in [0.0_f32, 1.0, 2.0, 3.0, 16.0, 31.0, 100.0, 0.5, 12.25, 1024.0, 1025.0] {
            assert_eq!(power_of_one_exponent(0.0, n), if n == 0.0 { 1.0 } else { 0.0 });
            assert_eq!(power_of_one_exponent(1.0, n), 1.0);
            for step in 1..=10_000 {
                let x = step as f32 / 10_000.0;
                let exact = libm::pow(f64::from(x), f64::from(n));
                if exact > 1e-7 {
                    let bound = 1e-5 + f64::from(n) * 6e-8;
                    assert!(relative_error(power_of_one_exponent(x, n), exact) < bound, "{x}^{n}");
                }
            }
        }
    }

    #[inline(always)]
    fn powers_in_lanes<S: Simd>(simd: S, x: [f32; 16], n: f32) -> [f32; 16] {
        let result = power(f32x16::simd_from(simd, x), f32x16::splat(simd, n));
        std::array::from_fn(|lane| result[lane])
    }

    #[test]
    fn every_level_gives_the_bits_of_one_value() {
        for level in SimdLevel::available() {
            let level = level.resolve().unwrap();
            for start in 0..500 {
                let x: [f32; 16] = std::array::from_fn(|lane| (start * 16 + lane) as f32 / 8000.0);
                for n in [0.0, 0.7, 12.0, 777.0] {
                    let lanes = dispatch!(level, simd => powers_in_lanes(simd, x, n));
                    for (lane, value) in lanes.into_iter().enumerate() {
                        assert_eq!(value.to_bits(), power(x[lane], n).to_bits(), "{level:?}");
                    }
                }
            }
        }
    }
}
