//! What draws tasks: the side of a worker that knows what tasks mean.

use crate::{Digest, TaskError};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io;

/// Draws tasks, one after the other.
pub trait Work {
    /// Reads a task and its inputs.
    ///
    /// # Errors
    /// [`TaskError`] if the line is wrong or an input can't be read.
    fn begin(&mut self, line: &str) -> Result<Begun, TaskError>;

    /// Draws the task that [`begin`](Self::begin) read, and gives each output to `put`.
    ///
    /// # Errors
    /// [`WorkError`]
    fn finish(
        &mut self,
        put: &mut dyn FnMut(DrawnFile) -> io::Result<()>,
    ) -> Result<Finished, WorkError>;
}

/// Why a task has no outputs.
#[derive(Debug)]
pub enum WorkError {
    /// The task can't be done.
    Task(TaskError),
    /// An output can't be stored.
    Output(io::Error),
}

impl From<TaskError> for WorkError {
    fn from(error: TaskError) -> Self {
        Self::Task(error)
    }
}

/// A task whose inputs have been read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Begun {
    /// The name by content of its outputs.
    pub key: Digest,
    /// The files that it is made of.
    pub inputs: Vec<Input>,
}

/// A file that a task is made of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Input {
    /// Its path, absolute or relative to the folder of the list.
    pub path: String,
    /// Its length in bytes; `None` if it wasn't there.
    pub bytes: Option<u64>,
    /// When it was changed, in nanoseconds since 1970; `None` if it wasn't there.
    pub mtime: Option<i64>,
}

/// The content of an output file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrawnFile {
    /// The number of the view, from 0.
    pub view: u32,
    /// The name of the view, if it has one.
    pub name: Option<String>,
    /// The layer, as the task has it.
    pub layer: String,
    /// The file's name: view, layer, extension.
    pub file: String,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// What there is to say of a task that has been drawn.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Finished {
    /// Milliseconds by stage.
    pub ms: BTreeMap<String, f64>,
    /// Parts of the input that were left out or replaced.
    pub warnings: Vec<String>,
}
