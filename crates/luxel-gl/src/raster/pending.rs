//! Fragments that mix with what is there, of pieces that cover blocks in part. They are deferred, so that the fragments of
//! a block are shaded together, whatever pieces they are of.
//!
//! A sample has one pending fragment at most, and all of a tile go through one pipeline. A second fragment of a sample, or
//! a piece with other tests, first has the pending ones carried out: each sample meets its fragments in the order of the
//! calls.

use super::lighter::lanes_with_entry;
use crate::plane::{Blocks, TILE_BLOCKS};
use luxel_math::{LANES, Simd, f32x16, mask32x16, prelude::*, u32x16};

/// Words with a bit for each block of a tile.
const WORDS: usize = TILE_BLOCKS / u64::BITS as usize;

/// The pending fragments of one sample of a tile.
#[derive(Debug)]
pub(super) struct PendingFragments {
    /// Of each pixel the entry that its fragment is of, from 1 on; 0 without one.
    numbers: Box<Blocks<u32>>,
    /// As they are kept.
    depths: Box<Blocks<f32>>,
    /// The blocks that have some.
    blocks: [u64; WORDS],
}

impl Default for PendingFragments {
    fn default() -> Self {
        Self {
            numbers: Box::new([[0; LANES]; TILE_BLOCKS]),
            depths: Box::new([[0.0; LANES]; TILE_BLOCKS]),
            blocks: [0; WORDS],
        }
    }
}

impl PendingFragments {
    /// Whether a block has some.
    #[inline(always)]
    pub(super) fn has(&self, block: usize) -> bool {
        self.blocks[block / 64] >> (block % 64) & 1 == 1
    }

    /// The lanes of a block whose pixels have a fragment.
    #[inline(always)]
    pub(super) fn lanes<S: Simd>(&self, simd: S, block: usize) -> u32 {
        if self.has(block) { lanes_with_entry(self.numbers(simd, block)) } else { 0 }
    }

    /// The entries of a block's fragments; 0 at pixels without one.
    #[inline(always)]
    pub(super) fn numbers<S: Simd>(&self, simd: S, block: usize) -> u32x16<S> {
        u32x16::from_slice(simd, &self.numbers[block])
    }

    /// Takes fragments of an entry, at pixels that have none.
    #[inline(always)]
    pub(super) fn put<S: Simd>(&mut self, number: u32, lanes: u32, z: f32x16<S>, block: usize) {
        let simd = z.simd;
        let mask = mask32x16::from_bitmask(simd, u64::from(lanes));
        let (numbers, depths) = (&mut self.numbers[block], &mut self.depths[block]);
        let others = u32x16::from_slice(simd, numbers);
        mask.select(u32x16::splat(simd, number), others).store_slice(numbers);
        mask.select(z, f32x16::from_slice(simd, depths)).store_slice(depths);
        self.blocks[block / 64] |= 1 << (block % 64);
    }

    /// Takes out the fragments of a block: their entries, 0 at pixels without one, and depths.
    #[inline(always)]
    pub(super) fn take(&mut self, block: usize) -> ([u32; LANES], [f32; LANES]) {
        self.blocks[block / 64] &= !(1 << (block % 64));
        (std::mem::replace(&mut self.numbers[block], [0; LANES]), self.depths[block])
    }

    /// A block that has some.
    #[inline(always)]
    pub(super) fn any_block(&self) -> Option<usize> {
        let word = self.blocks.iter().position(|word| *word != 0)?;
        Some(word * 64 + self.blocks[word].trailing_zeros() as usize)
    }
}
