//! What one thread does to a tile: its blocks lit, and turned into the pixels that are kept.

use crate::resolve::{BlockPixels, Layered, is_empty, resolve_block};
use crate::shade::{Kept, Scene16};
use crate::tiles::TilePixels;
use luxel_lighting::PictureEncoding;
use luxel_math::{LANES, Simd};
use luxel_visibility::{BLOCK, BLOCKS, Samples, TILE, Tile};

/// A block's pixels as they are.
pub(crate) fn linear_pixels([r, g, b, alpha]: &BlockPixels) -> [[f32; 4]; LANES] {
    std::array::from_fn(|lane| [r[lane], g[lane], b[lane], alpha[lane]])
}

/// The bytes of a block's pixels.
pub(crate) fn bytes_of_block(
    [r, g, b, alpha]: &BlockPixels,
    encoding: PictureEncoding,
) -> [[u8; 4]; LANES] {
    let mut bytes = [[0; LANES]; 4];
    let [red, green, blue, opacity] = &mut bytes;
    encoding.bytes(r, red);
    encoding.bytes(g, green);
    encoding.bytes(b, blue);
    if *alpha == [1.0; LANES] {
        *opacity = [u8::MAX; LANES];
    } else {
        PictureEncoding::None.bytes(alpha, opacity);
    }
    std::array::from_fn(|lane| [red[lane], green[lane], blue[lane], opacity[lane]])
}

/// Writes a block's pixels among the rows of its tile.
#[inline(always)]
fn put_block<T: Copy>(pixels: &mut TilePixels<T>, block: usize, values: &[T; LANES]) {
    const WIDTH: usize = BLOCK as usize;
    let first = place_in_tile(block, 0);
    for (row, values) in values.as_chunks::<WIDTH>().0.iter().enumerate() {
        let start = first + row * TILE as usize;
        pixels[start..start + WIDTH].copy_from_slice(values);
    }
}

/// A pixel's bytes. Alpha is never encoded.
pub(crate) fn bytes_of([r, g, b, alpha]: [f32; 4], encoding: PictureEncoding) -> [u8; 4] {
    let byte = |value| encoding.byte(value);
    [byte(r), byte(g), byte(b), PictureEncoding::None.byte(alpha)]
}

/// What one thread keeps from tile to tile.
pub(crate) struct Worker {
    pub(crate) opaque: Tile,
    pub(crate) layers: [Tile; 2],
    pub(crate) layered: Layered,
    pub(crate) kept: Kept,
    /// The light of each block; `None` where nothing is seen.
    pub(crate) blocks: Vec<Option<BlockPixels>>,
}

impl Worker {
    pub(crate) fn new(samples: Samples) -> Self {
        let count = samples.count();
        Self {
            opaque: Tile::new(count),
            layers: [Tile::new(count), Tile::new(count)],
            layered: Layered::new(count),
            kept: Kept::new(),
            blocks: vec![None; ALL_BLOCKS],
        }
    }

    /// What is kept of the pixels of the tile drawn last.
    pub(crate) fn finish<T: Copy>(
        &self,
        finish: impl Fn(&BlockPixels) -> [T; LANES],
        background: T,
        pixels: &mut TilePixels<T>,
    ) {
        for (block, colors) in self.blocks.iter().enumerate() {
            let finished = match colors {
                Some(colors) => finish(colors),
                None => [background; LANES],
            };
            put_block(pixels, block, &finished);
        }
    }
}

/// Blocks of a tile.
pub(crate) const ALL_BLOCKS: usize = (BLOCKS * BLOCKS) as usize;

/// Adds one transparent layer to all blocks of a tile; whether more can be seen through it.
#[inline(always)]
pub(crate) fn add_layer<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    layer: &Tile,
    opaque: &Tile,
    layered: &mut Layered,
    kept: &mut Kept,
) -> bool {
    let mut deeper = false;
    for block in 0..ALL_BLOCKS {
        deeper |= layered.add_layer(simd, scene, layer, opaque, block, kept);
    }
    deeper
}

/// Lights all blocks of a tile, into `worker.blocks`.
#[inline(always)]
pub(crate) fn tile_pixels<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    worker: &mut Worker,
    has_layers: bool,
) {
    let Worker { opaque, layered, kept, blocks, .. } = worker;
    for (block, pixels) in blocks.iter_mut().enumerate() {
        let is_layered = has_layers && layered.is_touched(block);
        if is_empty(opaque, block) && !is_layered {
            *pixels = None;
            continue;
        }
        let mut colors = resolve_block(simd, scene, opaque, block, kept);
        if is_layered {
            layered.finish_block(simd, scene, opaque, block, kept, &mut colors);
        }
        *pixels = Some(colors);
    }
}

/// Where a block's lane lies among the rows of its tile.
#[inline(always)]
pub(crate) fn place_in_tile(block: usize, lane: usize) -> usize {
    const SIDE: usize = BLOCK as usize;
    let (row, column) = (block / BLOCKS as usize, block % BLOCKS as usize);
    (row * SIDE + lane / SIDE) * TILE as usize + column * SIDE + lane % SIDE
}
