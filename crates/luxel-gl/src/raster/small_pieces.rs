//! Triangles of corners that the depth test alone decides about: small ones wait, and are drawn sixteen at a time.
//!
//! Where nearer samples take the place of others, what a sample sees at last depends on the order only among equally near
//! ones, and the numbers of entries say which of these came first. So triangles may come in another order than that of
//! their calls, until something else is drawn.

use super::batch::Batch;
use super::piece_sink::Tests;
use super::pipeline::Pipeline;
use super::samples::offsets;
use super::tile_samples::TileSamples;
use crate::enums as gl;
use crate::plane::TILE_BLOCKS;
use luxel_math::{LANES, Simd};
use luxel_visibility::{
    CullFaces, SampleGrid, SmallSamples, SmallSink, StreamSink, Triangle, TriangleStream,
    WindowVertex,
};

/// Triangles that wait, all of one pipeline.
pub(super) struct SmallPieces<'a> {
    stream: TriangleStream<u32>,
    /// The batch that came last.
    batch: Option<&'a Batch>,
    /// What decides about its triangles, and about those that wait; `None` if none may wait.
    nearest: Option<Nearest<'a>>,
}

/// A depth test in which nearer samples take the place of others.
#[derive(Clone, Copy)]
struct Nearest<'a> {
    pipeline: &'a Pipeline,
    /// Whether greater depths are nearer.
    greater: bool,
    /// Whether of equal depths the first one stays.
    first_stays: bool,
    /// Whether colours are written, so that samples note what they see.
    sees: bool,
}

impl<'a> Nearest<'a> {
    /// The test of a batch's triangles, if it is one and nothing else decides in the tile.
    fn of(batch: &'a Batch, samples: &TileSamples<'_>) -> Option<Self> {
        let pipeline = &*batch.pipeline;
        let covers_all = pipeline.multisample.as_ref().is_none_or(|of| of.coverage.is_none());
        let (greater, first_stays) = match pipeline.depth? {
            (gl::LESS, true) => (false, true),
            (gl::LEQUAL, true) => (false, false),
            (gl::GREATER, true) => (true, true),
            (gl::GEQUAL, true) => (true, false),
            _ => return None,
        };
        let is_whole = samples.within(batch.polygon_region) == samples.all();
        let waits = is_whole && covers_all && batch.is_tested_by_depth_alone(true);
        let sees = pipeline.color_bits != 0;
        waits.then_some(Self { pipeline, greater, first_stays, sees })
    }

    /// Whether a depth takes the place of another: which entry it belongs to, and which the sample sees.
    #[inline(always)]
    fn wins(&self, [z, before]: [f32; 2], number: u32, seen: u32) -> bool {
        let nearer = if self.greater { z > before } else { z < before };
        // What was drawn before those that wait has a lower number, or none.
        nearer || z == before && (number < seen) == self.first_stays
    }
}

impl<'a> SmallPieces<'a> {
    pub(super) fn new() -> Self {
        Self { stream: TriangleStream::new(0), batch: None, nearest: None }
    }

    /// Whether a batch's triangles of corners may wait, if their depths aren't moved.
    #[inline(always)]
    pub(super) fn may_take<S: Simd>(
        &mut self,
        simd: S,
        batch: &'a Batch,
        samples: &mut TileSamples<'a>,
    ) -> bool {
        if !self.batch.is_some_and(|last| std::ptr::eq(last, batch)) {
            self.change_batch(simd, batch, samples);
        }
        self.nearest.is_some()
    }

    /// Goes on with another batch, after drawing what waits if that has another pipeline.
    #[inline(never)]
    fn change_batch<S: Simd>(&mut self, simd: S, batch: &'a Batch, samples: &mut TileSamples<'a>) {
        let nearest = Nearest::of(batch, samples);
        let pipeline = |of: &Nearest<'a>| std::ptr::from_ref(of.pipeline);
        if nearest.as_ref().map(pipeline) != self.nearest.as_ref().map(pipeline) {
            self.finish(simd, samples);
        }
        (self.batch, self.nearest) = (Some(batch), nearest);
    }

    /// Takes a triangle of the batch that came last.
    #[inline(always)]
    pub(super) fn push<S: Simd>(
        &mut self,
        simd: S,
        corners: [WindowVertex; 3],
        number: u32,
        samples: &mut TileSamples<'a>,
    ) {
        let Some(nearest) = self.nearest else { return };
        let sink = &mut NearestSink { nearest, samples };
        let grid = sink.grid();
        self.stream.push(simd, corners, number, grid, sink);
    }

    /// Draws all that wait.
    #[inline(always)]
    pub(super) fn finish<S: Simd>(&mut self, simd: S, samples: &mut TileSamples<'a>) {
        let Some(nearest) = self.nearest else { return };
        let sink = &mut NearestSink { nearest, samples };
        let grid = sink.grid();
        self.stream.finish(simd, grid, sink);
    }
}

/// Puts samples where they win.
struct NearestSink<'t, 'a> {
    nearest: Nearest<'a>,
    samples: &'t mut TileSamples<'a>,
}

impl NearestSink<'_, '_> {
    fn grid(&self) -> SampleGrid<'static> {
        let count = self.samples.seen.len();
        let offsets = offsets(self.nearest.pipeline.multisample.as_ref(), count);
        SampleGrid { region: self.samples.region, offsets }
    }
}

impl SmallSink<u32> for NearestSink<'_, '_> {
    #[inline(always)]
    fn put<S: Simd>(&mut self, samples: &SmallSamples<'_, S, u32>) {
        let Self { nearest, samples: TileSamples { planes, missing, seen, .. } } = self;
        let mut kept = *samples;
        kept.z = planes.depth_kind.moved(samples.z, 0.0);
        let places = kept.places();
        let depths = planes.depths(samples.z.simd, samples.sample, missing).as_flattened_mut();
        let seen = seen[samples.sample].as_flattened_mut();
        let mut rest = samples.covered;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize & (LANES - 1);
            rest &= rest - 1;
            let place = places.places[lane] as usize & (TILE_BLOCKS * LANES - 1);
            let (z, number) = (places.z[lane], samples.ids[lane]);
            if nearest.wins([z, depths[place]], number, seen[place]) {
                depths[place] = z;
                if nearest.sees {
                    seen[place] = number;
                }
            }
        }
    }
}

impl StreamSink<u32> for NearestSink<'_, '_> {
    #[inline(always)]
    fn large<S: Simd>(&mut self, simd: S, corners: [WindowVertex; 3], number: u32) {
        let Some(triangle) = Triangle::new(corners, CullFaces::None) else { return };
        let pipeline = self.nearest.pipeline;
        let limits = self.samples.all();
        let tests = Tests {
            pipeline,
            uses: pipeline.uses(),
            limits,
            plain: true,
            stipple: None,
            number,
            offset: 0.0,
            defers: false,
            samples: None,
        };
        self.samples.triangle(simd, &triangle, self.grid().offsets, tests);
    }
}
