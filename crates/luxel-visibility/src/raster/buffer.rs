//! The visibility buffer of one tile: for every sample the nearest depth and the triangle's id.

use super::last_drawn::LastDrawn;
use super::occlusion::BlockSummary;
use crate::types::{BLOCK, BLOCKS, BLOCKS_OF_TILE, Region, TILE, TriangleId};
use luxel_math::{LANES, lanes_of};
use luxel_scene::Size;

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

    /// Clears rows of blocks, a bit each.
    fn clear(&mut self, rows: u32) {
        let depth = self.depth.as_chunks_mut::<BLOCKS_OF_ROW>().0;
        let ids = self.ids.as_chunks_mut::<BLOCKS_OF_ROW>().0;
        for row in lanes_of(rows) {
            depth[row].as_flattened_mut().fill(0.0);
            ids[row].as_flattened_mut().fill(TriangleId::NONE.0);
        }
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
    /// What is known of blocks, so that less is cleared and asked.
    pub(super) summary: BlockSummary,
    pub(super) last_drawn: LastDrawn,
}

const BLOCKS_OF_ROW: usize = BLOCKS as usize;

impl Tile {
    /// A buffer for tiles of `samples` samples a pixel.
    #[must_use]
    pub fn new(samples: usize) -> Self {
        let region = Region { x: 0, y: 0, width: TILE, height: TILE };
        Self {
            region,
            planes: vec![Plane::new(); samples],
            summary: BlockSummary::new(),
            last_drawn: LastDrawn::default(),
        }
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

    /// Clears all planes, and moves to the tile of a window whose first pixel is (x, y).
    pub(crate) fn clear(&mut self, x: i32, y: i32, window: Size) {
        let width = TILE.min(window.width as i32 - x);
        let height = TILE.min(window.height as i32 - y);
        self.region = Region { x, y, width, height };
        for plane in &mut self.planes {
            plane.clear(self.summary.touched_rows());
            plane.close(width, height);
        }
        self.summary.clear();
        self.last_drawn = LastDrawn::default();
        if [width, height] != [TILE; 2] {
            self.summary.touch([0, 0, TILE - 1, TILE - 1]);
        }
    }

    /// Takes over another tile's content.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.region = other.region;
        self.summary.clone_from(&other.summary);
        self.last_drawn = other.last_drawn;
        for (plane, source) in self.planes.iter_mut().zip(&other.planes) {
            plane.depth.copy_from_slice(source.depth.as_slice());
            plane.ids.copy_from_slice(source.ids.as_slice());
        }
    }
}
