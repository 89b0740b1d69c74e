//! Checks: mesh defects that spoil shading.

use crate::errors::argument;
use crate::scene::SharedScene;
use crate::settings::Settings;
use luxel::check::{Finding, Place, Setup, check};
use luxel::render::View;
use luxel::scene::NormalOptions;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The findings in a scene, as `luxel check --json` lists them, without the flags of cures.
pub(crate) fn findings<'py>(
    py: Python<'py>,
    shared: &SharedScene,
    view: &View,
    settings: &Settings<'_>,
) -> PyResult<Bound<'py, PyList>> {
    if shared.scene.is_empty() {
        return Err(argument("scene", "there is nothing to draw"));
    }
    let setup = Setup {
        view: view.clone(),
        normals: NormalOptions::default(),
        execution: settings.execution()?,
    };
    let report =
        crate::interruptible::interruptible(py, || (), || check(&shared.bare_scene(), &setup))?;
    let objects = shared.scene.objects();
    let place = |place: &Place| {
        let node = objects[place.object as usize].node;
        let entry = PyDict::new(py);
        entry.set_item("index", place.object)?;
        entry.set_item("object", shared.scene.nodes[node.index()].name.as_str())?;
        entry.set_item("path", shared.scene.path(node))?;
        entry.set_item("triangle", place.triangle)?;
        entry.set_item("position", place.position.to_array().to_vec())?;
        Ok::<_, PyErr>(entry)
    };
    let entries = PyList::empty(py);
    for finding in &report.findings {
        let Finding { kind, count, severity, pixels, places } = finding;
        let entry = PyDict::new(py);
        entry.set_item("kind", kind.name())?;
        entry.set_item("about", kind.about())?;
        entry.set_item("count", count)?;
        entry.set_item("severity", severity)?;
        entry.set_item("pixels", pixels)?;
        entry.set_item("places", places.iter().map(place).collect::<PyResult<Vec<_>>>()?)?;
        entry.set_item("cure", kind.cure())?;
        entries.append(entry)?;
    }
    Ok(entries)
}
