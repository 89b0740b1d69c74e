//! One tile's part of the log, in the order of the log.

use super::batch::Batch;
use super::framebuffer::{LANE_X, LANE_Y, NoPlanes, SamplePlanes, TilePlanes, block_origin};
use super::image::image;
use super::lighter::{Lighter, PreparedEntries, light_seen};
use super::log::{ClearedTo, Item};
use super::piece_sink::PieceSink;
use super::pieces::{Piece, Pieces};
use super::samples::{Multisample, offset};
use super::shaded::ShadedBlocks;
use super::shape::Shape;
use super::smooth::{Course, covered_by_outline, covered_in_part, sampled};
use super::strokes::{bitmap, line, point};
use crate::plane::TILE_BLOCKS;
use luxel_math::{LANES, Simd};
use luxel_visibility::{Region, TILE, cover};

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
    /// Of each sample.
    seen: Vec<Seen>,
    missing: NoPlanes,
    shaded: ShadedBlocks,
    prepared: PreparedEntries,
}

/// What carries out one tile's list.
pub(super) struct TileWorker<'a> {
    planes: TilePlanes<'a>,
    missing: NoPlanes,
    /// Of each sample.
    seen: Vec<Seen>,
    shaded: ShadedBlocks,
    lighter: Lighter<'a>,
    /// The tile's first pixel in the window.
    origin: [i32; 2],
    /// Its pixels that the window has.
    region: Region,
    /// Whether the planes end where the window does.
    is_exact: bool,
    /// Whether any piece has come since all that is seen was lit.
    has_pieces: bool,
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
        let TileScratch { mut seen, missing, mut shaded, prepared } = scratch;
        shaded.restart(samples);
        seen.resize(samples, [[0; LANES]; TILE_BLOCKS]);
        seen.as_flattened_mut().as_flattened_mut().fill(0);
        let lighter = Lighter::new(items, list, prepared);
        let has_pieces = false;
        Self { planes, missing, seen, shaded, lighter, origin, region, is_exact, has_pieces }
    }

    /// Its memory, for the next one.
    pub(super) fn into_scratch(self) -> TileScratch {
        let Self { seen, missing, shaded, lighter, .. } = self;
        TileScratch { seen, missing, shaded, prepared: lighter.prepared }
    }

    /// Carries the list out; then lights what is seen at last.
    #[inline(always)]
    pub(super) fn carry_out<S: Simd>(&mut self, simd: S) {
        let list = self.lighter.list();
        for (at, entry) in list.iter().enumerate() {
            match self.lighter.item(entry) {
                Item::Clear(clear) => {
                    if clear.color_mask != 0 && clear.color_mask != u32::MAX {
                        self.light(simd);
                    }
                    self.clear(clear);
                }
                Item::Batch(batch, pieces) => {
                    let piece = &pieces.list()[entry.piece as usize];
                    self.has_pieces = true;
                    self.piece(simd, batch, (pieces, piece), at as u32 + 1);
                }
            }
        }
        self.light(simd);
    }

    /// Lights what is seen. A pixel's samples that see the same are lit once, at its centre.
    fn light<S: Simd>(&mut self, simd: S) {
        if !std::mem::take(&mut self.has_pieces) {
            return;
        }
        let Some(colors) = &mut self.planes.color else { return };
        let Some((first, others)) = colors.split_first_mut() else { return };
        let Some((first_seen, others_seen)) = self.seen.split_first_mut() else { return };
        for block in 0..TILE_BLOCKS {
            let seen = first_seen[block];
            if sees_any(&seen) {
                let of_block = &mut first_seen[block];
                light_seen(simd, self.origin, block, of_block, &mut self.lighter, first);
            }
            for (color, of_sample) in others.iter_mut().zip(others_seen.iter_mut()) {
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
                    light_seen(simd, self.origin, block, of_block, &mut self.lighter, color);
                }
            }
        }
    }

    /// A region of the window within the tile: left, bottom, right and top of its own pixels.
    fn within(&self, [left, bottom, right, top]: [i32; 4]) -> [i32; 4] {
        let [x, y] = self.origin;
        [
            (left - x).max(0),
            (bottom - y).max(0),
            (right - x).min(self.region.width),
            (top - y).min(self.region.height),
        ]
    }

    fn clear(&mut self, clear: &ClearedTo) {
        let part = self.within(clear.region);
        // What lies beyond the window may be an image's that is larger.
        let whole = part == [0, 0, TILE, TILE]
            || self.is_exact && part == [0, 0, self.region.width, self.region.height];
        let hides = std::mem::take(&mut self.has_pieces);
        self.has_pieces = hides && !(whole && clear.color_mask == u32::MAX);
        for (sample, seen) in self.seen.iter_mut().enumerate() {
            let planes = &mut self.planes.sample(sample, &mut self.missing);
            if whole && matches!(clear.color_mask, 0 | u32::MAX) {
                clear_all(planes, hides.then_some(seen), clear);
            } else {
                clear_part(planes, seen, clear, part);
            }
        }
    }

    #[inline(always)]
    fn piece<S: Simd>(
        &mut self,
        simd: S,
        batch: &'a Batch,
        (pieces, piece): (&Pieces, &Piece),
        number: u32,
    ) {
        let pipeline = &*batch.pipeline;
        let shape = pieces.shape(piece);
        let triangle = match shape {
            None => piece.triangle(batch),
            Some(Shape::Triangle(triangle)) => Some(*triangle),
            _ => None,
        };
        let of_polygon = triangle.is_some() || matches!(shape, Some(Shape::Smooth { .. }));
        let limits = if of_polygon { batch.polygon_region } else { pipeline.region };
        let limits = self.within(limits);
        let plain = pipeline.stencil.is_none()
            && batch.samples.is_none()
            && !pipeline.is_mixing()
            && (pipeline.polygon_stipple.is_none() || !of_polygon);
        let multisample = pipeline.multisample.as_ref();
        for sample in 0..self.seen.len() {
            if multisample.is_some_and(|of| !of.covers(sample)) {
                continue;
            }
            let mut sink = PieceSink {
                simd,
                sample,
                planes: self.planes.sample(sample, &mut self.missing),
                seen: &mut self.seen[sample],
                lighter: &mut self.lighter,
                shaded: &mut self.shaded,
                pipeline,
                origin: self.origin,
                limits,
                is_whole: limits == [0, 0, TILE, TILE],
                plain,
                stipple: pipeline.polygon_stipple.as_ref().filter(|_| of_polygon),
                number,
                offset: piece.offset,
                primary: None,
                coverage: None,
                samples: batch.samples.as_deref(),
            };
            if let Some(triangle) = &triangle {
                cover(simd, triangle, self.region, offset(multisample, sample), &mut sink);
                continue;
            }
            let Some(shape) = shape else { return };
            match *shape {
                Shape::Triangle(_) => {}
                Shape::Line { line: ref of, width, counter } => {
                    line(&mut sink, of, width, counter);
                }
                Shape::Band { line: ref of, counter, .. } => {
                    let stipple = counter.zip(pipeline.line_stipple);
                    let course = Course { depths: of.depths, stipple };
                    partly(&mut sink, shape, course, multisample, sample);
                }
                Shape::Disc { depth, .. } => {
                    let course = Course { depths: [depth; 2], stipple: None };
                    partly(&mut sink, shape, course, multisample, sample);
                }
                Shape::Smooth { outline, triangle, ref depth } => {
                    let outline = (pieces.outline(outline), triangle as usize);
                    covered_by_outline(&mut sink, outline, depth);
                }
                Shape::Bitmap { corner, depth } => {
                    if let Some(of) = &batch.bitmap {
                        bitmap(&mut sink, of, corner, depth);
                    }
                }
                Shape::Image { depth } => {
                    if let Some(of) = &batch.image {
                        image(&mut sink, of, depth);
                    }
                }
                Shape::Point { corner, side, depth, .. } => point(&mut sink, corner, side, depth),
            }
        }
    }
}

