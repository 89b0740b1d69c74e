//! The log: what has been drawn and not yet been carried out, in the order of the calls.

use super::batch::Batch;
use super::draw::DeferredDraw;
use super::framebuffer::Framebuffer;
use super::pieces::Pieces;
use super::pipeline::Pipeline;
use super::shade::encode;
use super::spare::Spare;
use super::tile::{Entry, TileScratch, TileWorker};
use crate::limits::LOG_BYTES;
use luxel_math::{Level, dispatch_long, f32x16, prelude::*};
use luxel_visibility::TILE;
use std::sync::{Arc, Mutex, PoisonError};

/// One `glClear`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clear {
    /// Left, bottom, right and top, the last two beyond.
    pub(crate) region: [i32; 4],
    pub(crate) color: [f32; 4],
    /// The bits of a colour that are written.
    pub(crate) color_mask: u32,
    /// As the plane keeps it.
    pub(crate) depth: Option<f32>,
    pub(crate) stencil: Option<u8>,
    pub(crate) stencil_mask: u8,
}

/// A [`Clear`] as what it writes.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClearedTo {
    pub(super) region: [i32; 4],
    pub(super) color: u32,
    pub(super) color_mask: u32,
    pub(super) depth: Option<f32>,
    pub(super) stencil: u32,
    pub(super) stencil_mask: u32,
}

/// One item of the log.
#[derive(Debug)]
pub(super) enum Item {
    /// Some pieces of a batch.
    Batch(Arc<Batch>, Pieces),
    Clear(ClearedTo),
}

/// What has been drawn.
#[derive(Debug, Default)]
pub(crate) struct Log {
    items: Vec<Item>,
    /// Draws whose pieces aren't made, each with the number of items before it.
    deferred: Vec<(usize, Box<DeferredDraw>)>,
    bytes: usize,
    /// The pipeline of the last draw: the next one often has the same.
    last: Option<Arc<Pipeline>>,
    spare: Spare,
    /// What reached each tile the last time: empty lists.
    lists: Vec<Vec<Entry>>,
    /// What the workers of tiles need, one for each thread that was at work.
    scratch: Mutex<Vec<TileScratch>>,
}

impl Log {
    /// The one pipeline of that content.
    pub(crate) fn pipeline(&mut self, pipeline: Pipeline) -> Arc<Pipeline> {
        match &self.last {
            Some(last) if **last == pipeline => Arc::clone(last),
            _ => Arc::clone(self.last.insert(Arc::new(pipeline))),
        }
    }

    pub(crate) fn clear(&mut self, clear: Clear) {
        let level = Level::baseline();
        let color = dispatch_long!(level, simd => {
            encode(clear.color.map(|value| f32x16::splat(simd, value)))[0]
        });
        let has_stencil = clear.stencil.is_some();
        self.items.push(Item::Clear(ClearedTo {
            region: clear.region,
            color,
            color_mask: clear.color_mask,
            depth: clear.depth,
            stencil: u32::from(clear.stencil.unwrap_or(0)),
            stencil_mask: if has_stencil { u32::from(clear.stencil_mask) } else { 0 },
        }));
        self.bytes += size_of::<Item>();
    }

    /// Takes a batch, and all its pieces in runs.
    pub(crate) fn draw(&mut self, batch: Batch, runs: Vec<Pieces>) {
        let (bytes, before) = (batch.bytes(), self.items.len());
        put(batch, runs, &mut self.items, &mut self.spare);
        let items = &self.items[before..];
        if !items.is_empty() {
            self.bytes += bytes + items.iter().map(Item::bytes).sum::<usize>();
        }
    }

    /// Takes a draw whose pieces aren't made.
    pub(crate) fn defer(&mut self, draw: DeferredDraw) {
        self.bytes += draw.bytes();
        self.deferred.push((self.items.len(), Box::new(draw)));
    }

    /// Lists that batches have left.
    pub(crate) fn spare(&mut self) -> &mut Spare {
        &mut self.spare
    }

    /// Whether it holds so much that it is to be carried out.
    pub(crate) fn is_full(&self) -> bool {
        self.bytes > LOG_BYTES
    }

    /// Counts bytes that only draws in the log hold from now on.
    pub(crate) fn inherit(&mut self, bytes: usize) {
        self.bytes += bytes;
    }

    /// Whether there is nothing to be carried out.
    pub(crate) fn is_empty(&self) -> bool {
        self.items.is_empty() && self.deferred.is_empty()
    }

