//! One tile's part of the log, in the order of the log.

use super::framebuffer::{NoPlanes, SamplePlanes, TilePlanes, Uses};
use super::lighter::{Lighter, PreparedEntries, light_seen};
use super::log::{ClearedTo, Item};
use super::pending::PendingFragments;
use super::shaded::ShadedBlocks;
use super::small_pieces::SmallPieces;
use super::tile_samples::TileSamples;
use crate::depth::DepthRule;
use crate::plane::{LANE_X, LANE_Y, TILE_BLOCKS, block_origin};
use luxel_math::{LANES, Simd};
use luxel_visibility::{Region, TILE};

/// A piece of a batch, or a clear.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    pub(super) item: u32,
    pub(super) piece: u32,
}

/// Of each pixel the entry that it sees and that hasn't been lit, from 1 on; 0 for none.
pub(super) type Seen = [[u32; LANES]; TILE_BLOCKS];

/// Memory that workers of tiles take over from one another.
#[derive(Debug, Default)]
pub(super) struct TileScratch {
    /// Of each sample: they see nothing.
    seen: Vec<Seen>,
    missing: NoPlanes,
    shaded: ShadedBlocks,
    prepared: PreparedEntries,
    /// Of each sample: none.
    pending: Vec<PendingFragments>,
}

/// What carries out one tile's list.
pub(super) struct TileWorker<'a> {
    samples: TileSamples<'a>,
    /// Triangles that wait.
    small: SmallPieces<'a>,
    /// Whether the planes end where the window does.
    is_exact: bool,
    /// Whether samples may see pieces that haven't been lit.
    sees: bool,
}

