//! The flags of `luxel batch`.

use super::painter::Execution;
use crate::values::{memory, threads};
use clap::{Args, ValueEnum};
use luxel::math::SimdLevel;
use std::ffi::OsString;
use std::path::PathBuf;

/// The list, the folder, and what share of it.
#[derive(Args, Clone, Debug)]
pub(crate) struct RunOptions {
    /// The list: a file with a JSON object a line, or `-` for the standard input
    #[arg(required = true)]
    pub(crate) tasks: Option<OsString>,

    /// The folder of outputs, log and manifest; what is whole there is not drawn again
    #[arg(short, long, value_name = "OUT", required = true)]
    pub(crate) output: Option<PathBuf>,

    /// Number of worker processes [default: one a core]
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub(crate) workers: Option<usize>,

    /// Draw a part of the list, for arrays of jobs: part I of N, counted from 0 or from 1; a run without this
    /// flag then joins all parts
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub(crate) shard: Option<(u32, u32)>,

    /// Put outputs into tar archives of about this size, such as 1G, as WebDataset reads them
    #[arg(long, value_name = "SIZE", value_parser = memory)]
    pub(crate) tar: Option<u64>,

    /// How progress is shown on the standard error: a bar, or JSON lines
    #[arg(long, value_name = "KIND", default_value = "bar")]
    pub(crate) progress: ProgressKind,

    /// Print a JSON document about the work done
    #[arg(long)]
    pub(crate) json: bool,

    #[command(flatten)]
    pub(crate) execution: BatchExecution,
}

/// How progress is shown.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ProgressKind {
    /// A bar, on terminals.
    Bar,
    /// A JSON document a line.
    Json,
}

/// What workers may take. Never changes a byte.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Execution")]
pub(crate) struct BatchExecution {
    /// Number of threads of each worker
    #[arg(long, value_name = "N", default_value = "1", value_parser = threads)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) threads: usize,

    /// The instruction set: auto, scalar, sse2, sse4.2, avx2, avx512, neon
    #[arg(long, value_name = "LEVEL", default_value = "auto", value_parser = simd_level)]
    pub(crate) simd: SimdLevel,

    /// Memory limit of a model, of an image and of trees for rays, each; a worker ends beyond three times as much
    #[arg(long, value_name = "SIZE", default_value = "2G", value_parser = memory)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) max_memory: u64,

    /// The longest that a task may take, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "300", value_parser = seconds)]
    pub(crate) time_limit: f64,

    /// How often a task is tried that ends its worker
    #[arg(long, value_name = "N", default_value = "3", value_parser = clap::value_parser!(u32).range(1..=100))]
    pub(crate) tries: u32,
}

impl Default for BatchExecution {
    fn default() -> Self {
        Self { threads: 1, simd: SimdLevel::Auto, max_memory: 2 << 30, time_limit: 300.0, tries: 3 }
    }
}

impl BatchExecution {
    /// What one process needs of it.
    pub(crate) fn painting(&self) -> Execution {
        let Self { threads, simd, max_memory, .. } = self;
        Execution { threads: *threads, simd: simd.name(), max_memory: *max_memory }
    }
}

/// The flags of a worker process.
#[derive(Args, Clone, Debug)]
pub(crate) struct WorkerOptions {
    /// The folder that models are relative to
    #[arg(long)]
    pub(crate) folder: PathBuf,

    /// The folder of outputs
    pub(crate) root: PathBuf,

    /// The folder of unfinished files
    pub(crate) parts: PathBuf,

    #[command(flatten)]
    pub(crate) execution: BatchExecution,
}

/// A part of a whole: I/N, where N/N is 0/N.
fn shard(text: &str) -> Result<(u32, u32), String> {
    let number = |text: &str| text.parse::<u32>().ok();
    let parts = text.split_once('/');
    match parts.and_then(|(part, all)| Some((number(part)?, number(all)?))) {
        Some((part, all)) if part <= all && all > 0 => Ok((part % all, all)),
        _ => Err("use I/N, whole numbers, such as 3/16".to_owned()),
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    let most = 1e9;
    match text.parse() {
        Ok(seconds) if seconds > 0.0 && seconds <= most => Ok(seconds),
        _ => Err(format!("use a number of seconds above 0, at most {most}")),
    }
}

/// A level that this machine supports.
fn simd_level(text: &str) -> Result<SimdLevel, String> {
    let level: SimdLevel = text.parse().map_err(|error| format!("{error}"))?;
    level.resolve().map(|_| level).map_err(|error| error.to_string())
}
