//! The visibility buffer of one tile: for every sample the nearest depth and the triangle's id.

use crate::cluster::SLOT_BITS;
use crate::setup::Region;
use luxel_math::LANES;
use luxel_scene::Size;

/// Pixels of a tile's side. 64 gives a worker a piece that fits the cache (32 KiB a sample plane)
/// and leaves some hundred pieces to share at usual sizes.
pub const TILE: i32 = 64;
/// Pixels of a block's side: sixteen lanes.
pub const BLOCK: i32 = 4;
/// Blocks of a tile's side.
pub const BLOCKS: i32 = TILE / BLOCK;
const BLOCKS_OF_TILE: usize = (BLOCKS * BLOCKS) as usize;
const _: () = assert!(BLOCK * BLOCK == LANES as i32, "a block is one vector");

/// Blocks of a side of a cell, the grain of hidden clusters: 16 pixels.
const CELL_BLOCKS: i32 = 4;
/// Cells of a tile's side.
pub(crate) const CELLS: i32 = BLOCKS / CELL_BLOCKS;
const _: () = assert!(CELLS * CELLS <= u16::BITS as i32, "a bit a cell");

/// The triangle that a sample sees.
///
/// Its number is the cluster's among those of all instances, times 128, plus the triangle's slot;
/// [`Frame`](crate::Frame) turns it into instance and triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TriangleId(pub u32);

impl TriangleId {
    /// Nothing: the background.
    pub const NONE: Self = Self(u32::MAX);

    pub(crate) const fn new(cluster: u32, slot: usize) -> Self {
        Self(cluster << SLOT_BITS | slot as u32)
    }

    pub(crate) const fn cluster(self) -> u32 {
        self.0 >> SLOT_BITS
    }

    pub(crate) const fn slot(self) -> usize {
        (self.0 & ((1 << SLOT_BITS) - 1)) as usize
    }
}

/// One sample of each pixel of a tile, in blocks of 4x4 pixels, row by row.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Reversed depth, 0 where nothing was drawn: 1 at the near plane, 0 at the far one. Infinite
    /// outside of the window.
    pub depth: Box<[[f32; LANES]; BLOCKS_OF_TILE]>,
    /// [`TriangleId`]s as numbers.
    pub ids: Box<[[u32; LANES]; BLOCKS_OF_TILE]>,
}

impl Plane {
    fn new() -> Self {
        Self {
            depth: Box::new([[0.0; LANES]; BLOCKS_OF_TILE]),
            ids: Box::new([[TriangleId::NONE.0; LANES]; BLOCKS_OF_TILE]),
        }
    }

    fn clear(&mut self) {
        self.depth.as_flattened_mut().fill(0.0);
        self.ids.as_flattened_mut().fill(TriangleId::NONE.0);
    }

    /// Keeps everything out of the pixels from column `width` and from row `height` on.
    fn close(&mut self, width: i32, height: i32) {
        if [width, height] == [TILE; 2] {
            return;
        }
        for y in 0..TILE {
            for x in if y < height { width } else { 0 }..TILE {
                let (block, lane) = Tile::place(x, y);
                self.depth[block][lane] = f32::INFINITY;
            }
        }
    }
}

/// The visibility buffer of a tile.
#[derive(Clone, Debug)]
pub struct Tile {
    /// The tile's pixels that lie in the window.
    pub(crate) region: Region,
    pub(crate) planes: Vec<Plane>,
    /// The farthest depth in each cell, over all samples; a bound while its bit in `stale` is set.
    farthest: [f32; (CELLS * CELLS) as usize],
    stale: u16,
}

impl Tile {
    /// A buffer for tiles of `samples` samples a pixel.
    #[must_use]
    pub fn new(samples: usize) -> Self {
        let region = Region { x: 0, y: 0, width: TILE, height: TILE };
        let farthest = [0.0; (CELLS * CELLS) as usize];
        Self { region, planes: vec![Plane::new(); samples], farthest, stale: 0 }
    }

