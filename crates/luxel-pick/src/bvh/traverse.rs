//! From boxes to the leaves that a ray meets.
//!
//! A box is met if the ray's ways between its three pairs of planes have a stretch in common (Kay
//! and Kajiya 1986). Rounding must never lose a box, so near planes are looked at from an origin
//! that lies a little forward and far ones from one a little back: several units of the last place
//! of the largest coordinate. Rays may also widen with distance, as far as the samples of a pixel's
//! grid reach; then the two origins' directions differ, too.

use super::{Child, Node, WIDTH};
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};
use std::ops::{Add, Mul, Sub};

/// A line as the test of boxes wants it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slabs {
    /// Where near planes are looked at from, and far ones, axis by axis.
    origin: [[f32; 2]; 3],
    /// One over the direction, for near planes and far ones.
    inverse: [[f32; 2]; 3],
    /// 0 where the near plane is the low one, else 1.
    turned: [usize; 3],
    /// The nearest distance that counts.
    pub(crate) nearest: f32,
}

/// Units of the last place of the largest coordinate by which origins are moved; with 6 nothing
/// was lost among rays through vertices along axes, where everything was lost without.
pub(crate) const PADDING: f32 = 6.0 * f32::EPSILON;
/// Stands for 0 in directions, whose inverse must be finite.
pub(crate) const ALMOST_ZERO: f32 = 1e-18;

/// How far the origins of near and far planes are moved, for one ray or several side by side.
#[inline(always)]
pub(crate) fn padding<T: Add<Output = T> + Mul<Output = T>>(size: T, largest: T, unit: T) -> T {
    unit * (size + largest)
}

/// The origins of near planes and far ones.
#[inline(always)]
pub(crate) fn moved<T: Copy + Add<Output = T> + Sub<Output = T>>(origin: T, ahead: T) -> [T; 2] {
    [origin + ahead, origin - ahead]
}

/// One over a length, which may be 0.
#[inline(always)]
fn inverse(along: f32) -> f32 {
    1.0 / if along > ALMOST_ZERO { along } else { ALMOST_ZERO }
}

impl Slabs {
    /// For a ray through boxes whose coordinates are no larger than `largest`.
    #[inline(always)]
    pub(crate) fn new(
        origin: [f32; 3],
        direction: [f32; 3],
        nearest: f32,
        largest: [f32; 3],
    ) -> Self {
        let mut slabs =
            Self { origin: [[0.0; 2]; 3], inverse: [[0.0; 2]; 3], turned: [0; 3], nearest };
        for axis in 0..3 {
            let pad = padding(origin[axis].abs(), largest[axis], PADDING);
            let inverse = inverse(direction[axis].abs());
            slabs.set(axis, origin[axis], direction[axis], pad, [inverse; 2]);
        }
        slabs
    }

    /// An axis: the ray's own origin and direction there, how far the origins are moved, and one over
    /// the lengths of the directions to near planes and far ones.
    #[inline(always)]
    fn set(&mut self, axis: usize, origin: f32, direction: f32, pad: f32, inverse: [f32; 2]) {
        let turned = direction.is_sign_negative();
        let sign = if turned { -1.0 } else { 1.0 };
        self.origin[axis] = moved(origin, sign * pad);
        self.inverse[axis] = inverse.map(|inverse| sign * inverse);
        self.turned[axis] = usize::from(turned);
    }

    /// For what lies within `reach + distance * growth` of a ray, axis by axis, up to the distance
    /// `farthest`.
    pub(crate) fn widening(
        origin: [f32; 3],
        direction: [f32; 3],
        [nearest, farthest]: [f32; 2],
        largest: [f32; 3],
        reach: [f32; 3],
        growth: [f32; 3],
    ) -> Self {
        let mut slabs =
            Self { origin: [[0.0; 2]; 3], inverse: [[0.0; 2]; 3], turned: [0; 3], nearest };
        for axis in 0..3 {
            let mut along = direction[axis].abs();
            let mut growth = growth[axis];
            let mut pad = padding(origin[axis].abs(), largest[axis], PADDING) + reach[axis];
            if growth > 0.0 && along <= growth {
                // The sides go both ways: as wide everywhere as at the end.
                pad += farthest * (along + growth);
                (along, growth) = (0.0, 0.0);
            }
            let inverse = [inverse(along + growth), inverse(along - growth)];
            slabs.set(axis, origin[axis], direction[axis], pad, inverse);
        }
        slabs
    }
}

