//! [`permuted`]: lanes in an order that is known only at run time.

use fearless_simd::{Simd, f32x8, prelude::*, u32x8};
#[cfg(target_arch = "x86")]
use std::arch::x86::{__m256, __m256i, _mm256_permutevar8x32_ps};
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::{__m256, __m256i, _mm256_permutevar8x32_ps};

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fearless_simd::kernel!(
    #[inline(always)]
    fn permuted_by_avx2(avx2: Avx2, lanes: __m256, places: __m256i) -> __m256 {
        _mm256_permutevar8x32_ps(lanes, places)
    }
);

/// For each lane that one of `lanes` which `places` names there, in its lowest three bits; the bits
/// above don't matter.
///
/// One instruction from AVX2 on. Other machines take the long way, lane by lane: none has it for
/// eight numbers.
#[inline(always)]
pub fn permuted<S: Simd>(simd: S, lanes: f32x8<S>, places: u32x8<S>) -> f32x8<S> {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(avx2) = simd.level().as_avx2() {
        return f32x8::simd_from(simd, permuted_by_avx2(avx2, lanes.into(), places.into()));
    }
    let (mut from, mut places_of, mut to) = ([0.0; 8], [0; 8], [0.0; 8]);
    lanes.store_slice(&mut from);
    places.store_slice(&mut places_of);
    for lane in 0..8 {
        to[lane] = from[places_of[lane] as usize & 7];
    }
    f32x8::simd_from(simd, to)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SimdLevel;
    use fearless_simd::dispatch;

    #[inline(always)]
    fn permuted_lanes<S: Simd>(simd: S, lanes: [f32; 8], places: [u32; 8]) -> [f32; 8] {
        let lanes = f32x8::simd_from(simd, lanes);
        permuted(simd, lanes, u32x8::simd_from(simd, places)).into()
    }

    #[test]
    fn lanes_come_from_where_the_lowest_bits_say_at_every_level() {
        let lanes: [f32; 8] = std::array::from_fn(|lane| lane as f32 + 0.5);
        for seed in 0..200_u32 {
            let places: [u32; 8] = std::array::from_fn(|lane| {
                (seed * 8 + lane as u32 + 1).wrapping_mul(2_654_435_761)
            });
            let expected = places.map(|place| lanes[place as usize % 8]);
            for level in SimdLevel::available() {
                let level = level.resolve().expect("it is available");
                assert_eq!(dispatch!(level, simd => permuted_lanes(simd, lanes, places)), expected);
            }
        }
    }
}
