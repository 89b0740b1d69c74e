//! The native module of the Python package `luxel`.
//!
//! This crate is the last one to be linked, by whose level of optimisation kernels are compiled again: so it has
//! nothing else.

#![deny(missing_docs, unsafe_code)]

use pyo3::prelude::*;

/// The native part of `luxel`.
#[pymodule(gil_used = false)]
fn _luxel(module: &Bound<'_, PyModule>) -> PyResult<()> {
    luxel_python_classes::add_to(module)
}
