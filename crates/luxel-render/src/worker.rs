//! What one thread does to a tile: its blocks lit, and turned into the pixels that are kept.

use crate::firsts::Firsts;
use crate::packed::Packed;
use crate::resolve::{Layered, empty_block, empty_pixel, even_block, sees_one, uneven_block};
use crate::shade::{Kept, Scene16};
use crate::tiles::TilePixels;
use luxel_lighting::PictureEncoding;
use luxel_math::{LANES, Simd, f32x16, prelude::*, u32x16};
use luxel_visibility::{BLOCK, BLOCKS, MAX_SAMPLES, Samples, TILE, Tile, TriangleId};

/// What is kept of pixels: straight colour and alpha, finished.
pub(crate) trait Finish: Sync {
    /// What is kept of one.
    type Pixel: Copy + Default + Send + Sync;

    /// Of one pixel.
    fn pixel(&self, color: [f32; 4]) -> Self::Pixel;

    /// Of a block's pixels.
    fn block<S: Simd>(&self, simd: S, color: [f32x16<S>; 4]) -> [Self::Pixel; LANES];
}

/// Pixels as they are.
pub(crate) struct Linear;

impl Finish for Linear {
    type Pixel = [f32; 4];

    fn pixel(&self, color: [f32; 4]) -> [f32; 4] {
        color
    }

    #[inline(always)]
    fn block<S: Simd>(&self, _: S, color: [f32x16<S>; 4]) -> [[f32; 4]; LANES] {
        let mut channels = [[0.0; LANES]; 4];
        for (stored, lanes) in channels.iter_mut().zip(color) {
            lanes.store_slice(stored);
        }
        let [r, g, b, alpha] = channels;
        let mut pixels = [[0.0; 4]; LANES];
        for lane in 0..LANES {
            pixels[lane] = [r[lane], g[lane], b[lane], alpha[lane]];
        }
        pixels
    }
}

/// Bytes of red, green, blue and alpha. Alpha is never encoded.
pub(crate) struct Bytes(pub(crate) PictureEncoding);

impl Finish for Bytes {
    type Pixel = [u8; 4];

    fn pixel(&self, color: [f32; 4]) -> [u8; 4] {
        bytes_of(color, self.0)
    }

    #[inline(always)]
    fn block<S: Simd>(&self, simd: S, [r, g, b, alpha]: [f32x16<S>; 4]) -> [[u8; 4]; LANES] {
        let opaque = alpha.equal(alpha.one()).all();
        let alpha = if opaque {
            u32x16::splat(simd, 255)
        } else {
            PictureEncoding::None.bytes_of_lanes(alpha)
        };
        let Self(encoding) = self;
        let words = encoding.bytes_of_lanes(r)
            | encoding.bytes_of_lanes(g) << 8
            | encoding.bytes_of_lanes(b) << 16
            | alpha << 24;
        let mut stored = [0; LANES];
        words.store_slice(&mut stored);
        let mut pixels = [[0; 4]; LANES];
        for (pixel, word) in pixels.iter_mut().zip(stored) {
            *pixel = word.to_le_bytes();
        }
        pixels
    }
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
    pub(crate) packed: Packed,
    pub(crate) kept: Kept,
}

