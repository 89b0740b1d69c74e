//! Lists of tasks: the program itself, its worker processes, and single tasks in this process.

use crate::errors::{argument, error};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

/// Runs the program `luxel`; `program` are the words that start it as a process. Its status.
#[pyfunction]
pub(crate) fn run_program(py: Python<'_>, program: Vec<OsString>, words: Vec<OsString>) -> u8 {
    py.detach(|| luxel_cli::main_as(program, words))
}

/// Draws a task, a line of JSON, in this process: a dict with `key`, `outputs` and `warnings`.
#[pyfunction]
pub(crate) fn draw_task<'py>(
    py: Python<'py>,
    line: &str,
    folder: PathBuf,
) -> PyResult<Bound<'py, PyDict>> {
    let drawn = py.detach(|| luxel_cli::tasks::draw_task(line, folder)).map_err(error)?;
    let entry = |output: &luxel_cli::tasks::DrawnOutput| {
        let entry = PyDict::new(py);
        entry.set_item("view", output.view)?;
        entry.set_item("name", &output.name)?;
        entry.set_item("layer", &output.layer)?;
        entry.set_item("path", &output.path)?;
        entry.set_item("sha256", &output.sha256)?;
        entry.set_item("data", PyBytes::new(py, &output.bytes))?;
        Ok::<_, PyErr>(entry)
    };
    let task = PyDict::new(py);
    task.set_item("key", &drawn.key)?;
    task.set_item("outputs", drawn.outputs.iter().map(entry).collect::<PyResult<Vec<_>>>()?)?;
    task.set_item("warnings", &drawn.warnings)?;
    Ok(task)
}

/// The id of a task, a line of JSON.
#[pyfunction]
pub(crate) fn task_id(line: &str) -> PyResult<String> {
    luxel_cli::tasks::task_id(line).map_err(error)
}

/// The root of the Merkle tree over digests, as manifests have it.
#[pyfunction]
pub(crate) fn merkle_root(digests: Vec<String>) -> PyResult<String> {
    let parse = |text: &String| {
        text.parse().map_err(|_| argument("digests", format!("`{text}` is not a SHA-256 digest")))
    };
    let digests = digests.iter().map(parse).collect::<PyResult<Vec<_>>>()?;
    Ok(luxel_cli::tasks::root(digests).to_string())
}

/// A worker process that draws tasks, replaced when it ends.
#[pyclass(name = "Worker", module = "luxel._luxel", frozen)]
pub(crate) struct PyWorker(Mutex<luxel_cli::tasks::Seat>);

#[pymethods]
impl PyWorker {
    /// `program` starts luxel; models are relative to `folder`, outputs are written below `root`, by way of `parts`;
    /// `flags` are those of `luxel batch` on execution.
    #[new]
    fn new(
        program: Vec<OsString>,
        folder: PathBuf,
        root: PathBuf,
        parts: PathBuf,
        flags: Vec<String>,
    ) -> PyResult<Self> {
        let seat = luxel_cli::tasks::worker(program, [folder, root, parts], &flags);
        Ok(Self(Mutex::new(seat.map_err(|message| argument("flags", message))?)))
    }

    /// Draws a task, a line of JSON: the answer as JSON, with `outputs` or `error`.
    fn draw(&self, py: Python<'_>, line: &str) -> PyResult<String> {
        py.detach(|| {
            let mut seat = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            seat.draw_to_json(line).map_err(PyErr::from)
        })
    }
}
