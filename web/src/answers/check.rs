//! What in the mesh spoils shading.

use crate::error::exception;
use crate::questions::CheckedModel;
use crate::view::{ModelView, execution};
use luxel::check::{Kind, Setup};
use luxel::render::Renderer;
use serde_json::json;
use std::sync::Arc;
use wasm_bindgen::JsError;

pub(super) fn check(view: &ModelView) -> Result<CheckedModel, JsError> {
    let scene = view.renderer.scene();
    if scene.is_empty() {
        return Err(exception("there is nothing to draw"));
    }
    let normals = view.settings.normals().map_err(exception)?;
    let setup = Setup { view: view.view.clone(), normals, execution: execution() };
    let report = luxel::check::check(&view.model, &setup);
    let findings = report.to_json(&view.model, |kind| kind.cure().to_owned());
    let about = |kind: Kind| (kind.name().to_owned(), json!(kind.about()));
    let about: serde_json::Map<_, _> = Kind::ALL.into_iter().map(about).collect();
    let json = json!({
        "findings": findings,
        "about": about,
        "triangles": scene.triangle_count(),
    });
    let marked = Arc::new(report.marked(scene));
    let renderer = Renderer::new(Arc::clone(&marked), &execution()).map_err(exception)?;
    let mut seen = luxel::default_view_from(&marked, view.view.camera, view.view.size);
    seen.samples = view.view.samples;
    let picture = report.picture(scene, &[], &renderer, &seen).map_err(exception)?;
    Ok(CheckedModel { json: json.to_string(), pixels: picture.pixels.into_flattened() })
}
