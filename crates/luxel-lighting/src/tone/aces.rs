//! The film look of ACES: a fit of its reference rendering transform (RRT) and of its output transform for
//! sRGB at 100 nits by Stephen Hill (`ACES.hlsl` of Pettineo and Hill's *BakingLab*, 2016).
//!
//! Luxel takes the fit as it is, without the gain of 1/0.6 that some viewers put before it: light of 1 is
//! shown as 0.62 of white.

use super::{clamped, transformed};
use luxel_math::{Lanes, Rgb};

/// From linear sRGB to the fit's space: D65 to D60, AP1, the RRT's saturation.
const INPUT: [[f32; 3]; 3] =
    [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]];
/// Back: the output transform's saturation, D60 to D65, sRGB.
const OUTPUT: [[f32; 3]; 3] =
    [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]];
/// (v (v + n1) - n0) / (v (d2 v + d1) + d0)
const NUMERATOR: [f32; 2] = [0.000_090_537, 0.024_578_6];
const DENOMINATOR: [f32; 3] = [0.238_081, 0.432_951, 0.983_729];

/// The curve of a colour that is not negative.
#[inline(always)]
pub(super) fn curve<N: Lanes>(color: Rgb<N>) -> Rgb<N> {
    let Rgb { r, g, b } = transformed(INPUT, color);
    clamped(transformed(OUTPUT, Rgb::new(fit(r), fit(g), fit(b))), 1.0)
}

#[inline(always)]
fn fit<N: Lanes>(v: N) -> N {
    let ([n0, n1], [d0, d1, d2]) = (NUMERATOR, DENOMINATOR);
    let numerator = v * (v + v.constant(n1)) - v.constant(n0);
    let denominator = v * (v * v.constant(d2) + v.constant(d1)) + v.constant(d0);
    numerator / denominator
}
