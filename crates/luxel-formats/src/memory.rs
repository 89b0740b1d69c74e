//! The bound on what one model may take, summed over everything that is read for it.

use crate::{Error, Limits, Place};

/// Counts bytes before they are allocated. Nothing is given back, so what is only passing through
/// counts too: a bound on the work as well.
#[derive(Debug)]
pub(crate) struct Memory<'a> {
    limits: &'a Limits,
    taken: u64,
}

impl<'a> Memory<'a> {
    pub(crate) const fn new(limits: &'a Limits) -> Self {
        Self { limits, taken: 0 }
    }

    /// Announces `count` things of `bytes_each`.
    pub(crate) fn take(
        &mut self,
        what: &str,
        count: u64,
        bytes_each: u64,
        place: Place,
    ) -> Result<(), Error> {
        let sum = self.taken.saturating_add(count.saturating_mul(bytes_each));
        self.limits.check(what, sum, 1, place)?;
        self.taken = sum;
        Ok(())
    }
}
