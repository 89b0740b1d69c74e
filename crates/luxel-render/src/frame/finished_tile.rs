//! The pixels of a tile, finished block by block as the kernels that light them put them there.

use super::tiles::{TilePixels, put_block};
use crate::resolve::{Bytes, Finish, Linear};
use luxel_lighting::PictureEncoding;
use luxel_math::{LANES, Simd, f32x16};
use std::ops::Range;

/// The pixels of a tile, by what is kept of them. An enum, not a type parameter, so that kernels are compiled once for
/// both.
pub(crate) enum FinishedTile<'t> {
    Linear(Pixels<'t, [f32; 4]>),
    Bytes(PictureEncoding, Pixels<'t, [u8; 4]>),
}

/// Pixels row by row, and that of the background.
pub(crate) struct Pixels<'t, T> {
    pub(super) pixels: &'t mut TilePixels<T>,
    pub(super) background: T,
}

/// What is kept of the pixels of tiles.
pub(crate) trait FinishTile: Finish {
    /// A tile of such pixels.
    fn tile<'t>(&self, pixels: Pixels<'t, Self::Pixel>) -> FinishedTile<'t>;
}

impl FinishTile for Linear {
    fn tile<'t>(&self, pixels: Pixels<'t, [f32; 4]>) -> FinishedTile<'t> {
        FinishedTile::Linear(pixels)
    }
}

impl FinishTile for Bytes {
    fn tile<'t>(&self, pixels: Pixels<'t, [u8; 4]>) -> FinishedTile<'t> {
        FinishedTile::Bytes(self.0, pixels)
    }
}

impl FinishedTile<'_> {
    /// Writes a block of lit pixels.
    #[inline(always)]
    pub(super) fn put<S: Simd>(&mut self, simd: S, block: usize, color: [f32x16<S>; 4]) {
        match self {
            Self::Linear(tile) => put_block(tile.pixels, block, &Linear.block(simd, color)),
            Self::Bytes(encoding, tile) => {
                put_block(tile.pixels, block, &Bytes(*encoding).block(simd, color));
            }
        }
    }

    /// Writes a block of the background.
    pub(super) fn put_background(&mut self, block: usize) {
        match self {
            Self::Linear(tile) => put_block(tile.pixels, block, &[tile.background; LANES]),
            Self::Bytes(_, tile) => put_block(tile.pixels, block, &[tile.background; LANES]),
        }
    }

    /// Fills rows of blocks with the background.
    pub(super) fn fill_rows(&mut self, blocks: Range<usize>) {
        // Rows of blocks are rows of pixels: sixteen to a block.
        let pixels = blocks.start * LANES..blocks.end * LANES;
        match self {
            Self::Linear(tile) => tile.pixels[pixels].fill(tile.background),
            Self::Bytes(_, tile) => tile.pixels[pixels].fill(tile.background),
        }
    }
}
