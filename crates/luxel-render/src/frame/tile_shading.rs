//! What one thread does to a tile: it shades the blocks, and writes their pixels.

use super::finished_tile::FinishedTile;
use crate::context::ShadingContext;
use crate::interpolate::{SHARED, nearest_sample};
use crate::resolve::{
    DistinctTriangles, LaneCompaction, Layered, empty_block, even_block, even_blocks,
    single_triangle, uneven_block,
};
use crate::shade::ThreadCache;
use crate::shadow::BATCHES;
use luxel_math::{Simd, f32x16, prelude::*, u32x16};
use luxel_visibility::{BLOCKS, MAX_SAMPLES, Samples, Tile, TriangleId};

/// What one thread keeps from tile to tile.
pub(crate) struct Worker {
    /// Samples of a pixel.
    pub(crate) samples: usize,
    pub(crate) opaque: Tile,
    pub(crate) layers: [Tile; 2],
    pub(crate) layered: Layered,
    pub(crate) compaction: LaneCompaction,
    pub(crate) cache: ThreadCache,
}

impl Worker {
    pub(crate) fn new(samples: Samples) -> Self {
        let count = samples.count();
        Self {
            samples: count,
            opaque: Tile::new(count),
            layers: [Tile::new(count), Tile::new(count)],
            layered: Layered::new(count),
            compaction: LaneCompaction::new(),
            cache: ThreadCache::new(),
        }
    }
}

/// Blocks of a tile.
pub(crate) const ALL_BLOCKS: usize = (BLOCKS * BLOCKS) as usize;

/// Adds one transparent layer to all blocks of a tile; whether more can be seen through it.
#[inline(always)]
pub(crate) fn add_layer<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    layer: &Tile,
    opaque: &Tile,
    layered: &mut Layered,
    cache: &mut ThreadCache,
) -> bool {
    let mut deeper = false;
    for block in 0..ALL_BLOCKS {
        deeper |= layered.add_layer(simd, scene, layer, opaque, block, cache);
    }
    deeper
}

/// Blocks that are looked at together before they are lit: two rows.
pub(crate) const AHEAD: usize = 2 * BLOCKS as usize;

/// What is known of blocks before they are lit.
pub(crate) struct Ahead {
    /// Those in which nothing is seen, as bits.
    empty: u32,
    /// Those of which all samples see one triangle.
    single: u32,
    distinct: [DistinctTriangles; AHEAD],
}

impl Ahead {
    /// Whether nothing is seen in any of the blocks.
    #[inline(always)]
    pub(crate) fn are_empty(&self) -> bool {
        self.empty == u32::MAX
    }

    /// Whether all samples of one of the blocks see one triangle.
    #[inline(always)]
    pub(crate) fn is_single(&self, number: usize) -> bool {
        self.single >> number & 1 == 1
    }

    /// Whether nothing is seen in one of the blocks.
    #[inline(always)]
    pub(crate) fn is_empty(&self, number: usize) -> bool {
        self.empty >> number & 1 == 1
    }
}

/// Looks at the next blocks, and prepares the triangles that they see.
#[inline(always)]
pub(crate) fn look_ahead<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    tile: &Tile,
    first: usize,
    cache: &mut ThreadCache,
) -> Ahead {
    let setup = &mut cache.setup;
    setup.begin_tile(tile.origin());
    let vector = f32x16::splat(simd, 0.0);
    let mut ahead = Ahead { empty: 0, single: 0, distinct: [DistinctTriangles::EVEN; AHEAD] };
    if are_empty(simd, tile, first) {
        ahead.empty = u32::MAX;
        return ahead;
    }
    let prepares = !scene.needs_flat_light_alone;
    for number in 0..AHEAD {
        let block = first + number;
        if let Some(id) = single_triangle(simd, tile, block) {
            if id == TriangleId::NONE.0 {
                ahead.empty |= 1 << number;
            } else {
                ahead.single |= 1 << number;
                if prepares {
                    setup.look_ahead(vector, scene, &tile.planes()[0].ids[block], 1);
                }
            }
            continue;
        }
        let distinct = DistinctTriangles::of(simd, tile, block);
        ahead.distinct[number] = distinct;
        if !prepares {
            continue;
        }
        let mut begins = [0; MAX_SAMPLES];
        let (mut triangles, mut places) = (0, 0);
        for (sample, plane) in tile.planes().iter().enumerate() {
            let ids = &plane.ids[block];
            let seen = distinct.lanes(sample) & !vector.eq_mask(ids, TriangleId::NONE.0);
            begins[sample] = vector.run_starts(ids) & seen;
            triangles += begins[sample].count_ones();
            places += seen.count_ones();
        }
        if triangles <= places * SHARED / 16 {
            for (plane, begins) in tile.planes().iter().zip(begins) {
                setup.look_ahead(vector, scene, &plane.ids[block], begins);
            }
        }
    }
    setup.prepare(vector, scene);
    ahead
}