impl<'a> TileWorker<'a> {
    pub(super) fn new(
        items: &'a [Item],
        list: &'a [Entry],
        origin: [i32; 2],
        [width, height]: [i32; 2],
        (planes, samples, is_exact): (TilePlanes<'a>, usize, bool),
        scratch: TileScratch,
    ) -> Self {
        let region = Region {
            x: origin[0],
            y: origin[1],
            width: TILE.min(width - origin[0]),
            height: TILE.min(height - origin[1]),
        };
        let TileScratch { mut seen, missing, mut shaded, prepared, mut pending } = scratch;
        shaded.restart(samples);
        seen.resize(samples, [[0; LANES]; TILE_BLOCKS]);
        pending.resize_with(samples, PendingFragments::default);
        let lighter = Lighter::new(items, list, prepared);
        let pending_of = None;
        let samples = TileSamples {
            planes,
            missing,
            seen,
            shaded,
            lighter,
            pending,
            pending_of,
            origin,
            region,
        };
        Self { samples, small: SmallPieces::new(), is_exact, sees: false }
    }

    /// Its memory, for the next one.
    pub(super) fn into_scratch(self) -> TileScratch {
        let TileSamples { seen, missing, shaded, lighter, pending, .. } = self.samples;
        TileScratch { seen, missing, shaded, prepared: lighter.prepared, pending }
    }

    /// Carries the list out; then lights what is seen at last.
    #[inline(always)]
    pub(super) fn carry_out<S: Simd>(&mut self, simd: S) {
        let list = self.samples.lighter.list();
        for (at, entry) in list.iter().enumerate() {
            match self.samples.lighter.item(entry) {
                Item::Clear(clear) => {
                    self.finish(simd);
                    if clear.color_mask != 0 && clear.color_mask != u32::MAX {
                        self.light(simd);
                    }
                    self.clear(simd, clear);
                }
                Item::Batch(batch, pieces) => {
                    let piece = &pieces.list()[entry.piece as usize];
                    let number = at as u32 + 1;
                    self.sees |= batch.pipeline.color_bits != 0;
                    let may_wait = piece.is_of_corners() && piece.offset == 0.0;
                    if may_wait && self.small.may_take(simd, batch, &mut self.samples) {
                        self.samples.carry_out_pending(simd);
                        let corners = piece.corners(batch);
                        self.small.push(simd, corners, number, &mut self.samples);
                    } else {
                        self.small.finish(simd, &mut self.samples);
                        self.samples.piece(simd, batch, (pieces, piece), number);
                    }
                }
            }
        }
        self.finish(simd);
        self.light(simd);
    }

    /// Draws what is pending: small triangles, or fragments that mix with what is there.
    #[inline(always)]
    fn finish<S: Simd>(&mut self, simd: S) {
        self.small.finish(simd, &mut self.samples);
        self.samples.carry_out_pending(simd);
    }

    /// Lights what is seen. A pixel's samples that see the same are lit once, at its centre.
    fn light<S: Simd>(&mut self, simd: S) {
        if !std::mem::take(&mut self.sees) {
            return;
        }
        let TileSamples { planes, seen, lighter, origin, .. } = &mut self.samples;
        let colors = planes.color.as_mut().and_then(|colors| colors.split_first_mut());
        let (Some((first, others)), Some((first_seen, others_seen))) =
            (colors, seen.split_first_mut())
        else {
            seen.as_flattened_mut().as_flattened_mut().fill(0);
            return;
        };
        let first = first.blocks_mut(simd);
        for block in 0..TILE_BLOCKS {
            let seen = first_seen[block];
            if sees_any(&seen) {
                let of_block = &mut first_seen[block];
                light_seen(simd, *origin, block, of_block, lighter, first);
            }
            for (color, of_sample) in others.iter_mut().zip(others_seen.iter_mut()) {
                let color = color.blocks_mut(simd);
                let of_block = &mut of_sample[block];
                if !sees_any(of_block) {
                    continue;
                }
                for lane in 0..LANES {
                    if of_block[lane] == seen[lane] && seen[lane] != 0 {
                        color[block][lane] = first[block][lane];
                        of_block[lane] = 0;
                    }
                }
                if sees_any(of_block) {
                    light_seen(simd, *origin, block, of_block, lighter, color);
                }
            }
        }
    }

    #[inline(always)]
    fn clear<S: Simd>(&mut self, simd: S, clear: &ClearedTo) {
        let part = self.samples.within(clear.region);
        // What lies beyond the window may be an image's that is larger.
        let whole = part == [0, 0, TILE, TILE] || self.is_exact && part == self.samples.all();
        let hides = std::mem::take(&mut self.sees);
        self.sees = hides && !(whole && clear.color_mask == u32::MAX);
        let TileSamples { planes, missing, seen, .. } = &mut self.samples;
        if whole && matches!(clear.color_mask, 0 | u32::MAX) {
            clear_all(planes, hides.then_some(seen), clear);
            return;
        }
        let uses = Uses {
            color: clear.color_mask != 0,
            depth: clear.depth.is_some(),
            stencil: clear.stencil_mask != 0,
        };
        for (sample, seen) in seen.iter_mut().enumerate() {
            clear_part(&mut planes.sample(simd, sample, missing, uses), seen, clear, part);
        }
    }
}

/// Clears the pixels of a part: left, bottom, right, top of the tile's own.
fn clear_part(
    planes: &mut SamplePlanes<'_>,
    seen: &mut Seen,
    clear: &ClearedTo,
    [left, bottom, right, top]: [i32; 4],
) {
    for block in 0..TILE_BLOCKS {
        let first = block_origin(block);
        for lane in 0..LANES {
            let (x, y) = (first[0] + LANE_X[lane], first[1] + LANE_Y[lane]);
            if x < left || x >= right || y < bottom || y >= top {
                continue;
            }
            if clear.color_mask == u32::MAX {
                seen[block][lane] = 0;
            }
            let color = &mut planes.color[block][lane];
            *color = *color & !clear.color_mask | clear.color & clear.color_mask;
            if let Some(depth) = clear.depth {
                planes.depth[block][lane] = depth;
            }
            let stencil = &mut planes.stencil[block][lane];
            *stencil = *stencil & !clear.stencil_mask | clear.stencil & clear.stencil_mask;
        }
    }
}

/// Whether any pixel of a block sees an entry.
#[inline(always)]
pub(super) fn sees_any(seen: &[u32; LANES]) -> bool {
    seen.iter().fold(0, |any, entry| any | entry) != 0
}

/// Clears whole planes of all samples; what lies beyond the window doesn't matter.
fn clear_all(planes: &mut TilePlanes<'_>, seen: Option<&mut Vec<Seen>>, clear: &ClearedTo) {
    if clear.color_mask != 0 {
        if let Some(seen) = seen {
            seen.as_flattened_mut().as_flattened_mut().fill(0);
        }
        for tile in planes.color.as_deref_mut().into_iter().flatten() {
            tile.follow(clear.color);
        }
    }
    if let Some(depth) = clear.depth {
        for tile in planes.depth.as_deref_mut().into_iter().flatten() {
            tile.follow(DepthRule::even(planes.depth_kind, depth));
        }
    }
    if clear.stencil_mask != 0 {
        let cleared =
            |stencil: u32| stencil & !clear.stencil_mask | clear.stencil & clear.stencil_mask;
        for tile in planes.stencil.as_deref_mut().into_iter().flatten() {
            tile.change(cleared);
        }
    }
}
