//! The classes and functions of the native module of the Python package `luxel`: scenes, views, frames, picks and
//! ledgers. A separate crate, compiled for size: its code runs once per picture.
//!
//! Each module has one class or one family of functions. Long work runs without the interpreter's lock, in
//! [`interruptible`]; every error of the library becomes one of [`errors`].

#![deny(missing_docs, unsafe_code)]

mod arrays;
mod bare_mesh;
mod batch;
mod camera;
mod check;
mod errors;
mod frame;
mod interruptible;
mod ledger;
mod load;
mod meshes;
mod packed;
mod parts;
mod picks;
mod rasterize;
mod rays;
mod scene;
mod settings;
mod stage;
mod view;

use pyo3::prelude::*;

/// Adds all classes and functions to the native module.
///
/// # Errors
/// What the interpreter raises.
pub fn add_to(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("Error", py.get_type::<errors::Error>())?;
    module.add("LoadError", py.get_type::<errors::LoadError>())?;
    module.add_class::<scene::PyScene>()?;
    module.add_class::<camera::PyCamera>()?;
    module.add_class::<view::PyView>()?;
    module.add_class::<frame::PyFrame>()?;
    module.add_class::<ledger::PyLedger>()?;
    module.add_class::<picks::PyHit>()?;
    module.add_function(wrap_pyfunction!(load::load, module)?)?;
    module.add_function(wrap_pyfunction!(load::demos, module)?)?;
    module.add_function(wrap_pyfunction!(parts::build_scene, module)?)?;
    module.add_class::<stage::PyStage>()?;
    module.add_function(wrap_pyfunction!(packed::unpack, module)?)?;
    module.add_function(wrap_pyfunction!(rasterize::rasterize_clip, module)?)?;
    module.add_function(wrap_pyfunction!(batch::run_program, module)?)?;
    module.add_function(wrap_pyfunction!(batch::draw_task, module)?)?;
    module.add_function(wrap_pyfunction!(batch::task_id, module)?)?;
    module.add_function(wrap_pyfunction!(batch::merkle_root, module)?)?;
    module.add_class::<batch::PyWorker>()?;
    Ok(())
}
