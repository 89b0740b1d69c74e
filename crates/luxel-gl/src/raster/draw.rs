//! Draws: from primitives to a batch and its pieces.

use super::batch::Batch;
use super::build::{PIECES_RUN, PieceBuilder};
use super::draw_state::DrawState;
use super::pieces::{Piece, Pieces};
use super::pipeline::Pipeline;
use super::shape::Shape;
use super::spare::Spare;
use crate::limits::WAITING_VERTICES;
use crate::primitive::Primitives;
use crate::state::current::Current;
use crate::vertex::{Materials, Pass, VertexProcessor, VertexSource};
use luxel_math::Level;
use std::sync::Arc;
use std::sync::atomic::AtomicU64;

/// Draws of so many vertices are deferred, up to those that are worth two threads' while by themselves. Of draws of
/// quads with matrices between them, those of 32 vertices take 1.2x the time when they are deferred, those of 128 0.8x.
const LEAST_DEFERRED: usize = 65;

/// All state of a draw.
#[derive(Debug)]
pub(crate) struct DrawSetup {
    pub(crate) processor: VertexProcessor,
    pub(crate) state: DrawState,
    pub(crate) pipeline: Arc<Pipeline>,
    pub(crate) viewport: [i32; 4],
    /// Counts the samples that pass.
    pub(crate) samples: Option<Arc<AtomicU64>>,
}

impl DrawSetup {
    /// Whether primitives are better made with those of other draws, each draw by a thread.
    pub(crate) fn defers(primitives: &Primitives<'_>) -> bool {
        (LEAST_DEFERRED..=WAITING_VERTICES).contains(&primitives.vertices.len())
    }

    /// Processes the vertices of primitives, and makes pieces of these, in runs.
    pub(crate) fn make(
        &self,
        primitives: &Primitives<'_>,
        spare: &Spare,
        level: Level,
    ) -> (Batch, Vec<Pieces>) {
        let Self { processor, state, pipeline, viewport, samples } = self;
        let mut processed = spare.vertices(processor.lists());
        let used = primitives.notes_used(processor);
        processor.process(primitives.of(), Pass::first(used.as_ref()), level, &mut processed);
        let mut batch = Batch::new(Arc::clone(pipeline), *viewport, *state.scale(), processed);
        batch.samples.clone_from(samples);
        let runs = luxel_parallel::map(primitives.parts(), PIECES_RUN, &|run| {
            let mut builder = PieceBuilder::new(state, &batch, spare.pieces(), level);
            primitives.assemble_parts(run, &mut builder);
            let pieces = builder.finish();
            if let Some(used) = &used {
                pieces.note(used);
            }
            pieces
        });
        if let Some(used) = &used {
            processor.process(primitives.of(), Pass::Shades(used), level, &mut batch.vertices);
        }
        (batch, runs)
    }
}

/// A draw whose vertices are processed when the log is carried out.
#[derive(Debug)]
pub(crate) struct DeferredDraw {
    pub(crate) setup: DrawSetup,
    pub(crate) source: VertexSource<'static>,
    /// What was current at the draw.
    pub(crate) current: Current,
    pub(crate) materials: Materials,
}

impl DeferredDraw {
    fn primitives(&self) -> Primitives<'_> {
        Primitives::new(&self.source, &self.current, &self.materials)
    }

    /// Processes its vertices, and makes pieces of its primitives.
    pub(super) fn make(&self, spare: &Spare, level: Level) -> (Batch, Vec<Pieces>) {
        self.setup.make(&self.primitives(), spare, level)
    }

    /// Bytes of its vertices and of what will become of them, about.
    pub(super) fn bytes(&self) -> usize {
        let primitives = self.primitives();
        size_of_val(self)
            + self.source.bytes()
            + primitives.vertices.len() * self.setup.processor.lists().bytes_of_vertex()
            + primitives.parts() * (size_of::<Piece>() + size_of::<Shape>())
    }
}
