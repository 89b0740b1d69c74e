//! `luxel batch` in a build without it.

use crate::console::Console;
use crate::failure::Failure;
use clap::Args;
use std::ffi::OsString;

/// Render a list of tasks, each a model with its views: left out of this build
#[derive(Args, Debug)]
pub(crate) struct BatchCommand {
    /// What a build with batches takes
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    words: Vec<OsString>,
}

impl BatchCommand {
    pub(crate) fn run(self, _: Console) -> Result<(), Failure> {
        let what = "this build of luxel has no batches";
        Err(Failure::work(what, "build luxel with `--features batch`"))
    }
}
