//! The memory budget of one model, with all files that it refers to.

use crate::{Error, GivenFiles, Limits, Place};
use std::sync::atomic::{AtomicU64, Ordering};

/// Counts bytes before they are allocated. Freed bytes count too, so that the budget bounds the
/// work as well.
#[derive(Debug)]
pub(crate) struct Memory<'a> {
    limits: &'a Limits,
    taken: AtomicU64,
}

impl<'a> Memory<'a> {
    pub(crate) const fn new(limits: &'a Limits) -> Self {
        Self { limits, taken: AtomicU64::new(0) }
    }

    /// Reserves `count` elements of `bytes_each`.
    pub(crate) fn take(
        &self,
        what: &str,
        count: u64,
        bytes_each: u64,
        place: Place,
    ) -> Result<(), Error> {
        let needed = count.saturating_mul(bytes_each);
        let sum = self.taken.load(Ordering::Relaxed).saturating_add(needed);
        self.limits.check(what, sum, 1, place)?;
        self.taken.store(sum, Ordering::Relaxed);
        Ok(())
    }

    /// The files that there are, if they are in memory.
    pub(crate) fn given(&self) -> Option<&'a GivenFiles> {
        self.limits.given.as_ref()
    }

    /// The limits, with the remaining memory.
    pub(crate) fn left(&self) -> Limits {
        let taken = self.taken.load(Ordering::Relaxed);
        let max_memory = self.limits.max_memory.saturating_sub(taken);
        Limits { max_memory, ..self.limits.clone() }
    }
}