/// The distances at which a line meets the boxes of a node's children, and a bit for each that it
/// meets before `farthest`.
#[inline(always)]
pub(crate) fn meet<S: Simd>(
    simd: S,
    node: &Node,
    slabs: &Slabs,
    farthest: f32,
) -> ([f32; WIDTH], u32) {
    let mut near = f32x8::splat(simd, slabs.nearest);
    let mut far = f32x8::splat(simd, farthest);
    for axis in 0..3 {
        let turned = slabs.turned[axis] & 1;
        let near_plane = f32x8::simd_from(simd, node.planes[axis][turned]);
        let far_plane = f32x8::simd_from(simd, node.planes[axis][turned ^ 1]);
        let [near_origin, far_origin] = slabs.origin[axis];
        let [near_inverse, far_inverse] = slabs.inverse[axis];
        near = ((near_plane - near_origin) * near_inverse).max(near);
        far = ((far_plane - far_origin) * far_inverse).min(far);
    }
    let mut distances = [0.0; WIDTH];
    near.store_slice(&mut distances);
    (distances, near.simd_le(far).to_bitmask() as u32)
}

/// [`meet`] for callers outside of vector code.
pub(crate) fn step(level: Level, node: &Node, slabs: &Slabs, farthest: f32) -> ([f32; WIDTH], u32) {
    dispatch_long!(level, simd => meet(simd, node, slabs, farthest))
}

/// Places still to be visited: distance and child in one number, so that sorting is comparing
/// integers. Depths are bounded (see `split`): up to 67 levels with seven left at each.
pub(crate) struct Stack {
    entries: Box<[u64; Self::SIZE]>,
    top: usize,
}

impl Stack {
    const SIZE: usize = 512;

    pub(crate) fn new() -> Self {
        Self { entries: Box::new([0; Self::SIZE]), top: 0 }
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.top = 0;
    }

    /// Puts the children whose bit is set on top, the nearest topmost.
    #[inline(always)]
    pub(crate) fn push(&mut self, node: &Node, distances: &[f32; WIDTH], mut bits: u32) {
        let bottom = self.top;
        while bits != 0 {
            let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
            bits &= bits - 1;
            self.insert(bottom, distances[slot], node.children[slot].0);
        }
    }

    /// The same, with the children's places instead: the node's number times eight, and the slot.
    #[inline(always)]
    pub(crate) fn push_places(&mut self, node: usize, distances: &[f32; WIDTH], mut bits: u32) {
        let bottom = self.top;
        while bits != 0 {
            let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
            bits &= bits - 1;
            self.insert(bottom, distances[slot], (node * WIDTH + slot) as u32);
        }
    }

    #[inline(always)]
    fn insert(&mut self, bottom: usize, distance: f32, word: u32) {
        // Distances are not negative, but for the sign of a zero.
        let distance = u64::from(distance.to_bits() & !(1 << 31));
        let key = distance << 32 | u64::from(word);
        let mut place = self.top;
        while place > bottom && self.entries[(place - 1) & (Self::SIZE - 1)] < key {
            self.entries[place & (Self::SIZE - 1)] = self.entries[(place - 1) & (Self::SIZE - 1)];
            place -= 1;
        }
        self.entries[place & (Self::SIZE - 1)] = key;
        self.top += 1;
    }

    /// The nearest child whose box begins no farther than `farthest`.
    #[inline(always)]
    pub(crate) fn pop(&mut self, farthest: f32) -> Option<Child> {
        self.pop_word(farthest).map(Child)
    }

    /// The same for children that were pushed by their places.
    #[inline(always)]
    pub(crate) fn pop_place(&mut self, farthest: f32) -> Option<usize> {
        self.pop_word(farthest).map(|word| word as usize)
    }

    #[inline(always)]
    fn pop_word(&mut self, farthest: f32) -> Option<u32> {
        while self.top > 0 {
            self.top -= 1;
            let key = self.entries[self.top & (Self::SIZE - 1)];
            if f32::from_bits((key >> 32) as u32) <= farthest {
                return Some(key as u32);
            }
        }
        None
    }
}

/// A walk through all leaves whose boxes pass a test, in no particular order.
pub(crate) struct Walk<'t> {
    nodes: &'t [Node],
    stack: Vec<Child>,
}

impl<'t> Walk<'t> {
    pub(crate) fn new(nodes: &'t [Node]) -> Self {
        let root = nodes.first().map(|_| Child::inner(0));
        Self { nodes, stack: root.into_iter().collect() }
    }

    /// Where the next leaf's blocks begin, in a tree over triangles; `test` gives a bit for each child of a node to visit.
    pub(crate) fn next(&mut self, test: impl Fn(&Node) -> u32) -> Option<usize> {
        while let Some(child) = self.stack.pop() {
            if let Some(block) = child.as_block() {
                return Some(block);
            }
            let node = &self.nodes[child.0 as usize];
            let mut bits = test(node);
            while bits != 0 {
                let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
                bits &= bits - 1;
                self.stack.push(node.children[slot]);
            }
        }
        None
    }
}