    /// Carries everything out, tile by tile, each in the order of the log.
    pub(crate) fn carry_out(&mut self, framebuffer: &mut Framebuffer, level: Level) {
        self.make_deferred(level);
        let mut items = std::mem::take(&mut self.items);
        self.bytes = 0;
        if !items.is_empty() && !framebuffer.size().contains(&0) {
            self.carry_out_items(&items, framebuffer, level);
        }
        for item in items.drain(..).rev() {
            if let Item::Batch(batch, pieces) = item {
                self.spare.put_pieces(pieces);
                if let Some(batch) = Arc::into_inner(batch) {
                    self.spare.put_vertices(batch.vertices);
                }
            }
        }
        self.items = items;
        // Textures of it may be changed: they are not held any longer.
        self.last = None;
    }

    /// Puts deferred draws in their places among the items. Each thread makes the pieces of some of them.
    fn make_deferred(&mut self, level: Level) {
        if self.deferred.is_empty() {
            return;
        }
        let (deferred, spare) = (std::mem::take(&mut self.deferred), &self.spare);
        let made = luxel_parallel::map(deferred.len(), 1, &|run| {
            Some(deferred[run.start].1.make(spare, level))
        });
        let mut items = Vec::with_capacity(self.items.len() + deferred.len());
        let mut others = self.items.drain(..);
        let mut given = 0;
        for ((before, _), (batch, runs)) in deferred.iter().zip(made.into_iter().flatten()) {
            items.extend(others.by_ref().take(before - given));
            given = *before;
            put(batch, runs, &mut items, &mut self.spare);
        }
        items.extend(others);
        self.items = items;
    }

    fn carry_out_items(&mut self, items: &[Item], framebuffer: &mut Framebuffer, level: Level) {
        framebuffer.changed = true;
        let [across, up] = framebuffer.tiles_across_and_up();
        let samples = framebuffer.samples();
        let is_exact = framebuffer.is_exact();
        sort(items, across, across * up, &mut self.lists);
        let size = framebuffer.size().map(|side| side as i32);
        let (lists, kept) = (&self.lists, &self.scratch);
        let lock = || kept.lock().unwrap_or_else(PoisonError::into_inner);
        let tiles = framebuffer.tiles_mut();
        luxel_parallel::each(tiles.into_iter().enumerate(), &|(number, planes)| {
            let list = &lists[number];
            if list.is_empty() {
                return;
            }
            let origin = [number % across, number / across].map(|at| at as i32 * TILE);
            let scratch = lock().pop().unwrap_or_default();
            let mut worker =
                TileWorker::new(items, list, origin, size, (planes, samples, is_exact), scratch);
            dispatch_long!(level, simd => worker.carry_out(simd));
            lock().push(worker.into_scratch());
        });
        self.lists.iter_mut().for_each(Vec::clear);
    }
}

impl Item {
    /// Bytes that it takes, without its batch.
    fn bytes(&self) -> usize {
        let pieces = match self {
            Self::Batch(_, pieces) => pieces.bytes(),
            Self::Clear(_) => 0,
        };
        size_of_val(self) + pieces
    }
}

/// Puts each run of a batch's pieces among the items. What has none goes to what is spare.
fn put(batch: Batch, runs: Vec<Pieces>, items: &mut Vec<Item>, spare: &mut Spare) {
    let batch = Arc::new(batch);
    for pieces in runs {
        if pieces.list().is_empty() {
            spare.put_pieces(pieces);
        } else {
            items.push(Item::Batch(Arc::clone(&batch), pieces));
        }
    }
    if let Some(unseen) = Arc::into_inner(batch) {
        spare.put_vertices(unseen.vertices);
    }
}

/// Puts what reaches each tile into its list, in order.
fn sort(items: &[Item], across: usize, tiles: usize, lists: &mut Vec<Vec<Entry>>) {
    lists.resize_with(tiles, Vec::new);
    let mut put = |[left, bottom, right, top]: [usize; 4], entry: Entry| {
        for row in bottom..=top {
            for column in left..=right {
                lists[row * across + column].push(entry);
            }
        }
    };
    for (number, item) in items.iter().enumerate() {
        let item_number = number as u32;
        match item {
            Item::Clear(ClearedTo { region: [left, bottom, right, top], .. }) => {
                if left < right && bottom < top {
                    let tiles = [*left, *bottom, right - 1, top - 1];
                    let tiles = tiles.map(|at| (at / TILE) as usize);
                    put(tiles, Entry { item: item_number, piece: 0 });
                }
            }
            Item::Batch(_, pieces) => {
                for (piece, of) in pieces.list().iter().enumerate() {
                    put(of.tiles(), Entry { item: item_number, piece: piece as u32 });
                }
            }
        }
    }
}
