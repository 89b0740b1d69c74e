//! What a worker answers of a task.

use crate::{Begun, Digest, Finished, Input, Output, TaskError};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What became of a task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub(crate) enum Answer {
    Done(Done),
    Failed(Failed),
}

/// A task with all its outputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Done {
    pub(crate) key: Digest,
    pub(crate) inputs: Vec<Input>,
    pub(crate) outputs: Vec<Output>,
    /// Milliseconds by stage.
    pub(crate) ms: BTreeMap<String, f64>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) warnings: Vec<String>,
}

/// A task without outputs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Failed {
    pub(crate) error: String,
    /// Whether the line of the list is wrong.
    #[serde(default)]
    pub(crate) is_in_list: bool,
}

impl From<TaskError> for Failed {
    fn from(TaskError { text, is_in_list }: TaskError) -> Self {
        Self { error: text, is_in_list }
    }
}

impl Done {
    pub(crate) fn new(begun: Begun, outputs: Vec<Output>, finished: Finished) -> Self {
        let Begun { key, inputs } = begun;
        let Finished { ms, warnings } = finished;
        Self { key, inputs, outputs, ms, warnings }
    }
}
