//! Which rays can share a packet, and their transposition to rows.

use crate::ray::{Ray, USUAL_LENGTHS};
use crate::tree::{WIDTH, transpose};
use luxel_math::{Simd, f32x4, f32x8, f32x16, i32x16, prelude::*, u32x8};

/// Values of a ray: origin, direction, range.
pub(crate) const ROWS: usize = 8;

/// What the rays of a packet share: the signs of their directions, a bit each, and the longest axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PacketKind(u8);

impl PacketKind {
    /// The number of kinds.
    pub(crate) const COUNT: usize = 3 << 3;

    /// The kind of a number.
    #[inline(always)]
    pub(crate) fn of_number(number: usize) -> Self {
        Self(number as u8)
    }

    pub(crate) fn reversed(self) -> [usize; 3] {
        [0, 1, 2].map(|axis| usize::from(self.0 >> axis & 1))
    }

    pub(crate) fn longest(self) -> usize {
        usize::from(self.0 >> 3).min(2)
    }
}

/// A bit for each of sixteen rays: whether its length is usual, the signs of its direction, and its
/// longest axis.
#[derive(Clone, Copy)]
pub(crate) struct SignBits {
    usual: u32,
    reversed: [u32; 3],
    longest: [u32; 2],
}

impl SignBits {
    /// Of rays in columns.
    #[inline(always)]
    pub(crate) fn of<S: Simd>(
        [ox, oy, oz, dx, dy, dz, nearest, farthest]: [f32x16<S>; ROWS],
    ) -> Self {
        let (x, y, z) = (SimdBase::abs(dx), SimdBase::abs(dy), SimdBase::abs(dz));
        let bounded = SimdBase::abs(ox).simd_lt(f32::INFINITY)
            & SimdBase::abs(oy).simd_lt(f32::INFINITY)
            & SimdBase::abs(oz).simd_lt(f32::INFINITY);
        let (least, most) = (USUAL_LENGTHS.start, USUAL_LENGTHS.end);
        let short = x.simd_lt(most) & y.simd_lt(most) & z.simd_lt(most);
        let long = x.simd_ge(least) | y.simd_ge(least) | z.simd_ge(least);
        let ranges = nearest.simd_ge(0.0) & farthest.simd_ge(nearest);
        let is_x = x.simd_gt(y) & x.simd_gt(z);
        Self {
            usual: (bounded & short & long & ranges).to_bitmask() as u32,
            reversed: [signs(dx), signs(dy), signs(dz)],
            longest: [is_x.to_bitmask() as u32, (!is_x & y.simd_gt(z)).to_bitmask() as u32],
        }
    }
}

/// A bit for each negative value.
#[inline(always)]
fn signs<S: Simd>(values: f32x16<S>) -> u32 {
    values.bitcast::<i32x16<S>>().simd_lt(0).to_bitmask() as u32
}

/// What all rays added so far share.
pub(crate) struct SharedSigns {
    all: u32,
    any: u32,
}

impl Default for SharedSigns {
    fn default() -> Self {
        Self { all: u32::MAX, any: 0 }
    }
}

impl SharedSigns {
    #[inline(always)]
    pub(crate) fn include(&mut self, signs: SignBits) {
        let SignBits { usual, reversed, longest } = signs;
        for (at, bits) in
            (0..).zip([usual, reversed[0], reversed[1], reversed[2], longest[0], longest[1]])
        {
            if bits != u32::from(u16::MAX) {
                self.all &= !(1 << at);
            }
            if bits != 0 {
                self.any |= 1 << at;
            }
        }
    }

    /// The kind of all rays, if they share one.
    pub(crate) fn kind(&self) -> Option<PacketKind> {
        let all = self.all & 0b11_1111;
        if all != self.any || all & 1 == 0 {
            return None;
        }
        let bit = |at: u32| (all >> at & 1) as u8;
        let longest = if bit(4) != 0 { 0 } else { 2 - bit(5) };
        Some(PacketKind(bit(1) | bit(2) << 1 | bit(3) << 2 | longest << 3))
    }
}

/// Transposes eight rays to rows.
#[inline(always)]
pub(crate) fn load_eight<S: Simd>(
    simd: S,
    [a, b, c, d, e, f, g, h]: [&Ray; WIDTH],
) -> [f32x8<S>; ROWS] {
    let ([oxl, oyl, ozl, dxl], [dyl, dzl, nl, fl]) = load_four(simd, [a, b, c, d]);
    let ([oxh, oyh, ozh, dxh], [dyh, dzh, nh, fh]) = load_four(simd, [e, f, g, h]);
    let (ox, oy, oz) = (oxl.combine(oxh), oyl.combine(oyh), ozl.combine(ozh));
    let (dx, dy, dz) = (dxl.combine(dxh), dyl.combine(dyh), dzl.combine(dzh));
    let (nearest, farthest) = (nl.combine(nh), fl.combine(fh));
    [ox, oy, oz, dx, dy, dz, nearest, farthest]
}

/// The numbers of the kinds of up to eight rays by their directions, whether these are usual or not.
#[inline(always)]
pub(crate) fn kinds_of<S: Simd>(simd: S, rays: &[Ray]) -> [u32; WIDTH] {
    let ray = |at: usize| {
        let Ray { direction: [x, y, z], range: [nearest, _], .. } =
            rays.get(at).unwrap_or(&rays[0]);
        f32x4::simd_from(simd, [*x, *y, *z, *nearest])
    };
    let low = transpose(ray(0), ray(1), ray(2), ray(3));
    let high = transpose(ray(4), ray(5), ray(6), ray(7));
    let [dx, dy, dz] = [0, 1, 2].map(|axis: usize| low[axis].combine(high[axis]));
    let (x, y, z) = (SimdBase::abs(dx), SimdBase::abs(dy), SimdBase::abs(dz));
    let is_x = x.simd_gt(y) & x.simd_gt(z);
    let number = |number: u32| u32x8::splat(simd, number);
    let not_x = y.simd_gt(z).select(number(1 << 3), number(2 << 3));
    let longest = is_x.select(number(0), not_x);
    let sign = |values: f32x8<S>| values.bitcast::<u32x8<S>>() >> 31;
    let kinds = longest | sign(dx) | sign(dy) << 1 | sign(dz) << 2;
    let mut all = [0; WIDTH];
    kinds.store_slice(&mut all);
    all
}

/// Transposes four rays to rows.
#[inline(always)]
fn load_four<S: Simd>(simd: S, [a, b, c, d]: [&Ray; 4]) -> ([f32x4<S>; 4], [f32x4<S>; 4]) {
    let (a, b, c, d) = (halves(simd, a), halves(simd, b), halves(simd, c), halves(simd, d));
    (transpose(a.0, b.0, c.0, d.0), transpose(a.1, b.1, c.1, d.1))
}

/// The values of a ray, in two vectors.
#[inline(always)]
fn halves<S: Simd>(simd: S, ray: &Ray) -> (f32x4<S>, f32x4<S>) {
    let ([ox, oy, oz], [dx, dy, dz], [nearest, farthest]) = (ray.origin, ray.direction, ray.range);
    (f32x4::simd_from(simd, [ox, oy, oz, dx]), f32x4::simd_from(simd, [dy, dz, nearest, farthest]))
}
