//! The memory of threads between frames.
//!
//! What one thread keeps from tile to tile is some hundred KiB, whose pages the system clears when they are
//! first touched: half a millisecond a call. A renderer therefore keeps it from frame to frame.

use super::tile_shading::Worker;
use luxel_visibility::Samples;
use std::ops::{Deref, DerefMut};
use std::sync::Mutex;

/// The workers that no thread uses.
#[derive(Default)]
pub(crate) struct Workers {
    idle: Mutex<Vec<Box<Worker>>>,
}

/// A worker in use; dropping it makes it idle.
pub(crate) struct BusyWorker<'w> {
    workers: &'w Workers,
    /// `None` only while it is dropped.
    worker: Option<Box<Worker>>,
}

impl Workers {
    /// A worker for a frame with this many samples, without anything of an earlier frame.
    pub(crate) fn take(&self, samples: Samples) -> BusyWorker<'_> {
        // Passes of one and of several samples alternate: both kinds of workers are kept.
        let fitting = |idle: &mut Vec<Box<Worker>>| {
            let at = idle.iter().rposition(|worker| worker.samples == samples.count())?;
            Some(idle.swap_remove(at))
        };
        let idle = self.idle.lock().ok().and_then(|mut idle| fitting(&mut idle));
        let worker = match idle {
            Some(mut worker) => {
                worker.cache.begin_frame();
                worker
            }
            None => Box::new(Worker::new(samples)),
        };
        BusyWorker { workers: self, worker: Some(worker) }
    }
}

impl Drop for BusyWorker<'_> {
    fn drop(&mut self) {
        if let (Some(worker), Ok(mut idle)) = (self.worker.take(), self.workers.idle.lock()) {
            idle.push(worker);
        }
    }
}

impl Deref for BusyWorker<'_> {
    type Target = Worker;

    fn deref(&self) -> &Worker {
        self.worker.as_deref().unwrap_or_else(|| unreachable!("it is there until it is dropped"))
    }
}

impl DerefMut for BusyWorker<'_> {
    fn deref_mut(&mut self) -> &mut Worker {
        self.worker
            .as_deref_mut()
            .unwrap_or_else(|| unreachable!("it is there until it is dropped"))
    }
}
