//! Which numbers several objects have.

use std::sync::atomic::{AtomicU32, Ordering};

/// Which objects have something in each entry of a table; entries may serve for several numbers.
pub(super) struct Owners(Vec<AtomicU32>);

impl Owners {
    const NONE: u32 = 0;
    const SEVERAL: u32 = u32::MAX;

    /// With so many entries, at least.
    pub(super) fn new(entries: usize) -> Self {
        let size = entries.next_power_of_two().clamp(1 << 8, 1 << 26);
        Self((0..size).map(|_| AtomicU32::new(Self::NONE)).collect())
    }

    fn entry(&self, number: usize) -> &AtomicU32 {
        &self.0[number & (self.0.len() - 1)]
    }

    /// Adds an object; whatever the order of additions, an entry ends as the same.
    #[inline]
    pub(super) fn add(&self, number: usize, object: u32) {
        let (entry, own) = (self.entry(number), object + 1);
        let order = Ordering::Relaxed;
        let before = match entry.load(order) {
            Self::NONE => entry.compare_exchange(Self::NONE, own, order, order),
            other => Err(other),
        };
        if before.is_err_and(|other| other != own && other != Self::SEVERAL) {
            entry.store(Self::SEVERAL, order);
        }
    }

    #[inline]
    pub(super) fn are_several(&self, number: usize) -> bool {
        self.entry(number).load(Ordering::Relaxed) == Self::SEVERAL
    }
}
