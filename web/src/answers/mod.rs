//! What answers questions about a view: what is under a pixel, why it has its colour, and its layers.
//!
//! With the feature `split`, what is in this folder, with all that only it calls, becomes a module of its own, so that
//! a page draws before it has arrived. Both share memory, functions and the state of views.

mod check;
mod explain;
mod layers;
mod ledger;
#[cfg(feature = "split")]
mod link;
mod picks;

pub(crate) use explain::Format;
#[cfg(feature = "split")]
pub(crate) use link::answers;
#[cfg(feature = "split")]
pub use link::link_answers;

use crate::questions::CheckedModel;
use crate::view::ModelView;
use luxel::pick::PickHit;
use luxel::render::LayerValues;
use wasm_bindgen::JsError;

/// The way from the module that draws to the functions here: none of them is called by its name outside.
pub(crate) struct Answers {
    pub(crate) check: fn(&ModelView) -> Result<CheckedModel, JsError>,
    pub(crate) explain: fn(&ModelView, [u32; 2], Format) -> Result<String, JsError>,
    pub(crate) layer: fn(&ModelView, &str) -> Result<LayerValues, JsError>,
    pub(crate) layer_picture: fn(&ModelView, &str) -> Result<Vec<u8>, JsError>,
    pub(crate) ledger: fn(&ModelView, [u32; 2]) -> Result<String, JsError>,
    pub(crate) hit_at: fn(&mut ModelView, [f64; 2]) -> Result<Option<PickHit>, JsError>,
    pub(crate) pick: fn(&mut ModelView, [f64; 2]) -> Result<Option<String>, JsError>,
    pub(crate) pick_json: fn(&mut ModelView, [f64; 2], bool) -> Result<String, JsError>,
    pub(crate) pick_rect: fn(&mut ModelView, [f64; 4], bool) -> Result<String, JsError>,
}

static ANSWERS: Answers = Answers {
    check: check::check,
    explain: explain::explain,
    layer: layers::layer,
    layer_picture: layers::layer_picture,
    ledger: ledger::ledger,
    hit_at: picks::hit_at,
    pick: picks::pick,
    pick_json: picks::pick_json,
    pick_rect: picks::pick_rect,
};

/// What answers, in the same module.
#[cfg(not(feature = "split"))]
pub(crate) fn answers() -> Result<&'static Answers, JsError> {
    Ok(&ANSWERS)
}
