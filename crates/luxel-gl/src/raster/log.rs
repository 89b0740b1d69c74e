//! The log: what has been drawn and not yet been carried out, in the order of the calls.

use super::batch::Batch;
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
        let batch = Arc::new(batch);
        self.bytes += batch.bytes();
        for pieces in runs {
            if pieces.list().is_empty() {
                self.spare.put_pieces(pieces);
                continue;
            }
            self.bytes += size_of::<Item>() + pieces.bytes();
            let item = Item::Batch(Arc::clone(&batch), pieces);
            self.items.push(item);
        }
        if let Some(unseen) = Arc::into_inner(batch) {
            self.bytes = self.bytes.saturating_sub(unseen.bytes());
            self.spare.put_vertices(unseen.vertices);
        }
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
        self.items.is_empty()
    }

    /// Carries everything out, tile by tile, each in the order of the log.
    pub(crate) fn carry_out(&mut self, framebuffer: &mut Framebuffer, level: Level) {
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