/// Whether nothing is seen in the blocks that are looked at together.
#[inline(always)]
fn are_empty<S: Simd>(simd: S, tile: &Tile, first: usize) -> bool {
    let mut all = u32x16::splat(simd, TriangleId::NONE.0);
    for plane in tile.planes() {
        for row in plane.ids[first..first + AHEAD].chunks_exact(BLOCKS as usize / 2) {
            for ids in row {
                all &= u32x16::simd_from(simd, *ids);
            }
            if !all.simd_eq(TriangleId::NONE.0).all_true() {
                return false;
            }
        }
    }
    true
}

/// Whether the first sample of each pixel of a block sees something.
#[inline(always)]
fn sees_all<S: Simd>(simd: S, tile: &Tile, block: usize) -> bool {
    f32x16::splat(simd, 0.0).eq_mask(&tile.planes()[0].ids[block], TriangleId::NONE.0) == 0
}

/// Lights all blocks of a tile, and finishes their pixels.
#[inline(always)]
pub(crate) fn tile_pixels<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    worker: &mut Worker,
    has_layers: bool,
    pixels: &mut FinishedTile<'_>,
) {
    let Worker { opaque, layered, compaction, cache, .. } = worker;
    let within = nearest_sample(scene.frame.samples());
    let is_flat = scene.backdrop.is_none();
    let has_pairs = scene.shadows.is_some() && !has_layers;
    for first in (0..ALL_BLOCKS).step_by(AHEAD) {
        let ahead = look_ahead(simd, scene, opaque, first, cache);
        if is_flat && !has_layers && ahead.are_empty() {
            pixels.fill_rows(first..first + AHEAD);
            continue;
        }
        let mut waiting = None;
        for number in 0..=AHEAD {
            let mut blocks = [(first + number, false); BATCHES];
            let (mut is_lit, mut count) = (true, 1);
            if number == AHEAD {
                // The last one that waited.
                let Some(of) = waiting.take() else { break };
                blocks[0] = of;
            } else {
                let block = first + number;
                let is_empty = is_flat && ahead.is_empty(number);
                if is_empty && !(has_layers && layered.is_touched(block)) {
                    pixels.put_background(block);
                    continue;
                }
                let distinct = &ahead.distinct[number];
                let is_even = distinct.are_even() && (is_flat || sees_all(simd, opaque, block));
                if !is_empty && !is_even {
                    compaction.add(simd, scene, opaque, block, distinct, cache);
                    continue;
                }
                is_lit = !is_empty;
                blocks[0].1 = ahead.is_single(number);
                if is_lit && has_pairs {
                    let Some(before) = waiting.take() else {
                        waiting = Some(blocks[0]);
                        continue;
                    };
                    (blocks, count) = ([before, blocks[0]], BATCHES);
                }
            }
            let mut colors = [empty_block(simd, scene); BATCHES];
            if count == BATCHES {
                colors = even_blocks(simd, scene, opaque, blocks, within, cache);
            } else if is_lit {
                colors[0] = even_block(simd, scene, opaque, blocks[0], within, cache);
            }
            for ((block, _), mut color) in blocks.into_iter().zip(colors).take(count) {
                if has_layers && layered.is_touched(block) {
                    color = layered.finish_block(simd, scene, opaque, block, cache, color);
                }
                pixels.put(simd, block, color);
            }
        }
        compaction.finish(
            simd,
            scene,
            cache,
            #[inline(always)]
            |block, lit, cache| {
                let mut color = uneven_block(simd, scene, lit);
                if has_layers && layered.is_touched(block) {
                    color = layered.finish_block(simd, scene, opaque, block, cache, color);
                }
                pixels.put(simd, block, color);
            },
        );
    }
}
