//! Linear forms over the window, and how their quotients grow.

use luxel_math::F64Lanes;
use std::ops::{Add, Mul};

/// a x + b y + c.
#[inline(always)]
pub(super) fn linear_form<V: Copy + Add<Output = V> + Mul<Output = V>>(
    [a, b, c]: [V; 3],
    x: V,
    y: V,
) -> V {
    a * x + b * y + c
}

/// How much the quotients of numerators and a divisor grow a pixel on, where the numerators grow by `slopes` and the
/// divisor by `more`.
#[inline(always)]
pub(super) fn step<D: F64Lanes, const K: usize>(
    numerators: [D; K],
    divisor: D,
    slopes: [D; K],
    more: D,
) -> [D::F32; K] {
    let scale = divisor.constant(1.0) / (divisor * (divisor + more));
    let mut steps = [divisor.to_f32(); K];
    for ((step, numerator), slope) in steps.iter_mut().zip(numerators).zip(slopes) {
        *step = ((slope * divisor - numerator * more) * scale).to_f32();
    }
    steps
}
