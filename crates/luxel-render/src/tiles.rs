//! Tiles into a picture: shared out among threads, the costliest first, and put together.

use luxel_scene::Size;
use luxel_visibility::{Frame, TILE};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The pixels of a tile, row by row.
pub(crate) type TilePixels<T> = [T; (TILE * TILE) as usize];

/// Draws all tiles of a frame, and puts them together row by row in `picture`, whose memory is used
/// again.
///
/// `worker` makes what one thread keeps from tile to tile; `draw` fills a tile's pixels. Where
/// nothing can be seen, all pixels are `background`, if that is known beforehand. A picture is the
/// same for any number of threads, as a tile depends on nothing but itself.
pub(crate) fn draw_tiles<T: Copy + Default + Send + Sync, W>(
    frame: &Frame<'_>,
    picture: &mut Vec<T>,
    background: Option<T>,
    worker: impl Fn() -> W + Sync,
    draw: impl Fn(&mut W, usize, &mut TilePixels<T>) + Sync,
) {
    let Size { width, height } = frame.size();
    let (width, height) = (width as usize, height as usize);
    // Every pixel is written below.
    picture.resize(width * height, T::default());
    // A band is a row of tiles, locked only while something finished is copied into it.
    let band = width * TILE as usize;
    let bands: Vec<Mutex<&mut [T]>> = picture.chunks_mut(band).map(Mutex::new).collect();
    let mut order = frame.tiles_by_load();
    if background.is_some() {
        order.truncate(order.partition_point(|&tile| !frame.is_tile_empty(tile as usize)));
    }
    let tasks = order.len() + background.map_or(0, |_| bands.len());
    let next = AtomicUsize::new(0);
    let [across, _] = frame.tiles();
    let work = || {
        let mut kept = worker();
        let mut pixels = Box::new([T::default(); (TILE * TILE) as usize]);
        loop {
            let task = next.fetch_add(1, Ordering::Relaxed);
            if let Some(&tile) = order.get(task) {
                let tile = tile as usize;
                draw(&mut kept, tile, &mut pixels);
                let left = tile % across * TILE as usize;
                let columns = (width - left).min(TILE as usize);
                // A poisoned lock means that another thread has panicked, which rayon passes on.
                let Ok(mut rows) = bands[tile / across].lock() else { return };
                for (row, source) in rows.chunks_mut(width).zip(pixels.chunks_exact(TILE as usize))
                {
                    row[left..left + columns].copy_from_slice(&source[..columns]);
                }
            } else if let Some(background) = background.filter(|_| task < tasks) {
                // All of a band at once: threads with a tile each would wait for one another.
                let band = task - order.len();
                let empty = empty_columns(frame, band);
                let Ok(mut rows) = bands[band].lock() else { return };
                for row in rows.chunks_mut(width) {
                    empty.iter().for_each(|columns| row[columns.clone()].fill(background));
                }
            } else {
                return;
            }
        }
    };
    // Each takes tiles until none is left.
    luxel_parallel::tasks(luxel_parallel::threads().min(tasks), &|_| work());
}

/// Runs of columns of a row of tiles in which nothing can be seen.
fn empty_columns(frame: &Frame<'_>, band: usize) -> Vec<Range<usize>> {
    let [across, _] = frame.tiles();
    let width = frame.size().width as usize;
    let mut runs: Vec<Range<usize>> = Vec::new();
    for column in (0..across).filter(|column| frame.is_tile_empty(band * across + column)) {
        let left = column * TILE as usize;
        let right = width.min(left + TILE as usize);
        match runs.last_mut() {
            Some(run) if run.end == left => run.end = right,
            _ => runs.push(left..right),
        }
    }
    runs
}
