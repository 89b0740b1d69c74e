//! The vertices that something is drawn of.

use luxel_math::LANES;
use std::sync::atomic::{AtomicBool, Ordering};

/// Which of a draw's vertices are used, in groups of sixteen: what faces away or lies out of sight needs no light.
#[derive(Debug)]
pub(crate) struct UsedVertices {
    groups: Vec<AtomicBool>,
}

impl UsedVertices {
    /// None of so many vertices.
    pub(crate) fn none_of(count: usize) -> Self {
        let groups = (0..count.div_ceil(LANES)).map(|_| AtomicBool::new(false)).collect();
        Self { groups }
    }

    /// Takes note of a vertex, from any thread.
    #[inline]
    pub(crate) fn note(&self, vertex: u32) {
        // Read first: a group is noted many times, and one that is written is taken from other processors.
        let group = &self.groups[vertex as usize / LANES];
        if !group.load(Ordering::Relaxed) {
            group.store(true, Ordering::Relaxed);
        }
    }

    /// Whether some of sixteen vertices are used, the first of which is the first of a group.
    #[inline]
    pub(super) fn has(&self, first: usize) -> bool {
        self.groups[first / LANES].load(Ordering::Relaxed)
    }
}
