//! Sixteen samples to be shaded: mostly one for each pixel of a block.

use luxel_math::{LANES, SUBPIXELS};
use luxel_visibility::{BLOCK, BLOCKS, Samples, Tile, TriangleId};

/// Sixteen samples of one tile. Each row of lanes is a line of the cache.
#[repr(C, align(64))]
pub(crate) struct Batch {
    /// What each sample sees.
    pub(crate) ids: [u32; LANES],
    /// Where each lies, in pixels from the tile's first corner: multiples of 1/256.
    pub(crate) x: [f32; LANES],
    pub(crate) y: [f32; LANES],
    /// The first pixel of the tile.
    pub(crate) tile: [i32; 2],
    /// Whether all are known to see the same triangle.
    pub(crate) is_single: bool,
}

/// Columns and rows of a block's lanes.
const LANE_X: [f32; LANES] =
    [0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0];
const LANE_Y: [f32; LANES] =
    [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0];

/// The length of a step of 1/256 pixel.
const STEP: f32 = 1.0 / SUBPIXELS as f32;

impl Batch {
    /// One sample of each pixel of a block: for each an id and the number of the sample.
    #[inline(always)]
    pub(crate) fn new(
        tile: &Tile,
        block: usize,
        ids: [u32; LANES],
        sample: &[u32; LANES],
        samples: Samples,
    ) -> Self {
        let positions = samples.positions();
        let [left, top] = block_corner(block);
        let mut batch = Self { ids, ..Self::nothing(tile.origin()) };
        for lane in 0..LANES {
            let [x, y] = positions[sample[lane] as usize & (positions.len() - 1)];
            batch.x[lane] = left + LANE_X[lane] + x as f32 * STEP;
            batch.y[lane] = top + LANE_Y[lane] + y as f32 * STEP;
        }
        batch
    }

    /// The same sample of each pixel of a block, `within` the pixel.
    #[inline(always)]
    pub(crate) fn even(
        tile: &Tile,
        block: usize,
        ids: [u32; LANES],
        within: [f32; 2],
        is_single: bool,
    ) -> Self {
        let [left, top] = block_corner(block);
        let (left, top) = (left + within[0], top + within[1]);
        let mut batch = Self { ids, is_single, ..Self::nothing(tile.origin()) };
        for lane in 0..LANES {
            batch.x[lane] = left + LANE_X[lane];
            batch.y[lane] = top + LANE_Y[lane];
        }
        batch
    }

    /// Nothing in any lane.
    #[inline(always)]
    pub(crate) fn nothing(tile: [i32; 2]) -> Self {
        Self {
            tile,
            ids: [TriangleId::NONE.0; LANES],
            is_single: false,
            x: [0.0; LANES],
            y: [0.0; LANES],
        }
    }

    /// Puts a sample of any pixel of the tile into a lane: where it lies in its block's lane, in steps of
    /// 1/256 pixel, and what it sees.
    #[inline(always)]
    pub(crate) fn put_sample(
        &mut self,
        lane: usize,
        (block, within): (usize, usize),
        [x, y]: [i32; 2],
        id: u32,
    ) {
        let [left, top] = block_corner(block);
        self.ids[lane] = id;
        self.x[lane] = left + LANE_X[within & (LANES - 1)] + x as f32 * STEP;
        self.y[lane] = top + LANE_Y[within & (LANES - 1)] + y as f32 * STEP;
    }

    /// One of the samples alone, in the first lane.
    pub(crate) fn only(&self, lane: usize) -> Self {
        let mut alone = Self::nothing(self.tile);
        alone.ids[0] = self.ids[lane];
        alone.x[0] = self.x[lane];
        alone.y[0] = self.y[lane];
        alone
    }

    /// The position of a lane's sample in the window, in pixels.
    pub(crate) fn position(&self, lane: usize) -> [f64; 2] {
        self.steps(lane).map(|steps| f64::from(steps) / f64::from(SUBPIXELS))
    }

    /// The position of a lane's sample, in steps of 1/256 pixel.
    pub(crate) fn steps(&self, lane: usize) -> [i32; 2] {
        let steps =
            |pixel: i32, inside: f32| pixel * SUBPIXELS + (inside * SUBPIXELS as f32) as i32;
        [steps(self.tile[0], self.x[lane]), steps(self.tile[1], self.y[lane])]
    }
}

/// Where the sample nearest the centre lies in its pixel, in pixels.
pub(crate) fn nearest_sample(samples: Samples) -> [f32; 2] {
    let nearest = usize::from(samples.nearest_first()[0]);
    samples.positions()[nearest].map(|steps| steps as f32 * STEP)
}

/// The first pixel of a block, within its tile.
#[inline(always)]
fn block_corner(block: usize) -> [f32; 2] {
    let block = block as i32;
    [(block % BLOCKS * BLOCK) as f32, (block / BLOCKS * BLOCK) as f32]
}
