//! Slab tests: rays against boxes.
//!
//! A ray hits a box if its intervals between the three pairs of planes overlap (Kay and Kajiya 1986).
//! Rounding must never lose a box, so near planes are tested from an origin shifted a little forward
//! and far planes from one shifted a little back, by several units in the last place of the largest
//! coordinate.

use crate::tree::{Node, WIDTH};
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};
use std::ops::{Add, Mul, Sub};

/// A line prepared for slab tests against the boxes of nodes, optionally one that widens with
/// distance.
#[derive(Clone, Copy, Debug)]
pub struct SlabTest {
    /// The origin for near planes and the one for far planes, axis by axis.
    origin: [[f32; 2]; 3],
    /// The reciprocal direction for near planes and far planes.
    inverse: [[f32; 2]; 3],
    /// 0 where the near plane is the low one, else 1.
    reversed: [usize; 3],
    /// The smallest distance that counts.
    nearest: f32,
}

/// How far origins are shifted, relative to the largest coordinate. With 6 units in the last place no
/// ray through vertices along an axis was lost; without the shift all of them were.
pub(crate) const PADDING: f32 = 6.0 * f32::EPSILON;
/// Stands for 0 in directions, so that reciprocals are finite.
pub(crate) const ALMOST_ZERO: f32 = 1e-18;

/// The shift of the origins, for one ray or several side by side.
#[inline(always)]
pub(crate) fn padding<T: Add<Output = T> + Mul<Output = T>>(size: T, largest: T, unit: T) -> T {
    unit * (size + largest)
}

/// The origins for near planes and far planes.
#[inline(always)]
pub(crate) fn shifted<T: Copy + Add<Output = T> + Sub<Output = T>>(origin: T, ahead: T) -> [T; 2] {
    [origin + ahead, origin - ahead]
}

/// The reciprocal of a length, which may be 0.
#[inline(always)]
fn reciprocal(length: f32) -> f32 {
    1.0 / if length > ALMOST_ZERO { length } else { ALMOST_ZERO }
}

impl SlabTest {
    /// A ray from the distance `nearest` on, through boxes whose absolute coordinates don't exceed
    /// `largest`.
    #[must_use]
    #[inline(always)]
    pub fn new(origin: [f32; 3], direction: [f32; 3], nearest: f32, largest: [f32; 3]) -> Self {
        let mut slabs =
            Self { origin: [[0.0; 2]; 3], inverse: [[0.0; 2]; 3], reversed: [0; 3], nearest };
        for axis in 0..3 {
            let pad = padding(origin[axis].abs(), largest[axis], PADDING);
            let inverse = reciprocal(direction[axis].abs());
            slabs.set(axis, origin[axis], direction[axis], pad, [inverse; 2]);
        }
        slabs
    }

    /// A thick ray: everything within `reach + distance * growth` of a line, axis by axis, up to the
    /// distance `farthest`. The rays of all samples of a pixel are one that grows with distance.
    #[must_use]
    #[inline(always)]
    pub fn widening(
        origin: [f32; 3],
        direction: [f32; 3],
        [nearest, farthest]: [f32; 2],
        largest: [f32; 3],
        reach: [f32; 3],
        growth: [f32; 3],
    ) -> Self {
        let mut slabs =
            Self { origin: [[0.0; 2]; 3], inverse: [[0.0; 2]; 3], reversed: [0; 3], nearest };
        for axis in 0..3 {
            let mut along = direction[axis].abs();
            let mut growth = growth[axis];
            let mut pad = padding(origin[axis].abs(), largest[axis], PADDING) + reach[axis];
            if growth > 0.0 && along <= growth {
                // The two sides go opposite ways: as wide everywhere as at the end.
                pad += farthest * (along + growth);
                (along, growth) = (0.0, 0.0);
            }
            let inverse = [reciprocal(along + growth), reciprocal(along - growth)];
            slabs.set(axis, origin[axis], direction[axis], pad, inverse);
        }
        slabs
    }

    /// Sets an axis: the ray's origin and direction there, the shift of the origins, and the
    /// reciprocal lengths of the directions to near and far planes.
    #[inline(always)]
    fn set(&mut self, axis: usize, origin: f32, direction: f32, pad: f32, inverse: [f32; 2]) {
        let reversed = direction.is_sign_negative();
        let sign = if reversed { -1.0 } else { 1.0 };
        self.origin[axis] = shifted(origin, sign * pad);
        self.inverse[axis] = inverse.map(|inverse| sign * inverse);
        self.reversed[axis] = usize::from(reversed);
    }

    /// The distances at which the line enters the boxes of a node's children, and a bit for each that
    /// it enters before `farthest`. For use inside of vector code; see [`Self::hit_children_at`].
    #[inline(always)]
    pub fn hit_children<S: Simd>(
        &self,
        simd: S,
        node: &Node,
        farthest: f32,
    ) -> ([f32; WIDTH], u32) {
        let mut near = f32x8::splat(simd, self.nearest);
        let mut far = f32x8::splat(simd, farthest);
        for axis in 0..3 {
            let reversed = self.reversed[axis] & 1;
            let near_plane = f32x8::simd_from(simd, node.planes[axis][reversed]);
            let far_plane = f32x8::simd_from(simd, node.planes[axis][reversed ^ 1]);
            let [near_origin, far_origin] = self.origin[axis];
            let [near_inverse, far_inverse] = self.inverse[axis];
            near = ((near_plane - near_origin) * near_inverse).max(near);
            far = ((far_plane - far_origin) * far_inverse).min(far);
        }
        let mut distances = [0.0; WIDTH];
        near.store_slice(&mut distances);
        (distances, near.simd_le(far).to_bitmask() as u32)
    }

    /// [`Self::hit_children`] for callers outside of vector code.
    #[must_use]
    pub fn hit_children_at(&self, level: Level, node: &Node, farthest: f32) -> ([f32; WIDTH], u32) {
        dispatch_long!(level, simd => self.hit_children(simd, node, farthest))
    }
}
