//! The stack of a traversal.

use crate::tree::{Child, TreeView, WIDTH};
use std::cell::Cell;

/// Subtrees that are still to be visited, each as its entry distance and its word in one integer, so
/// that sorting compares integers.
///
/// Depths are bounded by the builder: up to 67 levels with seven children left at each. The number of
/// entries, `top`, is kept by the traversal, in a register.
pub(crate) struct TraversalStack([Cell<u64>; Self::SIZE]);

/// Rays that take turns: while one waits for memory, the others compute. Six were no better.
pub(crate) const TURNS: usize = 4;

/// The stacks of a thread.
pub(crate) struct Stacks {
    /// One for each turn; packets and single rays use the first.
    pub(crate) turns: [TraversalStack; TURNS],
    /// For a rescaled ray, which is traced while others are on their way.
    pub(crate) rescaled: TraversalStack,
}

thread_local! {
    pub(crate) static STACKS: Stacks = const {
        Stacks { turns: [const { TraversalStack::new() }; TURNS], rescaled: TraversalStack::new() }
    };
}

impl TraversalStack {
    const SIZE: usize = 512;

    pub(crate) const fn new() -> Self {
        Self([const { Cell::new(0) }; Self::SIZE])
    }

    #[inline(always)]
    fn get(&self, at: usize) -> u64 {
        self.0[at & (Self::SIZE - 1)].get()
    }

    #[inline(always)]
    fn set(&self, at: usize, key: u64) {
        self.0[at & (Self::SIZE - 1)].set(key);
    }

    /// Writes a child and the rays that ask for it, a bit each, above the top; whether it stays is the
    /// caller's to say by raising the top.
    #[inline(always)]
    pub(crate) fn put_for(&self, top: usize, child: Child, rays: u32) {
        self.set(top, u64::from(rays) << 32 | u64::from(child.0));
    }

    /// Pops what [`Self::put_for`] has written.
    #[inline(always)]
    pub(crate) fn pop_for(&self, top: &mut usize) -> Option<(u32, u32)> {
        *top = top.checked_sub(1)?;
        let key = self.get(*top);
        Some((key as u32, (key >> 32) as u32))
    }

    /// Pops entries until one begins no farther than `farthest`; returns its word.
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

    /// Pushes the children of a node whose bit is set, the nearest last. `words` stand for them.
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
            self.insert(bottom, top, take_key(words, distances, &mut bits));
        }
    }

    /// Pushes all of at least two children but the nearest, whose word it returns, and prefetches all.
    ///
    /// The second nearest ends on top; the order below it isn't exact, since branches that sort can't be
    /// predicted.
    #[inline(always)]
    pub(crate) fn push_farther(
        &self,
        top: &mut usize,
        words: &[u32; WIDTH],
        distances: &[f32; WIDTH],
        mut bits: u32,
        tree: TreeView<'_>,
    ) -> u32 {
        let first = take_key(words, distances, &mut bits);
        tree.prefetch(Child(first as u32));
        let second = take_key(words, distances, &mut bits);
        tree.prefetch(Child(second as u32));
        let (mut nearest, mut next) = (first.min(second), first.max(second));
        while bits != 0 {
            let key = take_key(words, distances, &mut bits);
            tree.prefetch(Child(key as u32));
            let farther = nearest.max(key);
            nearest = nearest.min(key);
            self.set(*top, next.max(farther));
            *top += 1;
            next = next.min(farther);
        }
        self.set(*top, next);
        *top += 1;
        nearest as u32
    }

    #[inline(always)]
    fn insert(&self, bottom: usize, top: &mut usize, key: u64) {
        let mut at = *top;
        while at > bottom && self.get(at - 1) < key {
            self.set(at, self.get(at - 1));
            at -= 1;
        }
        self.set(at, key);
        *top += 1;
    }
}

/// The key of the child of the lowest bit; clears the bit.
#[inline(always)]
fn take_key(words: &[u32; WIDTH], distances: &[f32; WIDTH], bits: &mut u32) -> u64 {
    let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
    *bits &= *bits - 1;
    // Distances are not negative, apart from the sign of a zero.
    let distance = u64::from(distances[slot].to_bits() & !(1 << 31));
    distance << 32 | u64::from(words[slot])
}
