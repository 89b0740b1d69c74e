//! Options of execution, which never change a byte of an image.

use crate::values::{memory, threads};
use clap::Args;
use luxel::math::SimdLevel;

/// Threads, SIMD, memory.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Execution")]
pub(crate) struct ExecutionOptions {
    /// Number of threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub(crate) threads: Option<usize>,

    /// The instruction set: auto, scalar, sse2, sse4.2, avx2, avx512, neon
    #[arg(long, value_name = "LEVEL", default_value = "auto", value_parser = simd_level)]
    pub(crate) simd: SimdLevel,

    /// Memory limit of a model, of an image and of trees for rays, each, such as 512M or 2G
    #[arg(long, value_name = "SIZE", default_value = "8G", value_parser = memory)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) max_memory: u64,
}

impl ExecutionOptions {
    /// Limits the threads of readers that work beside a window; its renderer has its own.
    pub(crate) fn limit_threads(&self) {
        if let Some(count) = self.threads {
            luxel_parallel::limit_threads(count);
        }
    }

    /// Makes this thread one of those that do everything, for commands that end with their result.
    pub(crate) fn take_part(&self) {
        luxel_parallel::take_part(self.threads.unwrap_or(0));
    }
}

/// A level that this machine supports.
fn simd_level(text: &str) -> Result<SimdLevel, String> {
    let level: SimdLevel = text.parse().map_err(|error| format!("{error}"))?;
    level.resolve().map(|_| level).map_err(|error| error.to_string())
}
