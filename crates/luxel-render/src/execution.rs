//! How pictures are drawn: it never changes a byte.

use luxel_math::SimdLevel;
use std::time::Duration;

/// How the work is done.
#[derive(Clone, Copy, Debug)]
pub struct Execution {
    /// Threads; 0 means one for each core. They are the renderer's own, but for programs whose thread
    /// [takes part](luxel_parallel::take_part) in as many.
    pub threads: usize,
    /// The instruction set.
    pub simd: SimdLevel,
    /// The time since some fixed moment, for the figures of stages. The default doesn't look at any
    /// clock, as not every machine has one.
    pub clock: fn() -> Duration,
    /// Whether a single frame is drawn: meshes are prepared in a fraction of the time and of the memory,
    /// and a frame takes somewhat longer. Pictures are the same.
    pub one_frame: bool,
    /// Bytes that trees for rays may take: a view that needs more is refused before they are built.
    pub max_memory: u64,
}

impl Default for Execution {
    fn default() -> Self {
        Self {
            threads: 0,
            simd: SimdLevel::Auto,
            clock: || Duration::ZERO,
            one_frame: false,
            max_memory: u64::MAX,
        }
    }
}
