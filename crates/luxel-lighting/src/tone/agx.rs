//! `AgX` (Sobotka's configuration of 2022, for sRGB), by the fit of sixth degree of Wrensch, *Minimal AgX
//! Implementation* (2023), without a look.
//!
//! The colour is mixed a little towards grey, its logarithm over 16.5 stops goes through an S-shaped curve,
//! and the mixing is undone; the result is meant for a display of gamma 2.2, which makes it linear here.

use super::{clamped, transformed};
use luxel_math::{Lanes, Rgb, elementary};

/// Towards grey.
const INSET: [[f32; 3]; 3] = [
    [0.842_479_06, 0.078_433_6, 0.079_223_745],
    [0.042_328_242, 0.878_468_64, 0.079_166_13],
    [0.042_375_655, 0.078_433_6, 0.879_143],
];
/// Back again.
const OUTSET: [[f32; 3]; 3] = [
    [1.196_879, -0.098_020_88, -0.099_029_74],
    [-0.052_896_852, 1.151_903_1, -0.098_961_18],
    [-0.052_971_635, -0.098_043_45, 1.151_073_7],
];
/// The range of logarithms, in stops from light of 1: 10 below and 6.5 above middle grey, 0.18.
const LEAST: f32 = -12.473_93;
const MOST: f32 = 4.026_069;
/// The S-shaped curve, from the constant to x^6.
const CONTRAST: [f32; 7] = [-0.002_32, 0.119_1, 0.429_8, -6.868, 31.96, -40.14, 15.5];
const GAMMA: f32 = 2.2;

/// The curve of a colour that is not negative.
#[inline(always)]
pub(super) fn curve<N: Lanes>(color: Rgb<N>) -> Rgb<N> {
    let Rgb { r, g, b } = transformed(INSET, color);
    let curved = Rgb::new(contrast(r), contrast(g), contrast(b));
    let Rgb { r, g, b } = clamped(transformed(OUTSET, curved), 1.0);
    Rgb::new(linear(r), linear(g), linear(b))
}

#[inline(always)]
fn contrast<N: Lanes>(light: N) -> N {
    // Far below the range, and no subnormal number.
    let light = light.maximum(light.constant(1e-9));
    let stops = elementary::log2(light).clamped(LEAST, MOST);
    let x = (stops - stops.constant(LEAST)) * stops.constant(1.0 / (MOST - LEAST));
    let [c0, c1, c2, c3, c4, c5, c6] = CONTRAST;
    let mut sum = x * x.constant(c6) + x.constant(c5);
    sum = sum * x + x.constant(c4);
    sum = sum * x + x.constant(c3);
    sum = sum * x + x.constant(c2);
    sum = sum * x + x.constant(c1);
    sum * x + x.constant(c0)
}

#[inline(always)]
fn linear<N: Lanes>(shown: N) -> N {
    elementary::power(shown, shown.constant(GAMMA))
}
