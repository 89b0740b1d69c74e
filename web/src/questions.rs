//! What JavaScript asks of a view. Answers are found by [`answers`](crate::answers).

use crate::answers::{Format, answers};
use crate::error::exception;
use crate::view::ModelView;
use luxel::render::LayerValues;
use wasm_bindgen::prelude::*;

/// Findings, and a picture that marks them.
#[wasm_bindgen]
pub struct CheckedModel {
    pub(crate) json: String,
    pub(crate) pixels: Vec<u8>,
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
    /// The object under a point of the picture, by its name; nothing where the background is.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn pick(&mut self, x: f64, y: f64) -> Result<Option<String>, JsError> {
        (answers()?.pick)(self, [x, y])
    }

    /// What is under a point of the picture, as `luxel pick --at X,Y --json` prints it; with `through` all of it,
    /// nearest first.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn pick_json(&mut self, x: f64, y: f64, through: bool) -> Result<String, JsError> {
        (answers()?.pick_json)(self, [x, y], through)
    }

    /// The objects in a rectangle of the picture, as `luxel pick --rect X,Y,W,H --json` prints them; with `visible`
    /// only those that are seen there.
    ///
    /// # Errors
    /// An exception for an empty rectangle, and if a mesh has too many triangles for rays.
    pub fn pick_rect(
        &mut self,
        x: f64,
        y: f64,
        w: f64,
        h: f64,
        visible: bool,
    ) -> Result<String, JsError> {
        (answers()?.pick_rect)(self, [x, y, w, h], visible)
    }

    /// Why a pixel has its colour: the text of `luxel explain`.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain(&self, x: u32, y: u32) -> Result<String, JsError> {
        (answers()?.explain)(self, [x, y], Format::Text)
    }

    /// The same as JSON, as `luxel explain --json` prints it.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain_json(&self, x: u32, y: u32) -> Result<String, JsError> {
        (answers()?.explain)(self, [x, y], Format::Json)
    }

    /// The same as LaTeX, as `luxel explain --latex` prints it.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain_latex(&self, x: u32, y: u32) -> Result<String, JsError> {
        (answers()?.explain)(self, [x, y], Format::Latex)
    }

    /// Why a pixel has its colour, as JSON for a page: `pixel`, `rgba8`, `terms` (sums by kind), `samples` with
    /// `lines` of the equation and `vectors` in the picture, and `hints`.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn ledger(&self, x: u32, y: u32) -> Result<String, JsError> {
        (answers()?.ledger)(self, [x, y])
    }

    /// A layer of numbers, one to three a pixel.
    ///
    /// # Errors
    /// An exception for an unknown name, and for a layer of ids.
    pub fn layer(&self, name: &str) -> Result<Vec<f32>, JsError> {
        match (answers()?.layer)(self, name)? {
            LayerValues::F32(values) => Ok(values),
            LayerValues::U32(_) => Err(exception(format!("`{name}` is a layer of ids"))),
        }
    }

    /// A layer of ids, one a pixel.
    ///
    /// # Errors
    /// An exception for an unknown name, and for a layer of numbers.
    pub fn layer_ids(&self, name: &str) -> Result<Vec<u32>, JsError> {
        match (answers()?.layer)(self, name)? {
            LayerValues::U32(values) => Ok(values),
            LayerValues::F32(_) => Err(exception(format!("`{name}` is a layer of numbers"))),
        }
    }

    /// A layer as colours to look at, four bytes a pixel.
    ///
    /// # Errors
    /// An exception for an unknown name.
    pub fn layer_picture(&self, name: &str) -> Result<Vec<u8>, JsError> {
        (answers()?.layer_picture)(self, name)
    }

    /// Examines the model as it is seen here.
    ///
    /// # Errors
    /// An exception for a model without triangles.
    pub fn check(&self) -> Result<CheckedModel, JsError> {
        (answers()?.check)(self)
    }
}
