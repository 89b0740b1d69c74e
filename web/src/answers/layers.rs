//! The layers of a picture.

use crate::error::exception;
use crate::view::ModelView;
use luxel::render::{Layer, LayerImage, LayerValues, layer_rgb8};
use wasm_bindgen::JsError;

pub(super) fn layer(view: &ModelView, name: &str) -> Result<LayerValues, JsError> {
    values_of(view, &name.parse().map_err(exception)?)
}

pub(super) fn layer_picture(view: &ModelView, name: &str) -> Result<Vec<u8>, JsError> {
    let layer: Layer = name.parse().map_err(exception)?;
    let values = values_of(view, &layer)?;
    let image = LayerImage { name: layer.name(), channels: layer.channels(), values };
    Ok(layer_rgb8(&image).into_iter().flat_map(|[r, g, b]| [r, g, b, 255]).collect())
}

fn values_of(view: &ModelView, layer: &Layer) -> Result<LayerValues, JsError> {
    let values =
        view.renderer.layers(&view.view, std::slice::from_ref(layer)).map_err(exception)?;
    values.into_iter().next().ok_or_else(|| exception("no layer"))
}
