//! `luxel gallery`: the picture book.

#[cfg(feature = "gallery")]
mod book;

use crate::options::ExecutionOptions;
#[cfg(not(feature = "gallery"))]
use crate::{console::Console, failure::Failure};
use clap::Args;
use std::ffi::OsString;

/// Write the picture book
///
/// What shading does wrong, each problem beside its cure with the errors measured, and plots of
/// light and reflection: pictures, and a page, index.html, that explains them. For example:
/// luxel gallery -o gallery
#[derive(Args, Debug)]
pub(crate) struct GalleryCommand {
    /// The folder to write into; it is made if there is none
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
        Err(Failure::work(what, "build it with `--features gallery`"))
    }
}
