//! `luxel gallery`: the gallery of shading errors and plots.

#[cfg(feature = "gallery")]
mod book;

use crate::options::ExecutionOptions;
#[cfg(not(feature = "gallery"))]
use crate::{console::Console, failure::Failure};
use clap::Args;
use std::ffi::OsString;

/// Write the gallery of shading errors and plots
///
/// Shading errors, each beside its cure with both errors measured, and plots of
/// light and reflection: images, and a page, index.html, that explains them. For example:
/// luxel gallery -o gallery
#[derive(Args, Debug)]
pub(crate) struct GalleryCommand {
    /// The output folder; created if missing
    #[arg(short, long, value_name = "DIR")]
    output: OsString,

    /// Print a JSON document with the numbers
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    execution: ExecutionOptions,
}

#[cfg(not(feature = "gallery"))]
impl GalleryCommand {
    pub(crate) fn run(self, _: Console) -> Result<(), Failure> {
        let what = "this build of luxel has no gallery";
        Err(Failure::work(what, "build luxel with `--features gallery`"))
    }
}
