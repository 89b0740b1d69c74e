//! The planes of a framebuffer, in tiles of 64x64 pixels and blocks of 4x4.
//!
//! Row 0 is the bottom one.

use luxel_math::LANES;
use luxel_visibility::{BLOCK, BLOCKS, TILE, Tile};

/// Blocks of a tile.
pub(crate) const TILE_BLOCKS: usize = (BLOCKS * BLOCKS) as usize;
const _: () = assert!(BLOCK * BLOCK == LANES as i32, "a block is one vector");
/// The largest depth, 1: there are 24 bits.
pub(crate) const LARGEST_DEPTH: f32 = 16_777_215.0;

/// Columns and rows of a block's lanes.
pub(super) const LANE_X: [i32; LANES] = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3];
pub(super) const LANE_Y: [i32; LANES] = [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3];

/// The first pixel of a block within its tile.
pub(super) fn block_origin(block: usize) -> [i32; 2] {
    let block = block as i32;
    [block % BLOCKS * BLOCK, block / BLOCKS * BLOCK]
}

/// The planes of one tile, block by block.
#[derive(Clone, Debug)]
pub(crate) struct TilePlanes {
    /// Red in the lowest byte, alpha in the highest.
    pub(crate) color: [[u32; LANES]; TILE_BLOCKS],
    /// Window depth times 2^24 - 1, whole numbers.
    pub(crate) depth: [[f32; LANES]; TILE_BLOCKS],
    pub(crate) stencil: [[u32; LANES]; TILE_BLOCKS],
}

impl TilePlanes {
    /// Black, as far away as possible.
    fn new() -> Box<Self> {
        Box::new(Self {
            color: [[0; LANES]; TILE_BLOCKS],
            depth: [[LARGEST_DEPTH; LANES]; TILE_BLOCKS],
            stencil: [[0; LANES]; TILE_BLOCKS],
        })
    }
}

/// A framebuffer with one sample a pixel, or with several.
#[derive(Clone, Debug)]
pub(crate) struct Framebuffer {
    width: u32,
    height: u32,
    samples: usize,
    /// Those of a tile's samples one after the other.
    pub(super) tiles: Vec<Box<TilePlanes>>,
}

impl Framebuffer {
    pub(crate) fn new(width: u32, height: u32, samples: usize) -> Self {
        let [across, up] = [width, height].map(|side| side.div_ceil(TILE as u32) as usize);
        let tiles = (0..across * up * samples).map(|_| TilePlanes::new()).collect();
        Self { width, height, samples, tiles }
    }

    /// Width and height.
    pub(crate) fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Samples of a pixel.
    pub(crate) fn samples(&self) -> usize {
        self.samples
    }

    /// Tiles side by side.
    pub(crate) fn across(&self) -> usize {
        self.width.div_ceil(TILE as u32) as usize
    }

    /// The tile of a pixel, or of a sample of it, with block and lane in it.
    fn place(&self, [x, y]: [u32; 2], sample: usize) -> (usize, usize, usize) {
        let side = TILE as u32;
        let tile = (y / side) as usize * self.across() + (x / side) as usize;
        let (block, lane) = Tile::place((x % side) as i32, (y % side) as i32);
        (tile * self.samples + sample, block, lane)
    }

    pub(crate) fn set_color(&mut self, at: [u32; 2], sample: usize, color: [u8; 4]) {
        let (tile, block, lane) = self.place(at, sample);
        self.tiles[tile].color[block][lane] = u32::from_le_bytes(color);
    }

    pub(crate) fn set_depth(&mut self, at: [u32; 2], sample: usize, depth: u32) {
        let (tile, block, lane) = self.place(at, sample);
        self.tiles[tile].depth[block][lane] = depth as f32;
    }

    pub(crate) fn set_stencil(&mut self, at: [u32; 2], sample: usize, value: u8) {
        let (tile, block, lane) = self.place(at, sample);
        self.tiles[tile].stencil[block][lane] = u32::from(value);
    }

    /// Red, green, blue and alpha of a pixel's first sample.
    pub(crate) fn color(&self, at: [u32; 2]) -> [u8; 4] {
        self.sample_color(at, 0)
    }

    pub(crate) fn sample_color(&self, at: [u32; 2], sample: usize) -> [u8; 4] {
        let (tile, block, lane) = self.place(at, sample);
        self.tiles[tile].color[block][lane].to_le_bytes()
    }

    /// The mean of a pixel's samples.
    pub(crate) fn resolved(&self, at: [u32; 2]) -> [u8; 4] {
        if self.samples == 1 {
            return self.color(at);
        }
        let count = self.samples as u32;
        let mut sums = [0; 4];
        for sample in 0..self.samples {
            for (sum, byte) in sums.iter_mut().zip(self.sample_color(at, sample)) {
                *sum += u32::from(byte);
            }
        }
        sums.map(|sum| ((2 * sum + count) / (2 * count)) as u8)
    }

    /// The colours of a row as words, red in the lowest byte.
    pub(crate) fn color_row(&self, y: u32, row: &mut [u32]) {
        let block_row = (y % TILE as u32 / BLOCK as u32 * BLOCKS as u32) as usize;
        let lane = (y % BLOCK as u32 * BLOCK as u32) as usize;
        let first = (y / TILE as u32) as usize * self.across() * self.samples;
        let tiles = self.tiles[first..].iter().step_by(self.samples);
        for (tile, pixels) in tiles.zip(row.chunks_mut(TILE as usize)) {
            let blocks = &tile.color[block_row..block_row + BLOCKS as usize];
            for (block, pixels) in blocks.iter().zip(pixels.chunks_mut(BLOCK as usize)) {
                pixels.copy_from_slice(&block[lane..lane + pixels.len()]);
            }
        }
    }

    /// A pixel's depth, of 24 bits, at its first sample.
    pub(crate) fn depth(&self, at: [u32; 2]) -> u32 {
        self.sample_depth(at, 0)
    }

    pub(crate) fn sample_depth(&self, at: [u32; 2], sample: usize) -> u32 {
        let (tile, block, lane) = self.place(at, sample);
        self.tiles[tile].depth[block][lane] as u32
    }

    /// A pixel's depth from 0 to 1.
    pub(crate) fn unit_depth(&self, at: [u32; 2]) -> f32 {
        (f64::from(self.depth(at)) / f64::from(LARGEST_DEPTH)) as f32
    }

    /// A pixel's stencil value at its first sample.
    pub(crate) fn stencil(&self, at: [u32; 2]) -> u8 {
        self.sample_stencil(at, 0)
    }

    pub(crate) fn sample_stencil(&self, at: [u32; 2], sample: usize) -> u8 {
        let (tile, block, lane) = self.place(at, sample);
        self.tiles[tile].stencil[block][lane] as u8
    }
}
