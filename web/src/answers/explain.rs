//! Why a pixel has its colour.

use crate::error::exception;
use crate::view::ModelView;
use luxel::render::{At, Unseen};
use luxel::report::Report;
use wasm_bindgen::JsError;

/// How a ledger is written.
#[derive(Clone, Copy)]
pub(crate) enum Format {
    Text,
    Json,
    Latex,
}

pub(super) fn explain(view: &ModelView, at: [u32; 2], format: Format) -> Result<String, JsError> {
    let explanation = view.renderer.explain(&view.view, At::Pixel(at)).map_err(exception)?;
    let unseen = Unseen::new(&view.renderer, &view.view, &explanation).map_err(exception)?;
    let report = Report::new(&explanation, view.renderer.scene(), &view.view);
    let report = report.with_unseen(&unseen);
    Ok(match format {
        Format::Text => report.to_text(),
        Format::Json => report.to_json().to_string(),
        Format::Latex => report.to_latex(),
    })
}