/// The fragments of a figure that may end within pixels: by samples where there are several, else by the parts that are
/// covered.
#[inline(always)]
fn partly<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    shape: &Shape,
    course: Course,
    multisample: Option<&Multisample>,
    sample: usize,
) {
    let Some(figure) = shape.figure() else { return };
    if multisample.is_some() {
        sampled(sink, &figure, course, offset(multisample, sample));
    } else {
        covered_in_part(sink, &figure, course);
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
fn sees_any(seen: &[u32; LANES]) -> bool {
    seen.iter().fold(0, |any, entry| any | entry) != 0
}

/// Clears whole planes; what lies beyond the window doesn't matter.
fn clear_all(planes: &mut SamplePlanes<'_>, seen: Option<&mut Seen>, clear: &ClearedTo) {
    if clear.color_mask != 0 {
        if let Some(seen) = seen {
            seen.as_flattened_mut().fill(0);
        }
        planes.color.as_flattened_mut().fill(clear.color);
    }
    if let Some(depth) = clear.depth {
        planes.depth.as_flattened_mut().fill(depth);
    }
    if clear.stencil_mask != 0 {
        for stencil in planes.stencil.as_flattened_mut() {
            *stencil = *stencil & !clear.stencil_mask | clear.stencil & clear.stencil_mask;
        }
    }
}
