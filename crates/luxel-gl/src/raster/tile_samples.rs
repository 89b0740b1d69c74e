//! The samples of one tile, and what takes pieces into them.

use super::batch::Batch;
use super::framebuffer::{NoPlanes, TilePlanes};
use super::image::image;
use super::lighter::Lighter;
use super::pending::PendingFragments;
use super::piece_sink::{PieceSink, Tests};
use super::pieces::{Piece, Pieces};
use super::samples::{Multisample, offset};
use super::shaded::ShadedBlocks;
use super::shape::Shape;
use super::smooth::{Course, covered_by_outline, covered_in_part, sampled};
use super::strokes::{bitmap, line, point};
use super::tile::Seen;
use super::whole_tile::WholeTile;
use luxel_math::Simd;
use luxel_visibility::{Region, TILE, Triangle, cover};
use std::sync::Arc;

/// The samples of a tile.
pub(super) struct TileSamples<'a> {
    pub(super) planes: TilePlanes<'a>,
    pub(super) missing: NoPlanes,
    /// Of each sample.
    pub(super) seen: Vec<Seen>,
    pub(super) shaded: ShadedBlocks,
    pub(super) lighter: Lighter<'a>,
    /// Of each sample.
    pub(super) pending: Vec<PendingFragments>,
    /// A batch whose tests are those of the pending fragments.
    pub(super) pending_of: Option<&'a Batch>,
    /// The tile's first pixel in the window.
    pub(super) origin: [i32; 2],
    /// Its pixels that the window has.
    pub(super) region: Region,
}

impl<'a> TileSamples<'a> {
    /// All of its pixels that the window has: left, bottom, right and top.
    pub(super) fn all(&self) -> [i32; 4] {
        [0, 0, self.region.width, self.region.height]
    }

    /// A region of the window within the tile: left, bottom, right and top of its own pixels.
    pub(super) fn within(&self, [left, bottom, right, top]: [i32; 4]) -> [i32; 4] {
        let [x, y] = self.origin;
        [
            (left - x).max(0),
            (bottom - y).max(0),
            (right - x).min(self.region.width),
            (top - y).min(self.region.height),
        ]
    }

    /// Takes one sample's part of a piece.
    #[inline(always)]
    fn sink<'t, S: Simd>(
        &'t mut self,
        simd: S,
        tests: Tests<'t>,
        sample: usize,
    ) -> PieceSink<'t, 'a, S> {
        PieceSink {
            simd,
            sample,
            planes: self.planes.sample(simd, sample, &mut self.missing, tests.uses),
            seen: &mut self.seen[sample],
            lighter: &mut self.lighter,
            shaded: &mut self.shaded,
            pending: &mut self.pending,
            origin: self.origin,
            is_whole: tests.limits == [0, 0, TILE, TILE],
            tests,
            primary: None,
            coverage: None,
        }
    }

    /// Takes a triangle into the samples at those offsets.
    #[inline(always)]
    pub(super) fn triangle<S: Simd>(
        &mut self,
        simd: S,
        triangle: &Triangle,
        offsets: &[[i32; 2]],
        tests: Tests<'_>,
    ) {
        for (sample, &offset) in offsets.iter().enumerate() {
            self.triangle_at(simd, triangle, (sample, offset), tests);
        }
    }

    /// Takes a triangle into one sample of the pixels, which lies at `offset`.
    #[inline(always)]
    fn triangle_at<S: Simd>(
        &mut self,
        simd: S,
        triangle: &Triangle,
        (sample, offset): (usize, [i32; 2]),
        tests: Tests<'_>,
    ) {
        let region = self.region;
        if let Some(depths) = &mut self.planes.depth
            && let Some(&rule) = depths[sample].rule()
        {
            let mut whole = WholeTile {
                rule,
                depth: &mut depths[sample],
                depth_kind: self.planes.depth_kind,
                seen: &mut self.seen[sample],
                region,
                offset,
            };
            if whole.take(triangle, tests) {
                return;
            }
        }
        cover(simd, triangle, region, offset, &mut self.sink(simd, tests, sample));
    }

    /// Whether fragments of a batch's pieces may be deferred. Pending ones of another pipeline are carried out.
    #[inline(always)]
    fn may_defer<S: Simd>(&mut self, simd: S, batch: &'a Batch) -> bool {
        let may_defer = batch.may_defer();
        let pipeline = |of: &Batch| Arc::as_ptr(&of.pipeline);
        if !may_defer || self.pending_of.is_some_and(|of| pipeline(of) != pipeline(batch)) {
            self.carry_out_pending(simd);
        }
        if may_defer {
            self.pending_of = Some(batch);
        }
        may_defer
    }

    /// Carries out the pending fragments.
    #[inline(always)]
    pub(super) fn carry_out_pending<S: Simd>(&mut self, simd: S) {
        if let Some(batch) = self.pending_of.take() {
            self.carry_out_pending_of(simd, batch);
        }
    }

    #[inline(never)]
    fn carry_out_pending_of<S: Simd>(&mut self, simd: S, batch: &'a Batch) {
        let tests = Tests {
            pipeline: &batch.pipeline,
            uses: batch.uses(),
            limits: self.all(),
            plain: false,
            stipple: None,
            number: 0,
            offset: 0.0,
            defers: true,
            samples: None,
        };
        for sample in 0..self.seen.len() {
            self.sink(simd, tests, sample).carry_out_pending();
        }
    }

    /// Takes a piece.
    #[inline(always)]
    pub(super) fn piece<S: Simd>(
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
        let tests = Tests {
            pipeline,
            uses: batch.uses(),
            limits,
            plain: batch.is_tested_by_depth_alone(of_polygon),
            stipple: pipeline.polygon_stipple.as_ref().filter(|_| of_polygon),
            number,
            offset: piece.offset,
            defers: self.may_defer(simd, batch),
            samples: batch.samples.as_deref(),
        };
        let multisample = pipeline.multisample.as_ref();
        for sample in 0..self.seen.len() {
            if multisample.is_some_and(|of| !of.covers(sample)) {
                continue;
            }
            if let Some(triangle) = &triangle {
                let offset = offset(multisample, sample);
                self.triangle_at(simd, triangle, (sample, offset), tests);
                continue;
            }
            let mut sink = self.sink(simd, tests, sample);
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
