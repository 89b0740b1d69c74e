//! The log: what has been drawn and not yet been carried out, in the order of the calls.

use super::batch::{Batch, Shape};
use super::framebuffer::{Framebuffer, LARGEST_DEPTH};
use super::pipeline::Pipeline;
use super::shade::encode;
use super::tile::{Entry, TileWorker};
use crate::limits::LOG_BYTES;
use luxel_math::{Level, dispatch_long, f32x16, prelude::*};
use luxel_visibility::TILE;
use std::sync::Arc;

/// One `glClear`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clear {
    /// Left, bottom, right and top, the last two beyond.
    pub(crate) region: [i32; 4],
    pub(crate) color: [f32; 4],
    /// The bits of a colour that are written.
    pub(crate) color_mask: u32,
    pub(crate) depth: Option<f64>,
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
    Batch(Box<Batch>),
    Clear(ClearedTo),
}

/// What has been drawn.
#[derive(Debug, Default)]
pub(crate) struct Log {
    items: Vec<Item>,
    bytes: usize,
    /// The pipeline of the last draw: the next one often has the same.
    last: Option<Arc<Pipeline>>,
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
            depth: clear.depth.map(|depth| (depth * f64::from(LARGEST_DEPTH)).round() as f32),
            stencil: u32::from(clear.stencil.unwrap_or(0)),
            stencil_mask: if has_stencil { u32::from(clear.stencil_mask) } else { 0 },
        }));
        self.bytes += size_of::<Item>();
    }

    pub(crate) fn draw(&mut self, batch: Batch) {
        if !batch.pieces.is_empty() {
            self.bytes += batch.bytes();
            self.items.push(Item::Batch(Box::new(batch)));
        }
    }

    /// Whether it holds so much that it is to be carried out.
    pub(crate) fn is_full(&self) -> bool {
        self.bytes > LOG_BYTES
    }

    /// Whether there is nothing to be carried out.
    pub(crate) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Carries everything out, tile by tile, each in the order of the log.
    pub(crate) fn carry_out(&mut self, framebuffer: &mut Framebuffer, level: Level) {
        let items = std::mem::take(&mut self.items);
        self.bytes = 0;
        if items.is_empty() || framebuffer.tiles.is_empty() {
            return;
        }
        let across = framebuffer.across();
        let lists = sorted(&items, across, framebuffer.tiles.len());
        let size = framebuffer.size().map(|side| side as i32);
        luxel_parallel::fill(&mut framebuffer.tiles, 1, &|number, tiles| {
            let list = &lists[number];
            if list.is_empty() {
                return;
            }
            let origin = [number % across, number / across].map(|at| at as i32 * TILE);
            for planes in tiles {
                let mut worker = TileWorker::new(&items, list, origin, size, planes);
                dispatch_long!(level, simd => worker.carry_out(simd));
            }
        });
    }
}

/// What reaches each tile, in order.
fn sorted(items: &[Item], across: usize, tiles: usize) -> Vec<Vec<Entry>> {
    let mut lists = vec![Vec::new(); tiles];
    let mut put = |[left, bottom, right, top]: [i32; 4], entry: Entry| {
        if left >= right || bottom >= top {
            return;
        }
        for row in bottom / TILE..=(top - 1) / TILE {
            for column in left / TILE..=(right - 1) / TILE {
                lists[row as usize * across + column as usize].push(entry);
            }
        }
    };
    for (number, item) in items.iter().enumerate() {
        let item_number = number as u32;
        match item {
            Item::Clear(clear) => put(clear.region, Entry { item: item_number, piece: 0 }),
            Item::Batch(batch) => {
                for (piece, of) in batch.pieces.iter().enumerate() {
                    debug_assert!(!matches!(of.shape, Shape::Line { width: 0, .. }));
                    put(batch.bounds(of), Entry { item: item_number, piece: piece as u32 });
                }
            }
        }
    }
    lists
}
