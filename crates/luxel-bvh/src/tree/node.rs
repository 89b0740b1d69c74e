//! Nodes: the boxes of eight children side by side.
//!
//! Eight is the width of an AVX2 vector, so one slab test covers a whole node (Wald, Benthin and
//! Boulos 2008). A node has 224 bytes and touches four cache lines wherever it begins. Quantized
//! nodes of 128 bytes were slower for a camera's rays: 1.17 of the time at 100 000 triangles, 1.12 at
//! a million.

use crate::aabb::Aabb;
use crate::pages::Pages;
use bytemuck::{Pod, Zeroable};

/// Children of a node, and the most triangles of a block: the lanes of a vector of eight.
pub const WIDTH: usize = 8;
/// The most triangles or boxes in one tree: 27 bits of a child word.
pub const MAX_TRIANGLES: usize = 1 << WORD_BITS;
const WORD_BITS: u32 = 27;
const LEAF: u32 = 1 << 31;

/// The boxes of up to eight children, and references to the children.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(32))]
pub struct Node {
    /// For each axis the low planes, then the high ones; an empty slot has low = inf, high = -inf.
    pub(crate) planes: [[[f32; WIDTH]; 2]; 3],
    pub(crate) children: [Child; WIDTH],
}

const _: () = assert!(size_of::<Node>() == 224, "a node touches four cache lines");

/// A reference to a child: an inner node, or a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct Child(
    // One bit says whether it is a leaf. A node has its index; a leaf over items four bits for their count
    // and 27 for the first, a leaf over triangles the index of its first word.
    pub(crate) u32,
);

impl Child {
    pub(crate) const NONE: Self = Self(LEAF);

    pub(crate) const fn inner(index: u32) -> Self {
        Self(index)
    }

    pub(crate) const fn items(start: usize, count: usize) -> Self {
        Self(LEAF | (count as u32) << WORD_BITS | start as u32)
    }

    /// A leaf over triangles, by the index of its first block's first word.
    pub(crate) const fn block(start: usize) -> Self {
        Self(LEAF | start as u32)
    }

    /// 1 for a leaf or an empty slot, 0 for an inner node.
    #[inline(always)]
    pub(crate) const fn leaf_bit(self) -> u32 {
        self.0 >> 31
    }

    /// The start of a leaf's first block, in a tree over triangles.
    #[inline(always)]
    pub(crate) const fn as_block(self) -> Option<usize> {
        if self.0 & LEAF == 0 { None } else { Some((self.0 & !LEAF) as usize) }
    }

    /// The first item of a leaf and their count, in a tree over items.
    #[inline(always)]
    pub(crate) const fn as_items(self) -> Option<(usize, usize)> {
        if self.0 & LEAF == 0 {
            return None;
        }
        let start = self.0 & ((1 << WORD_BITS) - 1);
        Some((start as usize, ((self.0 & !LEAF) >> WORD_BITS) as usize))
    }
}

impl Node {
    pub(crate) const EMPTY: Self = Self {
        planes: [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3],
        children: [Child::NONE; WIDTH],
    };

    pub(crate) fn set(&mut self, slot: usize, bounds: &Aabb, child: Child) {
        for axis in 0..3 {
            self.planes[axis][0][slot] = bounds.low[axis];
            self.planes[axis][1][slot] = bounds.high[axis];
        }
        self.children[slot] = child;
    }

    /// The planes of the children's boxes: for each axis the eight low ones, then the eight high
    /// ones. Empty slots have low = inf, high = -inf.
    #[must_use]
    #[inline(always)]
    pub const fn planes(&self) -> &[[[f32; WIDTH]; 2]; 3] {
        &self.planes
    }

    /// A child, by its slot from 0 to 7.
    #[must_use]
    #[inline(always)]
    pub const fn child(&self, slot: usize) -> Child {
        self.children[slot % WIDTH]
    }

    /// A bit for each slot that has a child.
    #[must_use]
    pub fn occupied(&self) -> u32 {
        (0..WIDTH)
            .fold(0, |bits, slot| bits | u32::from(self.children[slot] != Child::NONE) << slot)
    }

    pub(crate) fn aabb(&self, slot: usize) -> Aabb {
        Aabb {
            low: [0, 1, 2].map(|axis: usize| self.planes[axis][0][slot]),
            high: [0, 1, 2].map(|axis: usize| self.planes[axis][1][slot]),
        }
    }

    /// The children's words.
    #[inline(always)]
    pub(crate) fn words(&self) -> &[u32; WIDTH] {
        bytemuck::cast_ref(&self.children)
    }

    /// The box around all children.
    pub(crate) fn union(&self) -> Aabb {
        (0..WIDTH).fold(Aabb::EMPTY, |all, slot| all.union(&self.aabb(slot)))
    }
}

/// A tree over items that have boxes: nodes, and item numbers in leaf order. Children have higher
/// indices than their parents.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    pub(crate) nodes: Pages<Node>,
    pub(crate) items: Vec<u32>,
    pub(crate) bounds: Option<Aabb>,
}
