//! Tiles into a picture: shared out among threads, the costliest first, and put together.

use luxel_scene::Size;
use luxel_visibility::{Frame, TILE};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The pixels of a tile, row by row.
pub(crate) type TilePixels<T> = [T; (TILE * TILE) as usize];

/// Draws all tiles of a frame, and puts them together row by row in `picture`, whose memory is used
/// again.
///
/// `worker` makes what one thread keeps from tile to tile; `draw` fills a tile's pixels. A picture
/// is the same for any number of threads, as a tile depends on nothing but itself.
pub(crate) fn draw_tiles<T: Copy + Default + Send, W>(
    frame: &Frame<'_>,
    picture: &mut Vec<T>,
    worker: impl Fn() -> W + Sync,
    draw: impl Fn(&mut W, usize, &mut TilePixels<T>) + Sync,
) {
    let Size { width, height } = frame.size();
    let (width, height) = (width as usize, height as usize);
    // Every pixel is written below.
    picture.resize(width * height, T::default());
    // A band is a row of tiles, locked only while a finished tile is copied into it.
    let band = width * TILE as usize;
    let bands: Vec<Mutex<&mut [T]>> = picture.chunks_mut(band).map(Mutex::new).collect();
    let order = frame.tiles_by_load();
    let next = AtomicUsize::new(0);
    let [across, _] = frame.tiles();
    let work = || {
        let mut kept = worker();
        let mut pixels = Box::new([T::default(); (TILE * TILE) as usize]);
        while let Some(&tile) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            let tile = tile as usize;
            draw(&mut kept, tile, &mut pixels);
            let left = tile % across * TILE as usize;
            let columns = (width - left).min(TILE as usize);
            // A poisoned lock means that another thread has panicked, which rayon passes on.
            let Ok(mut rows) = bands[tile / across].lock() else { return };
            for (row, source) in rows.chunks_mut(width).zip(pixels.chunks_exact(TILE as usize)) {
                row[left..left + columns].copy_from_slice(&source[..columns]);
            }
        }
    };
    // Each takes tiles until none is left.
    luxel_parallel::tasks(luxel_parallel::threads().min(order.len()), &|_| work());
}
