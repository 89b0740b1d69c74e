//! Models from files, bytes and file objects.

use crate::errors::{argument, load_error};
use crate::interruptible::interruptible;
use crate::scene::PyScene;
use luxel::formats::{self, Format, Limits, Loaded, Progress};
use luxel::scene;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Reads a model: a path, `bytes` of a file, or an object with `read`. Of bytes, the format is told by the
/// first ones unless `format` names it. `demo:NAME` is a built-in scene.
#[pyfunction]
#[pyo3(signature = (source, *, format=None, max_memory=None))]
pub(crate) fn load(
    py: Python<'_>,
    source: &Bound<'_, PyAny>,
    format: Option<&str>,
    max_memory: Option<u64>,
) -> PyResult<Py<PyScene>> {
    if source.hasattr("vertices")? || source.hasattr("graph")? {
        // An object of trimesh.
        return Ok(PyScene::from_trimesh(source, None, None)?.extract()?);
    }
    let format: Option<Format> =
        format.map(|name| name.parse().map_err(|error| argument("format", error))).transpose()?;
    let progress = Progress::default();
    let mut limits = Limits { progress: Some(progress.clone()), ..Limits::default() };
    if let Some(max_memory) = max_memory {
        limits.max_memory = max_memory;
    }
    let stop = || progress.stop();
    let loaded = if source.hasattr("read")? {
        let bytes: Vec<u8> = source.call_method0("read")?.extract().map_err(|_| {
            PyTypeError::new_err("source: `read` must give bytes; open the file in mode \"rb\"")
        })?;
        interruptible(py, stop, || of_bytes(&bytes, format, &limits))?
    } else if let Ok(bytes) = source.extract::<&[u8]>() {
        interruptible(py, stop, || of_bytes(bytes, format, &limits))?
    } else {
        let path: PathBuf = source.extract().map_err(|_| {
            PyTypeError::new_err("source: expected a path, bytes, or an object with `read`")
        })?;
        if let Some(name) = path.to_str().and_then(|path| path.strip_prefix("demo:")) {
            let Some(scene) = scene::demos::demo(name) else {
                let names: Vec<_> =
                    scene::demos::names().into_iter().map(|(name, _)| name).collect();
                let known = format!("there is no demo `{name}`: use {}", names.join(", "));
                return Err(argument("source", known));
            };
            return Py::new(py, PyScene::ready(scene, Vec::new()));
        }
        interruptible(py, stop, || match format {
            None => formats::open(&path, &limits),
            Some(format) => {
                let in_file = |error: formats::Error| error.in_file(&path);
                let bytes = std::fs::read(&path).map_err(|error| {
                    in_file(formats::Error::at(formats::Place::File, error.into()))
                })?;
                let stem = path.file_stem().unwrap_or_default().to_string_lossy();
                formats::read(&bytes, format, &stem, path.parent(), &limits).map_err(in_file)
            }
        })?
    };
    let Loaded { scene, warnings, .. } = loaded.map_err(|error| load_error(py, &error))?;
    let warnings = warnings.iter().map(ToString::to_string).collect();
    Py::new(py, py.detach(|| PyScene::ready(scene, warnings)))
}

/// A model of bytes.
fn of_bytes(
    bytes: &[u8],
    format: Option<Format>,
    limits: &Limits,
) -> Result<Loaded, formats::Error> {
    let format = format.or_else(|| Format::of_bytes(bytes)).ok_or_else(|| {
        let unknown = "no model that luxel knows begins like this: pass `format`".to_owned();
        formats::Error::at(formats::Place::File, formats::ErrorKind::Unsupported(unknown))
    })?;
    formats::read(bytes, format, "bytes", None, limits)
}

/// The names of the built-in scenes, which `load("demo:NAME")` gives.
#[pyfunction]
pub(crate) fn demos() -> Vec<&'static str> {
    scene::demos::names().into_iter().map(|(name, _)| name).collect()
}