impl Worker {
    pub(crate) fn new(samples: Samples) -> Self {
        let count = samples.count();
        Self {
            opaque: Tile::new(count),
            layers: [Tile::new(count), Tile::new(count)],
            layered: Layered::new(count),
            packed: Packed::new(),
            kept: Kept::new(),
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

/// Blocks that are looked at together before they are lit: two rows.
const AHEAD: usize = 2 * BLOCKS as usize;

/// Triangles of a block are made ready where there are at most so many for sixteen places at which
/// they are lit.
const SHARED: u32 = 9;

/// What is known of blocks before they are lit.
struct Ahead {
    /// Those in which nothing is seen, as bits.
    empty: u32,
    firsts: [Firsts; AHEAD],
}

/// Looks at the next blocks, and makes triangles ready that they see.
#[inline(always)]
fn look_ahead<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    tile: &Tile,
    first: usize,
    kept: &mut Kept,
) -> Ahead {
    let Kept { ready, gathered, .. } = kept;
    let like = f32x16::splat(simd, 0.0);
    let mut ahead = Ahead { empty: 0, firsts: [Firsts::EVEN; AHEAD] };
    for number in 0..AHEAD {
        let block = first + number;
        if let Some(id) = sees_one(simd, tile, block) {
            if id == TriangleId::NONE.0 {
                ahead.empty |= 1 << number;
            } else if scene.is_plain {
                ready.look_ahead(like, scene, gathered, &tile.planes()[0].ids[block], 1);
            }
            continue;
        }
        let firsts = Firsts::of(simd, tile, block);
        if scene.is_plain {
            let mut begins = [0; MAX_SAMPLES];
            let (mut triangles, mut places) = (0, 0);
            for (sample, plane) in tile.planes().iter().enumerate() {
                let ids = &plane.ids[block];
                let seen = firsts.lanes(sample) & !like.lanes_equal(ids, TriangleId::NONE.0);
                begins[sample] = like.lanes_that_begin(ids) & seen;
                triangles += begins[sample].count_ones();
                places += seen.count_ones();
            }
            if triangles <= places * SHARED / 16 {
                for (plane, begins) in tile.planes().iter().zip(begins) {
                    ready.look_ahead(like, scene, gathered, &plane.ids[block], begins);
                }
            }
        }
        ahead.firsts[number] = firsts;
    }
    ready.make(like, scene, gathered);
    ahead
}

/// Lights all blocks of a tile, and finishes their pixels.
#[inline(always)]
pub(crate) fn tile_pixels<S: Simd, F: Finish>(
    simd: S,
    scene: &Scene16<'_>,
    worker: &mut Worker,
    has_layers: bool,
    finish: &F,
    pixels: &mut TilePixels<F::Pixel>,
) {
    let Worker { opaque, layered, packed, kept, .. } = worker;
    let background = [finish.pixel(empty_pixel(scene)); LANES];
    for first in (0..ALL_BLOCKS).step_by(AHEAD) {
        let Ahead { empty, firsts } = look_ahead(simd, scene, opaque, first, kept);
        for number in 0..AHEAD {
            let block = first + number;
            let is_layered = has_layers && layered.is_touched(block);
            let is_empty = empty >> number & 1 == 1;
            if is_empty && !is_layered {
                put_block(pixels, block, &background);
                continue;
            }
            let mut color = if is_empty {
                empty_block(simd, scene)
            } else {
                let firsts = &firsts[number];
                if !firsts.are_even() {
                    packed.add(simd, scene, opaque, block, firsts, kept);
                    continue;
                }
                even_block(simd, scene, opaque, block, kept)
            };
            if is_layered {
                color = layered.finish_block(simd, scene, opaque, block, kept, color);
            }
            put_block(pixels, block, &finish.block(simd, color));
        }
        packed.finish(
            simd,
            scene,
            kept,
            #[inline(always)]
            |block, lit, kept| {
                let mut color = uneven_block(simd, scene, lit);
                if has_layers && layered.is_touched(block) {
                    color = layered.finish_block(simd, scene, opaque, block, kept, color);
                }
                put_block(pixels, block, &finish.block(simd, color));
            },
        );
    }
}

/// Where a block's lane lies among the rows of its tile.
#[inline(always)]
pub(crate) fn place_in_tile(block: usize, lane: usize) -> usize {
    const SIDE: usize = BLOCK as usize;
    let (row, column) = (block / BLOCKS as usize, block % BLOCKS as usize);
    (row * SIDE + lane / SIDE) * TILE as usize + column * SIDE + lane % SIDE
}
