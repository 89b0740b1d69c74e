//! Triangles one by one into the samples of a tile.

use super::block_rows::{self, BlockRows};
use super::buffer::Tile;
use super::rules::{Rules, comes_first, put, wins};
use super::setup::Triangle;
use crate::types::{Asked, BLOCK, Region, TriangleId};
use luxel_math::{SUBPIXELS, Simd};

/// So many pixels are faster asked one by one than sixteen at a time.
const FEW_PIXELS: i32 = 4;

/// Draws one triangle into all samples of a tile.
///
/// A function of its own: all that calls it shares one copy for each SIMD level, which the compiler
/// needs to be done in reasonable time.
#[inline(always)]
pub(crate) fn draw_triangle<S: Simd>(
    simd: S,
    triangle: &Triangle,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    if rules.holes.is_none()
        && rules.behind.is_none()
        && tile.last_drawn.repeats(triangle, id, |first| comes_first(first, id, rules))
    {
        return;
    }
    simd.vectorize(
        #[inline(always)]
        || cover_samples(simd, triangle, id, rules, tile),
    );
}

#[inline(always)]
fn cover_samples<S: Simd>(
    simd: S,
    triangle: &Triangle,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    let tile_region = tile.region;
    for (sample, &offset) in rules.offsets.iter().enumerate() {
        let Some(pixels) = triangle.pixels(tile_region, offset) else { continue };
        if pixels.width * pixels.height <= FEW_PIXELS {
            tile.touch(pixels.sides());
            cover_few(triangle, pixels, id, rules, tile, sample);
            continue;
        }
        // Whole blocks of the tile.
        let first = [(pixels.x - tile_region.x) / BLOCK, (pixels.y - tile_region.y) / BLOCK];
        let right = (pixels.x + pixels.width - 1 - tile_region.x) / BLOCK;
        let bottom = (pixels.y + pixels.height - 1 - tile_region.y) / BLOCK;
        let region = Region {
            x: tile_region.x + first[0] * BLOCK,
            y: tile_region.y + first[1] * BLOCK,
            width: (right - first[0] + 1) * BLOCK,
            height: (bottom - first[1] + 1) * BLOCK,
        };
        let Some(edges) = triangle.edges(region, offset) else { continue };
        let blocks = BlockRows { region, first, edges, offset, sample };
        block_rows::cover(simd, &blocks, &triangle.depth, id, rules, tile);
    }
}

/// Draws one triangle into one sample of a few pixels: the same numbers as in blocks.
#[inline(always)]
fn cover_few(
    triangle: &Triangle,
    pixels: Region,
    id: TriangleId,
    rules: &Rules<'_>,
    tile: &mut Tile,
    sample: usize,
) {
    let offset = rules.offsets[sample];
    let Some([e0, e1, e2]) = triangle.edges(pixels, offset) else { return };
    for y in 0..pixels.height {
        for x in 0..pixels.width {
            if (e0.at(x, y) | e1.at(x, y) | e2.at(x, y)) < 0 {
                continue;
            }
            let position =
                [(pixels.x + x) * SUBPIXELS + offset[0], (pixels.y + y) * SUBPIXELS + offset[1]];
            let z = triangle.depth.at(position);
            let (column, row) = (pixels.x + x - tile.region.x, pixels.y + y - tile.region.y);
            let place = Tile::place(column, row);
            if !wins(id, z, place, rules, tile, sample) {
                continue;
            }
            if rules.holes.is_some_and(|holes| holes.holes(&Asked::one(id, position)) != 0) {
                continue;
            }
            put(id, z, place, tile, sample);
        }
    }
}
