//! What in the mesh spoils shading.

use crate::error::exception;
use crate::view::{ModelView, execution};
use luxel::check::{Kind, Setup, check};
use luxel::render::Renderer;
use serde_json::json;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// Findings, and a picture that marks them.
#[wasm_bindgen]
pub struct CheckedModel {
    json: String,
    pixels: Vec<u8>,
}

#[wasm_bindgen]
impl CheckedModel {
    /// The findings, as `luxel check --json` prints them, and the kinds' own words.
    #[wasm_bindgen(getter)]
    pub fn json(&self) -> String {
        self.json.clone()
    }

    /// The model in grey with its findings in colour: four bytes a pixel, of the view's size.
    pub fn take_pixels(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.pixels)
    }
}

#[wasm_bindgen]
impl ModelView {
    /// Examines the model as it is seen here.
    ///
    /// # Errors
    /// An exception for a model without triangles.
    pub fn check(&self) -> Result<CheckedModel, JsError> {
        let scene = self.renderer.scene();
        if scene.is_empty() {
            return Err(exception("there is nothing to draw"));
        }
        let normals = self.settings.normals().map_err(exception)?;
        let setup = Setup { view: self.view.clone(), normals, execution: execution() };
        let report = check(&self.model, &setup);
        let findings = report.to_json(&self.model, |kind| kind.cure().to_owned());
        let about = |kind: Kind| (kind.name().to_owned(), json!(kind.about()));
        let about: serde_json::Map<_, _> = Kind::ALL.into_iter().map(about).collect();
        let json = json!({
            "findings": findings,
            "about": about,
            "triangles": scene.triangle_count(),
        });
        let marked = Arc::new(report.marked(scene));
        let renderer = Renderer::new(Arc::clone(&marked), &execution()).map_err(exception)?;
        let mut view = luxel::default_view_from(&marked, self.view.camera, self.view.size);
        view.samples = self.view.samples;
        let picture = report.picture(scene, &[], &renderer, &view).map_err(exception)?;
        Ok(CheckedModel { json: json.to_string(), pixels: picture.pixels.into_flattened() })
    }
}
