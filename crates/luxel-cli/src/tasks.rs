//! Tasks of `luxel batch` for programs that share them out themselves.

use crate::{commands, program};
use std::ffi::OsString;
use std::path::PathBuf;

/// A task of `luxel batch`, drawn in this process.
pub use commands::batch::{DrawnOutput, DrawnTask};
pub use luxel_batch::{Seat, root};

/// Draws a task of a list, a line of JSON, in this process. Models are relative to a folder.
///
/// # Errors
/// What the manifest says of a task that failed.
pub fn draw_task(line: &str, folder: PathBuf) -> Result<DrawnTask, String> {
    commands::batch::draw_in_memory(line, folder)
}

/// The id of a task, a line of JSON.
///
/// # Errors
/// What the manifest says of a line without one, after its place.
pub fn task_id(line: &str) -> Result<String, String> {
    luxel_batch::id_of(line).map_err(|error| error.text)
}

/// A worker process for tasks of a list whose models are relative to a folder. Outputs are written below `root` by way of
/// `parts`; `flags` are those of `luxel batch` on execution. `program` starts this program, as in
/// [`main_as`](crate::main_as).
///
/// # Errors
/// The message for flags that are refused.
pub fn worker(
    program: Vec<OsString>,
    [folder, root, parts]: [PathBuf; 3],
    flags: &[String],
) -> Result<Seat, String> {
    program::set_line(program);
    commands::batch::seat(folder, [root, parts], flags)
}
