//! The grid of tiles and blocks that the window is divided into.

use luxel_math::LANES;
use luxel_scene::Size;

/// Pixels of a tile's side. 64 gives a worker a piece that fits the cache (32 KiB a sample plane)
/// and leaves some hundred pieces to share at usual sizes.
pub const TILE: i32 = 64;
/// Pixels of a block's side: sixteen lanes.
pub const BLOCK: i32 = 4;
/// Blocks of a tile's side.
pub const BLOCKS: i32 = TILE / BLOCK;
/// Columns and rows of a block's lanes.
pub(crate) const LANE_X: [i32; LANES] = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3];
pub(crate) const LANE_Y: [i32; LANES] = [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3];
/// Blocks of a tile.
pub(crate) const BLOCKS_OF_TILE: usize = (BLOCKS * BLOCKS) as usize;
const _: () = assert!(BLOCK * BLOCK == LANES as i32, "a block is one vector");

/// Pixels: first column and row, and how many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// The first column.
    pub x: i32,
    /// The first row.
    pub y: i32,
    /// How many columns.
    pub width: i32,
    /// How many rows.
    pub height: i32,
}

impl Region {
    /// All pixels of a window.
    #[must_use]
    pub fn whole(size: Size) -> Self {
        Self { x: 0, y: 0, width: size.width as i32, height: size.height as i32 }
    }

    /// The first and the last pixels: left, top, right and bottom.
    #[inline(always)]
    pub(crate) fn sides(self) -> [i32; 4] {
        [self.x, self.y, self.x + self.width - 1, self.y + self.height - 1]
    }
}
