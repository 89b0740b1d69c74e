//! Rays side by side, and what those that can be bundled have in common.

use crate::bvh::WIDTH;
use crate::gather::transposed;
use crate::intersect::{Ray, USUAL_LENGTHS, longest_axis};
use luxel_math::{Simd, f32x4, f32x8, i32x8, prelude::*};

/// Numbers of a ray.
pub(crate) const ROWS: usize = 8;

/// What the rays of a bundle have in common: the signs of their directions, a bit each, and the
/// longest axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kind(u8);

impl Kind {
    /// Of rays that are followed alone: unsound ones, and those of unusual lengths.
    pub(crate) const NONE: Self = Self(3 << 3);
    pub(crate) const COUNT: usize = 1 << 5;

    #[inline(always)]
    pub(crate) fn number(self) -> usize {
        usize::from(self.0) & (Self::COUNT - 1)
    }

    #[inline(always)]
    pub(crate) fn of(ray: &Ray) -> Self {
        if !ray.is_sound() || !ray.is_usual() {
            return Self::NONE;
        }
        let turned = |axis: usize| u8::from(ray.direction[axis].is_sign_negative()) << axis;
        Self(turned(0) | turned(1) | turned(2) | (longest_axis(&ray.direction) as u8) << 3)
    }

    pub(crate) fn turned(self) -> [usize; 3] {
        [0, 1, 2].map(|axis| usize::from(self.0 >> axis & 1))
    }

    pub(crate) fn longest(self) -> usize {
        usize::from(self.0 >> 3).min(2)
    }
}

/// What eight rays have in common: those that can be bundled, the signs of their directions, and their
/// longest axes, a bit each.
#[derive(Clone, Copy)]
pub(crate) struct Signs {
    usual: u32,
    turned: [u32; 3],
    longest: [u32; 2],
}

/// What all rays have in common.
pub(crate) struct Common {
    all: u32,
    any: u32,
}

impl Default for Common {
    fn default() -> Self {
        Self { all: u32::MAX, any: 0 }
    }
}

impl Common {
    #[inline(always)]
    pub(crate) fn include(&mut self, signs: Signs) {
        let Signs { usual, turned, longest } = signs;
        for (place, bits) in
            (0..).zip([usual, turned[0], turned[1], turned[2], longest[0], longest[1]])
        {
            if bits != u32::from(u8::MAX) {
                self.all &= !(1 << place);
            }
            if bits != 0 {
                self.any |= 1 << place;
            }
        }
    }

    /// The kind that all are of.
    pub(crate) fn kind(&self) -> Option<Kind> {
        let all = self.all & 0b11_1111;
        if all != self.any || all & 1 == 0 {
            return None;
        }
        let bit = |place: u32| (all >> place & 1) as u8;
        let longest = if bit(4) != 0 { 0 } else { 2 - bit(5) };
        Some(Kind(bit(1) | bit(2) << 1 | bit(3) << 2 | longest << 3))
    }
}

/// Eight rays, row by row.
#[inline(always)]
pub(crate) fn take_eight<S: Simd>(
    simd: S,
    [a, b, c, d, e, f, g, h]: [&Ray; WIDTH],
) -> ([f32x8<S>; ROWS], Signs) {
    let ([oxl, oyl, ozl, dxl], [dyl, dzl, nl, fl]) = take_four(simd, [a, b, c, d]);
    let ([oxh, oyh, ozh, dxh], [dyh, dzh, nh, fh]) = take_four(simd, [e, f, g, h]);
    let (ox, oy, oz) = (oxl.combine(oxh), oyl.combine(oyh), ozl.combine(ozh));
    let (dx, dy, dz) = (dxl.combine(dxh), dyl.combine(dyh), dzl.combine(dzh));
    let (nearest, farthest) = (nl.combine(nh), fl.combine(fh));
    let (x, y, z) = (SimdBase::abs(dx), SimdBase::abs(dy), SimdBase::abs(dz));
    let bounded = SimdBase::abs(ox).simd_lt(f32::INFINITY)
        & SimdBase::abs(oy).simd_lt(f32::INFINITY)
        & SimdBase::abs(oz).simd_lt(f32::INFINITY);
    let (least, most) = (USUAL_LENGTHS.start, USUAL_LENGTHS.end);
    let short = x.simd_lt(most) & y.simd_lt(most) & z.simd_lt(most);
    let long = x.simd_ge(least) | y.simd_ge(least) | z.simd_ge(least);
    let ranges = nearest.simd_ge(0.0) & farthest.simd_ge(nearest);
    let is_x = x.simd_gt(y) & x.simd_gt(z);
    let signs = Signs {
        usual: (bounded & short & long & ranges).to_bitmask() as u32,
        turned: [signs(dx), signs(dy), signs(dz)],
        longest: [is_x.to_bitmask() as u32, (!is_x & y.simd_gt(z)).to_bitmask() as u32],
    };
    ([ox, oy, oz, dx, dy, dz, nearest, farthest], signs)
}

/// A bit for each that has a minus.
#[inline(always)]
fn signs<S: Simd>(values: f32x8<S>) -> u32 {
    values.bitcast::<i32x8<S>>().simd_lt(0).to_bitmask() as u32
}

/// Four rays, row by row.
#[inline(always)]
fn take_four<S: Simd>(simd: S, [a, b, c, d]: [&Ray; 4]) -> ([f32x4<S>; 4], [f32x4<S>; 4]) {
    let (a, b, c, d) = (halves(simd, a), halves(simd, b), halves(simd, c), halves(simd, d));
    (transposed(a.0, b.0, c.0, d.0), transposed(a.1, b.1, c.1, d.1))
}

/// A ray's numbers.
#[inline(always)]
fn halves<S: Simd>(simd: S, ray: &Ray) -> (f32x4<S>, f32x4<S>) {
    let ([ox, oy, oz], [dx, dy, dz], [nearest, farthest]) = (ray.origin, ray.direction, ray.range);
    (f32x4::simd_from(simd, [ox, oy, oz, dx]), f32x4::simd_from(simd, [dy, dz, nearest, farthest]))
}
