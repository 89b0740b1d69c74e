//! Scenes as bytes, for pickles and for notebooks.

use crate::errors::error;
use crate::scene::PyScene;
use pyo3::prelude::*;

/// The scene of some bytes, which `Scene.__reduce__` of the same version gave.
#[pyfunction]
pub(crate) fn unpack(py: Python<'_>, bytes: &[u8], warnings: Vec<String>) -> PyResult<PyScene> {
    let scene = py.detach(|| luxel::unpack(bytes)).map_err(error)?;
    Ok(PyScene::whole(scene, warnings))
}
