//! Colours of the blocks of one piece, shaded once for all samples of their pixels.

use crate::plane::TILE_BLOCKS;
use luxel_math::LANES;

/// Colours of a block: red, green, blue, alpha of each lane.
pub(super) type BlockColors = [[f32; LANES]; 4];

/// Colours by blocks, each of the piece that was shaded there last.
#[derive(Debug)]
pub(super) struct ShadedBlocks {
    /// The piece's entry, from 1 on; 0 for none.
    numbers: [u32; TILE_BLOCKS],
    colors: Vec<BlockColors>,
}

impl Default for ShadedBlocks {
    fn default() -> Self {
        Self { numbers: [0; TILE_BLOCKS], colors: Vec::new() }
    }
}

impl ShadedBlocks {
    /// Forgets all, and makes room if pixels have several samples: one sample has no use for it.
    pub(super) fn restart(&mut self, samples: usize) {
        self.numbers.fill(0);
        if samples > 1 {
            self.colors.resize(TILE_BLOCKS, [[0.0; LANES]; 4]);
        } else {
            self.colors = Vec::new();
        }
    }

    /// The colours of a piece in a block, if they are known.
    #[inline(always)]
    pub(super) fn get(&self, number: u32, block: usize) -> Option<&BlockColors> {
        if self.numbers[block] == number { self.colors.get(block) } else { None }
    }

    /// Where the colours of a piece in a block are kept, if they are.
    #[inline(always)]
    pub(super) fn place(&mut self, number: u32, block: usize) -> Option<&mut BlockColors> {
        let place = self.colors.get_mut(block)?;
        self.numbers[block] = number;
        Some(place)
    }

    /// Whether colours are kept.
    #[inline(always)]
    pub(super) fn keeps(&self) -> bool {
        !self.colors.is_empty()
    }
}
