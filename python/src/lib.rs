//! The native module of the Python package `luxel`.
//!
//! LTO optimises the kernels again at this crate's optimisation level. All that can be compiled for size is therefore in
//! `luxel-python-classes`.

#![deny(missing_docs, unsafe_code)]

use pyo3::prelude::*;

/// The native part of `luxel`.
#[pymodule(gil_used = false)]
fn _luxel(module: &Bound<'_, PyModule>) -> PyResult<()> {
    luxel_python_classes::add_to(module)
}
