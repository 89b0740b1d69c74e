//! How much a file may ask for.

use crate::{Error, ErrorKind, Place};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Bounds that are checked before memory is taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes that one model may take in memory, textures included.
    pub max_memory: u64,
    /// How deep nodes, groups or JSON values may nest.
    pub max_depth: u32,
    /// Whoever watches the reading, and may stop it.
    pub watch: Option<Progress>,
}

/// How far the reading of a model has come: shared by who reads and who waits, on another thread.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<Counts>);

#[derive(Debug, Default)]
struct Counts {
    /// Bytes of files read, and to be read as far as is known.
    read: AtomicU64,
    all: AtomicU64,
    is_stopped: AtomicBool,
}

impl Progress {
    /// Bytes of files that have been read, and all that are to be read, as far as is known yet.
    #[must_use]
    pub fn bytes(&self) -> (u64, u64) {
        (self.0.read.load(Ordering::Relaxed), self.0.all.load(Ordering::Relaxed))
    }

    /// Reading ends with [`ErrorKind::Stopped`] as soon as it looks.
    pub fn stop(&self) {
        self.0.is_stopped.store(true, Ordering::Relaxed);
    }

    /// Whether it is to end.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.0.is_stopped.load(Ordering::Relaxed)
    }

    /// A file of so many bytes is to be read.
    pub(crate) fn expect(&self, bytes: u64) {
        self.0.all.fetch_add(bytes, Ordering::Relaxed);
    }

    /// So many bytes more have been read.
    pub(crate) fn advance(&self, bytes: u64) {
        self.0.read.fetch_add(bytes, Ordering::Relaxed);
    }
}

/// Who watches changes nothing of what is allowed.
impl PartialEq for Progress {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Progress {}

impl Default for Limits {
    /// 8 GiB, 1024 levels.
    fn default() -> Self {
        Self { max_memory: 8 << 30, max_depth: 1024, watch: None }
    }
}

impl Limits {
    /// Checks that `count` things of `bytes_each` fit.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if they don't, also where the product overflows; [`ErrorKind::Stopped`]
    /// if whoever watches doesn't want the model any more.
    pub fn check(
        &self,
        what: &str,
        count: u64,
        bytes_each: u64,
        place: Place,
    ) -> Result<(), Error> {
        if self.watch.as_ref().is_some_and(Progress::is_stopped) {
            return Err(Error::at(place, ErrorKind::Stopped));
        }
        let needed = count.saturating_mul(bytes_each);
        if needed <= self.max_memory {
            return Ok(());
        }
        let kind = ErrorKind::TooLarge { what: what.to_owned(), needed, limit: self.max_memory };
        Err(Error::at(place, kind))
    }
}
