//! Rows of four numbers, one for each lane, as four columns of lanes.
//!
//! What each lane computes from numbers of its own, such as a form a x + b y + c of four components, can be computed
//! row by row where the numbers lie: then only the results are transposed, not all that they are made of.

use super::F64x16;
use super::f64_lanes::transposed;
use super::vector::transposed_quarter;
use fearless_simd::{Simd, f32x4, f32x16, f64x4, f64x8, prelude::*};

/// Lane i of column c is component c of `row(i)`. Mark the closure `#[inline(always)]`.
#[inline(always)]
pub fn columns<S: Simd>(simd: S, row: impl Fn(usize) -> f32x4<S>) -> [f32x16<S>; 4] {
    let mut columns = [f32x16::splat(simd, 0.0); 4];
    let [a, b] = [transposed_quarter(four(&row, 0)), transposed_quarter(four(&row, 4))];
    let [c, d] = [transposed_quarter(four(&row, 8)), transposed_quarter(four(&row, 12))];
    for (at, column) in columns.iter_mut().enumerate() {
        let upper = simd.combine_f32x4(a[at], b[at]);
        *column = simd.combine_f32x8(upper, simd.combine_f32x4(c[at], d[at]));
    }
    columns
}

/// [`columns`] of `f64`.
#[inline(always)]
pub fn wide_columns<S: Simd>(simd: S, row: impl Fn(usize) -> f64x4<S>) -> [F64x16<S>; 4] {
    let zeros = f64x8::splat(simd, 0.0);
    let mut columns = [F64x16 { low: zeros, high: zeros }; 4];
    let [a, b] = [transposed(four(&row, 0)), transposed(four(&row, 4))];
    let [c, d] = [transposed(four(&row, 8)), transposed(four(&row, 12))];
    for (at, column) in columns.iter_mut().enumerate() {
        column.low = simd.combine_f64x4(a[at], b[at]);
        column.high = simd.combine_f64x4(c[at], d[at]);
    }
    columns
}

/// Four rows from one on.
#[inline(always)]
fn four<R>(row: &impl Fn(usize) -> R, first: usize) -> [R; 4] {
    [row(first), row(first + 1), row(first + 2), row(first + 3)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SimdLevel;
    use crate::lanes::F64Lanes;
    use fearless_simd::dispatch;

    #[inline(always)]
    fn of_both<S: Simd>(simd: S) -> ([[f32; 16]; 4], [[f32; 16]; 4]) {
        let number = |lane: usize, column: usize| (10 * lane + column) as f32;
        let narrow = columns(
            simd,
            #[inline(always)]
            |lane| f32x4::simd_from(simd, [0, 1, 2, 3].map(|column| number(lane, column))),
        );
        let wide = wide_columns(
            simd,
            #[inline(always)]
            |lane| {
                f64x4::simd_from(simd, [0, 1, 2, 3].map(|column| f64::from(number(lane, column))))
            },
        );
        (narrow.map(Into::into), wide.map(|column| column.to_f32().into()))
    }

    #[test]
    fn each_lane_has_the_numbers_of_its_own_row_at_every_level() {
        let expected: [[f32; 16]; 4] =
            std::array::from_fn(|column| std::array::from_fn(|lane| (10 * lane + column) as f32));
        for level in SimdLevel::available() {
            let level = level.resolve().expect("it is available");
            let (narrow, wide) = dispatch!(level, simd => of_both(simd));
            assert_eq!(narrow, expected);
            assert_eq!(wide, expected);
        }
    }
}
