//! The visibility buffer of one tile: for every sample the nearest depth and the triangle's id.

use crate::cluster::SLOT_BITS;
use crate::setup::Region;
use luxel_math::{LANES, Simd, f32x16, i32x16, prelude::*};
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
const BLOCKS_OF_TILE: usize = (BLOCKS * BLOCKS) as usize;
const _: () = assert!(BLOCK * BLOCK == LANES as i32, "a block is one vector");

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
}

impl Tile {
    /// A buffer for tiles of `samples` samples a pixel.
    #[must_use]
    pub fn new(samples: usize) -> Self {
        let region = Region { x: 0, y: 0, width: TILE, height: TILE };
        Self { region, planes: vec![Plane::new(); samples] }
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
    }

    /// Takes over another tile's content.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.region = other.region;
        for (plane, source) in self.planes.iter_mut().zip(&other.planes) {
            plane.depth.copy_from_slice(source.depth.as_slice());
            plane.ids.copy_from_slice(source.ids.as_slice());
        }
    }

    /// Whether everything drawn so far in the pixels left..=right, top..=bottom of the window is
    /// nearer than `nearest`, as far as they are the tile's.
    #[inline(always)]
    pub(crate) fn hides<S: Simd>(
        &self,
        simd: S,
        [left, top, right, bottom]: [i32; 4],
        nearest: f32,
    ) -> bool {
        let Region { x, y, .. } = self.region;
        let (left, right) = ((left - x).max(0), (right - x).min(TILE - 1));
        let (top, bottom) = ((top - y).max(0), (bottom - y).min(TILE - 1));
        let lane_x = i32x16::simd_from(simd, LANE_X);
        let lane_y = i32x16::simd_from(simd, LANE_Y);
        for row in top / BLOCK..=bottom / BLOCK {
            let y = lane_y + row * BLOCK;
            let above_or_below = y.simd_lt(top) | y.simd_gt(bottom);
            for column in left / BLOCK..=right / BLOCK {
                let x = lane_x + column * BLOCK;
                let outside = above_or_below | x.simd_lt(left) | x.simd_gt(right);
                let block = (row * BLOCKS + column) as usize & (BLOCKS_OF_TILE - 1);
                for plane in &self.planes {
                    let depth = f32x16::from_slice(simd, &plane.depth[block]);
                    if !(outside | depth.simd_gt(nearest)).all_true() {
                        return false;
                    }
                }
            }
        }
        true
    }
}
