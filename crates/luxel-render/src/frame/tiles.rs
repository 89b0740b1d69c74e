//! Tiles into a picture: shared out among threads, the costliest first, and put together.

use super::error::RenderError;
use luxel_math::LANES;
use luxel_scene::Size;
use luxel_visibility::{BLOCK, BLOCKS, Frame, TILE};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

const SIDE: usize = TILE as usize;

/// A stop flag that is never set.
pub(crate) static NEVER: AtomicBool = AtomicBool::new(false);

/// The outcome of a drawing.
///
/// # Errors
/// [`RenderError::Stopped`] once `stop` is set.
pub(crate) fn unless_stopped(stop: &AtomicBool) -> Result<(), RenderError> {
    if stop.load(Ordering::Relaxed) { Err(RenderError::Stopped) } else { Ok(()) }
}

/// The pixels of a tile, row by row.
pub(crate) type TilePixels<T> = [T; SIDE * SIDE];

/// Writes a block's pixels among the rows of its tile.
#[inline(always)]
pub(crate) fn put_block<T: Copy>(pixels: &mut TilePixels<T>, block: usize, values: &[T; LANES]) {
    const WIDTH: usize = BLOCK as usize;
    let first = place_in_tile(block, 0);
    for (row, values) in values.as_chunks::<WIDTH>().0.iter().enumerate() {
        let start = first + row * SIDE;
        pixels[start..start + WIDTH].copy_from_slice(values);
    }
}

/// Where a block's lane lies among the rows of its tile.
#[inline(always)]
pub(crate) fn place_in_tile(block: usize, lane: usize) -> usize {
    const WIDTH: usize = BLOCK as usize;
    let (row, column) = (block / BLOCKS as usize, block % BLOCKS as usize);
    (row * WIDTH + lane / WIDTH) * SIDE + column * WIDTH + lane % WIDTH
}

/// A plane of values in bands, each a row of tiles, which is locked only while something finished is
/// copied into it. Its values are `channels` to a pixel.
pub(crate) struct Bands<'p, T> {
    bands: Vec<Mutex<&'p mut [T]>>,
    channels: usize,
    width: usize,
    across: usize,
}

impl<'p, T: Copy + Default> Bands<'p, T> {
    /// A plane of a size in the memory of `values`; every value is to be written.
    pub(crate) fn new(values: &'p mut Vec<T>, size: Size, channels: usize) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        values.resize(width * height * channels, T::default());
        let bands = values.chunks_mut(width * channels * SIDE).map(Mutex::new).collect();
        Self { bands, channels, width, across: width.div_ceil(SIDE) }
    }

    /// Copies a tile to its place; its values are given row by row.
    pub(crate) fn put(&self, tile: usize, values: &[T]) {
        let Self { bands, channels, width, across } = self;
        let left = tile % across * SIDE;
        let count = (width - left).min(SIDE) * channels;
        // A poisoned lock means that another thread has panicked, which rayon passes on.
        let Ok(mut rows) = bands[tile / across].lock() else { return };
        for (row, source) in
            rows.chunks_mut(width * channels).zip(values.chunks_exact(SIDE * channels))
        {
            row[left * channels..][..count].copy_from_slice(&source[..count]);
        }
    }

    /// Fills columns of a band with one value for all channels.
    pub(crate) fn fill(&self, band: usize, columns: &[Range<usize>], value: T) {
        let Self { bands, channels, width, .. } = self;
        let Ok(mut rows) = bands[band].lock() else { return };
        for row in rows.chunks_mut(width * channels) {
            for columns in columns {
                row[columns.start * channels..columns.end * channels].fill(value);
            }
        }
    }
}

/// Work on the tiles of a frame, and on the columns of a band in which nothing can be seen.
pub(crate) trait TileWork<W>: Sync {
    /// Draws a tile and copies it to where it belongs.
    fn draw(&self, worker: &mut W, tile: usize);
    /// Fills empty columns of a band: all at once, as threads with a tile each would wait for one
    /// another.
    fn fill(&self, band: usize, columns: &[Range<usize>]);
}

/// Does work on the tiles of a frame that a set holds, by all threads: draws those that show a surface,
/// or all if `are_all_drawn`, and fills the others. `worker` makes what one thread
/// keeps from tile to tile. The outcome is the same for any number of threads, as a tile depends on
/// nothing but itself. Once `stop` is set, the remaining tiles are skipped.
pub(crate) fn for_tiles<W>(
    frame: &Frame<'_>,
    set: &(dyn Fn(usize) -> bool + Sync),
    are_all_drawn: bool,
    stop: &AtomicBool,
    worker: impl Fn() -> W + Sync,
    work: &impl TileWork<W>,
) {
    let mut order = frame.tiles_by_load();
    let is_drawn = |tile: usize| are_all_drawn || !frame.is_tile_empty(tile);
    order.truncate(order.partition_point(|&tile| is_drawn(tile as usize)));
    order.retain(|&tile| set(tile as usize));
    let [_, bands] = frame.tiles();
    let tasks = order.len() + bands;
    let next = AtomicUsize::new(0);
    let take = || {
        let mut worker = worker();
        while !stop.load(Ordering::Relaxed) {
            let task = next.fetch_add(1, Ordering::Relaxed);
            if let Some(&tile) = order.get(task) {
                work.draw(&mut worker, tile as usize);
            } else if task < tasks {
                let band = task - order.len();
                let is_filled = |tile: usize| !is_drawn(tile) && set(tile);
                work.fill(band, &columns_of(frame, &is_filled, band));
            } else {
                return;
            }
        }
    };
    // Each takes tiles until none is left.
    luxel_parallel::tasks(luxel_parallel::threads().min(tasks), &|_| take());
}

/// Runs of columns of a row of tiles that a set holds.
fn columns_of(
    frame: &Frame<'_>,
    set: &(dyn Fn(usize) -> bool + Sync),
    band: usize,
) -> Vec<Range<usize>> {
    let [across, _] = frame.tiles();
    let width = frame.size().width as usize;
    let mut runs: Vec<Range<usize>> = Vec::new();
    for column in (0..across).filter(|column| set(band * across + column)) {
        let left = column * TILE as usize;
        let right = width.min(left + TILE as usize);
        match runs.last_mut() {
            Some(run) if run.end == left => run.end = right,
            _ => runs.push(left..right),
        }
    }
    runs
}
