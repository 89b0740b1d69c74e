//! Colours of the pixels of a tile, shaded once for all of their samples.

use crate::plane::TILE_BLOCKS;
use luxel_math::{LANES, Simd, f32x16, mask32x16, prelude::*, u32x16};

/// Colours of a block: red, green, blue, alpha of each lane.
pub(super) type BlockColors = [[f32; LANES]; 4];

/// The colours that pixels were shaded with last. One sample has no use for them.
#[derive(Debug, Default)]
pub(super) struct ShadedBlocks {
    /// Of each pixel the entry, from 1 on; 0 for none.
    numbers: Vec<[u32; LANES]>,
    colors: Vec<BlockColors>,
}

impl ShadedBlocks {
    /// Forgets all, and makes room if pixels have several samples.
    pub(super) fn restart(&mut self, samples: usize) {
        let blocks = if samples > 1 { TILE_BLOCKS } else { 0 };
        self.numbers.clear();
        self.numbers.resize(blocks, [0; LANES]);
        self.colors.resize(blocks, [[0.0; LANES]; 4]);
    }

    /// Whether colours are kept.
    #[inline(always)]
    pub(super) fn keeps(&self) -> bool {
        !self.colors.is_empty()
    }

    /// The colours of a block, if they are kept, and the lanes in which they are those of an entry of each lane's own.
    #[inline(always)]
    pub(super) fn get<S: Simd>(
        &self,
        numbers: u32x16<S>,
        block: usize,
    ) -> Option<(&BlockColors, u32)> {
        let kept = u32x16::from_slice(numbers.simd, self.numbers.get(block)?);
        let lanes = kept.simd_eq(numbers).to_bitmask() as u32;
        Some((self.colors.get(block)?, lanes))
    }

    /// Keeps the colours of some lanes of a block.
    #[inline(always)]
    pub(super) fn put<S: Simd>(
        &mut self,
        numbers: u32x16<S>,
        colors: [f32x16<S>; 4],
        lanes: u32,
        block: usize,
    ) {
        let simd = numbers.simd;
        let (Some(kept), Some(of)) = (self.numbers.get_mut(block), self.colors.get_mut(block))
        else {
            return;
        };
        let mask = mask32x16::from_bitmask(simd, u64::from(lanes));
        mask.select(numbers, u32x16::from_slice(simd, kept)).store_slice(kept);
        for (kept, color) in of.iter_mut().zip(colors) {
            mask.select(color, f32x16::from_slice(simd, kept)).store_slice(kept);
        }
    }
}
