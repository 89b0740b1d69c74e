//! Shares of pictures, drawn by several workers side by side.

use crate::error::exception;
use crate::view::{ModelView, execution};
use luxel::render::{Picture, Renderer, TILE_SIDE, View};
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// A scene that another worker's view shows, drawn for it.
#[wasm_bindgen]
pub struct Drawer(Renderer);

#[wasm_bindgen]
impl Drawer {
    /// A scene of [`ModelView::pack_scene`] without some of its objects.
    ///
    /// # Errors
    /// An exception for other bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(scene: &[u8], hidden: Vec<u32>) -> Result<Self, JsError> {
        let scene = Arc::new(luxel::unpack(scene).map_err(exception)?);
        let mut renderer = Renderer::new(scene, &execution()).map_err(exception)?;
        show_all_but(&mut renderer, &hidden);
        Ok(Self(renderer))
    }

    /// A share of the picture of a view of [`ModelView::pack`]: of rows of tiles, which are 64 pixels high, every
    /// `parts`-th from number `part` on, one below the other.
    ///
    /// # Errors
    /// An exception for other bytes, and for a picture that is too large.
    pub fn draw_part(&self, view: &[u8], part: usize, parts: usize) -> Result<Vec<u8>, JsError> {
        draw_part(&self.0, view, part, parts)
    }
}

#[wasm_bindgen]
impl ModelView {
    /// As [`Drawer::draw_part`].
    ///
    /// # Errors
    /// As there.
    pub fn draw_part(&self, view: &[u8], part: usize, parts: usize) -> Result<Vec<u8>, JsError> {
        draw_part(&self.renderer, view, part, parts)
    }

    /// The view as it is now, for drawers: with another number of samples than its own if that isn't 0; a draft has
    /// one and casts no rays.
    pub fn pack(&self, is_draft: bool, samples: u32) -> Vec<u8> {
        luxel::pack_view(&if is_draft { self.draft_view() } else { self.sampled(samples) })
    }

    /// The scene with the settings' materials and normals, for drawers.
    pub fn pack_scene(&self) -> Vec<u8> {
        luxel::pack(self.renderer.scene())
    }
}

/// Draws all objects of the scene but those with these numbers.
pub(crate) fn show_all_but(renderer: &mut Renderer, hidden: &[u32]) {
    let objects = renderer.scene().objects().into_iter().enumerate();
    let shown = objects.filter(|(at, _)| !hidden.contains(&(*at as u32)));
    renderer.show_objects(shown.map(|(_, object)| object).collect());
}

fn draw_part(
    renderer: &Renderer,
    view: &[u8],
    part: usize,
    parts: usize,
) -> Result<Vec<u8>, JsError> {
    let view: View = luxel::unpack_view(view).map_err(exception)?;
    let parts = parts.max(1);
    let width = view.size.width as usize;
    let across = width.div_ceil(TILE_SIDE as usize);
    let is_mine = |tile: usize| (tile / across) % parts == part;
    let mut picture = Picture::default();
    renderer.rgba8_tiles_into(&view, is_mine, &mut picture).map_err(exception)?;
    if parts == 1 {
        return Ok(picture.pixels.into_flattened());
    }
    let bands = picture.pixels.chunks(TILE_SIDE as usize * width).skip(part).step_by(parts);
    Ok(bands.flat_map(|band| band.as_flattened()).copied().collect())
}
