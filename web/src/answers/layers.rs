//! The layers of a picture, and the picture as a file.

use crate::error::exception;
use crate::view::ModelView;
use luxel::lighting::PictureEncoding;
use luxel::render::{
    Layer, LayerImage, LayerValues, Picture, PictureFormat, layer_rgb8, write_rgba8,
};
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

pub(super) fn png(view: &ModelView) -> Result<Vec<u8>, JsError> {
    let picture = view.renderer.rgba8(&view.view).map_err(exception)?;
    let Picture { size, pixels, .. } = &picture;
    let encoding: PictureEncoding = view.view.encoding;
    let mut bytes = Vec::new();
    write_rgba8(PictureFormat::Png, *size, pixels, encoding, &mut bytes).map_err(exception)?;
    Ok(bytes)
}