    /// The first pixel: column and row.
    #[must_use]
    pub fn origin(&self) -> [i32; 2] {
        [self.region.x, self.region.y]
    }

    /// The planes, one for each sample.
    #[must_use]
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// Where pixel (x, y) of the tile is kept: block and lane.
    #[must_use]
    pub const fn place(x: i32, y: i32) -> (usize, usize) {
        let block = y / BLOCK * BLOCKS + x / BLOCK;
        let lane = y % BLOCK * BLOCK + x % BLOCK;
        (block as usize, lane as usize)
    }

    /// The id that a sample of pixel (x, y) of the tile sees.
    #[must_use]
    pub fn id(&self, x: i32, y: i32, sample: usize) -> TriangleId {
        let (block, lane) = Self::place(x, y);
        TriangleId(self.planes[sample].ids[block][lane])
    }

    /// Forgets everything, and moves to the tile of a window whose first pixel is (x, y).
    pub(crate) fn clear(&mut self, x: i32, y: i32, window: Size) {
        let width = TILE.min(window.width as i32 - x);
        let height = TILE.min(window.height as i32 - y);
        self.region = Region { x, y, width, height };
        for plane in &mut self.planes {
            plane.clear();
            plane.close(width, height);
        }
        self.farthest = [0.0; (CELLS * CELLS) as usize];
        self.stale = 0;
    }

    /// Takes over another tile's content.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.region = other.region;
        for (plane, source) in self.planes.iter_mut().zip(&other.planes) {
            plane.depth.copy_from_slice(source.depth.as_slice());
            plane.ids.copy_from_slice(source.ids.as_slice());
        }
        self.farthest = other.farthest;
        self.stale = other.stale;
    }

    /// Notes that blocks of `region`, in blocks of the tile, may have become nearer.
    pub(crate) fn touch(&mut self, left: i32, top: i32, right: i32, bottom: i32) {
        for row in top / CELL_BLOCKS..=bottom / CELL_BLOCKS {
            for column in left / CELL_BLOCKS..=right / CELL_BLOCKS {
                self.stale |= 1 << (row * CELLS + column);
            }
        }
    }

    /// Notes that a block may have become nearer.
    #[inline(always)]
    pub(crate) fn touch_block(&mut self, block: i32) {
        let (row, column) = (block / BLOCKS / CELL_BLOCKS, block % BLOCKS / CELL_BLOCKS);
        self.stale |= 1 << (row * CELLS + column);
    }

    /// Whether everything drawn so far in the pixels left..=right, top..=bottom of the tile is
    /// nearer than `nearest`.
    pub(crate) fn hides(&mut self, [left, top, right, bottom]: [i32; 4], nearest: f32) -> bool {
        let cell = CELL_BLOCKS * BLOCK;
        for row in top / cell..=bottom / cell {
            for column in left / cell..=right / cell {
                let number = row * CELLS + column;
                if self.stale >> number & 1 == 1 {
                    self.farthest[number as usize] = self.farthest_of(row, column);
                    self.stale &= !(1 << number);
                }
                if self.farthest[number as usize] <= nearest {
                    return false;
                }
            }
        }
        true
    }

    fn farthest_of(&self, row: i32, column: i32) -> f32 {
        // Depths are 0 and more, and so in the order of their bits: a minimum that takes many at once.
        let mut farthest = f32::INFINITY.to_bits() as i32;
        for plane in &self.planes {
            for block_row in row * CELL_BLOCKS..(row + 1) * CELL_BLOCKS {
                let first = (block_row * BLOCKS + column * CELL_BLOCKS) as usize;
                for value in plane.depth[first..first + CELL_BLOCKS as usize].as_flattened() {
                    farthest = farthest.min(value.to_bits() as i32);
                }
            }
        }
        f32::from_bits(farthest as u32)
    }
}
