//! Ledgers: why a pixel has its colour.

use crate::errors::error;
use luxel::render::{Explanation, Renderer, Unseen, View};
use luxel::report::{Pictures, Report};
use luxel::scene::Scene;
use pyo3::prelude::*;
use std::sync::Arc;

/// Every term of a pixel's light, which add up to its bytes. It prints as `luxel explain` does.
#[pyclass(name = "Ledger", module = "luxel", frozen)]
pub(crate) struct PyLedger {
    scene: Arc<Scene>,
    renderer: Arc<Renderer>,
    view: Arc<View>,
    explanation: Explanation,
    unseen: Unseen,
}

impl PyLedger {
    pub(crate) fn new(
        scene: Arc<Scene>,
        renderer: Arc<Renderer>,
        view: Arc<View>,
        explanation: Explanation,
        unseen: Unseen,
    ) -> Self {
        Self { scene, renderer, view, explanation, unseen }
    }

    fn report(&self) -> Report<'_> {
        Report::new(&self.explanation, &self.scene, &self.view).with_unseen(&self.unseen)
    }
}

#[pymethods]
impl PyLedger {
    /// The pixel's bytes: red, green, blue, alpha.
    #[getter]
    fn rgba(&self) -> (u8, u8, u8, u8) {
        self.explanation.rgba8.into()
    }

    /// (column, row).
    #[getter]
    fn pixel(&self) -> (u32, u32) {
        let [x, y] = self.explanation.pixel;
        (x, y)
    }

    /// The document of `luxel explain --json`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        from_json(py, &self.report().to_json().to_string())
    }

    /// The document of `luxel explain --json` as text.
    fn to_json(&self) -> String {
        self.report().to_json().to_string()
    }

    /// A fragment of LaTeX, for a document with amsmath.
    fn to_latex(&self) -> String {
        self.report().to_latex()
    }

    /// A page of HTML with drawings of the pixel's neighbourhood and vectors.
    fn to_html(&self, py: Python<'_>) -> PyResult<String> {
        let pixel = self.explanation.pixel;
        let drawn = py.detach(|| Pictures::draw(&self.renderer, &self.view, pixel));
        let pictures = drawn.map_err(error)?;
        Ok(self.report().with_pictures(&pictures).to_html())
    }

    /// What a notebook displays: the page, in a frame of its own, so that its style stays inside.
    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        let page = self.to_html(py)?.replace('&', "&amp;").replace('"', "&quot;");
        Ok(format!(
            "<iframe srcdoc=\"{page}\" style=\"width:100%;height:40em;border:0\" \
             title=\"The ledger of a pixel\"></iframe>"
        ))
    }

    fn __str__(&self) -> String {
        self.report().to_text()
    }

    fn __repr__(&self) -> String {
        let ([x, y], [r, g, b, alpha]) = (self.explanation.pixel, self.explanation.rgba8);
        format!("<luxel.Ledger of pixel ({x}, {y}): ({r}, {g}, {b}, {alpha})>")
    }
}

/// A JSON document as Python's own types.
pub(crate) fn from_json<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (text,))
}
