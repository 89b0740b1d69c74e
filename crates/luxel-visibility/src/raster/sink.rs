//! A triangle through the pixels of a tile, whatever takes its samples.
//!
//! Which samples a triangle covers and how deep it lies there is settled here; a [`Sink`] decides what becomes of them.
//! It is known when compiling, so that the inner loop is one with it.

use super::block_rows::{self, BlockRows};
use super::setup::Triangle;
use crate::types::{BLOCK, Region};
use luxel_math::{SUBPIXELS, Simd, f32x16, mask32x16};

/// Up to so many pixels, testing one by one is faster than sixteen at a time.
const FEW_PIXELS: i32 = 4;

/// What takes the samples of a triangle in a tile. Mark all methods `#[inline(always)]`.
pub trait Sink {
    /// Before a few pixels, given by the first and the last ones of the window, come one by one.
    fn few(&mut self, pixels: [i32; 4]);

    /// The blocks of a row, a bit each, whose samples the sink takes. No sample's depth is above `high`; `many`: the
    /// triangle's box has many blocks.
    fn blocks<S: Simd>(
        &mut self,
        simd: S,
        row: i32,
        blocks: u32,
        high: f32x16<S>,
        many: bool,
    ) -> u32;

    /// Depths of the pixels of a block, by number within the tile; those that aren't covered mean nothing.
    fn block<S: Simd>(&mut self, simd: S, covered: mask32x16<S>, z: f32x16<S>, block: usize);

    /// One sample that is covered: column and row within the tile, its position in steps of 1/256 pixel, its depth.
    fn sample(&mut self, pixel: [i32; 2], position: [i32; 2], z: f32);
}

/// Covers the samples at `offset` of a tile's pixels.
///
/// Pixels of whole blocks about the triangle's box may be offered, also such as lie outside of `region`: the sink knows
/// its tile.
#[inline(always)]
pub fn cover<S: Simd>(
    simd: S,
    triangle: &Triangle,
    region: Region,
    offset: [i32; 2],
    sink: &mut impl Sink,
) {
    let Some(pixels) = triangle.pixels(region, offset) else { return };
    if pixels.width * pixels.height <= FEW_PIXELS {
        sink.few(pixels.sides());
        cover_few(triangle, pixels, region, offset, sink);
        return;
    }
    // Whole blocks of the tile.
    let first = [(pixels.x - region.x) / BLOCK, (pixels.y - region.y) / BLOCK];
    let right = (pixels.x + pixels.width - 1 - region.x) / BLOCK;
    let bottom = (pixels.y + pixels.height - 1 - region.y) / BLOCK;
    let blocks = Region {
        x: region.x + first[0] * BLOCK,
        y: region.y + first[1] * BLOCK,
        width: (right - first[0] + 1) * BLOCK,
        height: (bottom - first[1] + 1) * BLOCK,
    };
    let Some(edges) = triangle.edges(blocks, offset) else { return };
    let rows = BlockRows { region: blocks, first, edges, offset };
    block_rows::cover(simd, &rows, &triangle.depth, sink);
}

/// Covers a few pixels one by one: the same numbers as in blocks.
#[inline(always)]
fn cover_few(
    triangle: &Triangle,
    pixels: Region,
    region: Region,
    offset: [i32; 2],
    sink: &mut impl Sink,
) {
    let Some([e0, e1, e2]) = triangle.edges(pixels, offset) else { return };
    for y in 0..pixels.height {
        for x in 0..pixels.width {
            if (e0.at(x, y) | e1.at(x, y) | e2.at(x, y)) < 0 {
                continue;
            }
            let position =
                [(pixels.x + x) * SUBPIXELS + offset[0], (pixels.y + y) * SUBPIXELS + offset[1]];
            let z = triangle.depth.at(position);
            sink.sample([pixels.x + x - region.x, pixels.y + y - region.y], position, z);
        }
    }
}
