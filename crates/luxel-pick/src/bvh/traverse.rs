//! From boxes to the leaves that a ray meets.
//!
//! A box is met if the ray's ways between its three pairs of planes have a stretch in common (Kay
//! and Kajiya 1986). Rounding must never lose a box, so near planes are looked at from an origin
//! that lies a little forward and far ones from one a little back: several units of the last place
//! of the largest coordinate. Rays may also widen with distance, as far as the samples of a pixel's
//! grid reach; then the two origins' directions differ, too.

use super::{Block, Child, Node, WIDTH};
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};
use std::cell::Cell;
use std::hint::black_box;
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

/// Places in a tree that are still to be visited, each as its distance and its word in one number, so
/// that sorting is comparing integers. Depths are bounded (see `split`): up to 67 levels with seven
/// left at each. How many there are, the `top`, is for who visits to keep, at hand.
pub(crate) struct Places([Cell<u64>; Self::SIZE]);

impl Places {
    const SIZE: usize = 512;

    pub(crate) const fn new() -> Self {
        Self([const { Cell::new(0) }; Self::SIZE])
    }

    #[inline(always)]
    fn get(&self, place: usize) -> u64 {
        self.0[place & (Self::SIZE - 1)].get()
    }

    #[inline(always)]
    fn set(&self, place: usize, key: u64) {
        self.0[place & (Self::SIZE - 1)].set(key);
    }

    /// The word of the nearest place whose box begins no farther than `farthest`, from the top down.
    #[inline(always)]
    pub(crate) fn pop(&self, top: &mut usize, farthest: f32) -> Option<u32> {
        while *top > 0 {
            *top -= 1;
            let key = self.get(*top);
            if f32::from_bits((key >> 32) as u32) <= farthest {
                return Some(key as u32);
            }
        }
        None
    }

    /// Puts those of a node's children whose bit is set on top, the nearest topmost; `words` stand for
    /// them.
    #[inline(always)]
    pub(crate) fn push(
        &self,
        top: &mut usize,
        words: &[u32; WIDTH],
        distances: &[f32; WIDTH],
        mut bits: u32,
    ) {
        let bottom = *top;
        while bits != 0 {
            self.insert(bottom, top, take(words, distances, &mut bits));
        }
    }

    /// The same for at least two, all but the nearest, whose word is the result; all are read ahead.
    #[inline(always)]
    pub(crate) fn push_farther(
        &self,
        top: &mut usize,
        words: &[u32; WIDTH],
        distances: &[f32; WIDTH],
        mut bits: u32,
        ahead: Ahead<'_>,
    ) -> u32 {
        let bottom = *top;
        let mut nearest = take(words, distances, &mut bits);
        ahead.read(Child(nearest as u32));
        loop {
            let key = take(words, distances, &mut bits);
            ahead.read(Child(key as u32));
            self.insert(bottom, top, nearest.max(key));
            nearest = nearest.min(key);
            if bits == 0 {
                return nearest as u32;
            }
        }
    }

    #[inline(always)]
    fn insert(&self, bottom: usize, top: &mut usize, key: u64) {
        let mut place = *top;
        while place > bottom && self.get(place - 1) < key {
            self.set(place, self.get(place - 1));
            place -= 1;
        }
        self.set(place, key);
        *top += 1;
    }
}

/// The key of the child of the lowest bit, which is cleared.
#[inline(always)]
fn take(words: &[u32; WIDTH], distances: &[f32; WIDTH], bits: &mut u32) -> u64 {
    let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
    *bits &= *bits - 1;
    // Distances are not negative, but for the sign of a zero.
    let distance = u64::from(distances[slot].to_bits() & !(1 << 31));
    distance << 32 | u64::from(words[slot])
}

/// What is visited soon, brought near: it is read without asking what it is, so that no one waits.
#[derive(Clone, Copy)]
pub(crate) struct Ahead<'t> {
    pub(crate) nodes: &'t [Node],
    /// Of the leaves.
    pub(crate) words: &'t [u32],
}

impl Ahead<'_> {
    /// Begins to read a node, each of its cache lines, or a leaf's first one.
    #[inline(always)]
    pub(crate) fn read(&self, child: Child) {
        if let Some(start) = child.as_block() {
            black_box(self.words[start]);
        } else {
            let node = &self.nodes[child.0 as usize];
            let [[[x, ..], _], [[y, ..], _], [[z, ..], _]] = node.planes;
            black_box(x);
            black_box(y);
            black_box(z);
            black_box(node.children[0]);
        }
    }

    /// Begins to read those of a node's children whose bit is set.
    #[inline(always)]
    pub(crate) fn read_children(&self, node: &Node, mut bits: u32) {
        while bits != 0 {
            let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
            bits &= bits - 1;
            self.read(node.children[slot]);
        }
    }

    /// Begins to read the lines that a block of no more than 48 words may have: where its rows are is
    /// known only when the first line is there.
    #[inline(always)]
    pub(crate) fn read_block(block: &Block) {
        black_box(block[16]);
        black_box(block[32]);
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
