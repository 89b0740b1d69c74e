//! Shares of pictures, drawn by several workers side by side.

use crate::error::exception;
use crate::view::{ModelView, draft, execution, sampled};
use luxel::lighting::{EnvironmentMap, OrientedMap};
use luxel::render::{Picture, Renderer, TILE_SIDE, View};
use std::cell::RefCell;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Bytes of a picture, in memory that JavaScript holds and uses again.
    #[wasm_bindgen(js_name = Uint8ClampedArray)]
    pub type Pixels;

    #[wasm_bindgen(method, catch)]
    fn set(this: &Pixels, bytes: &[u8], at: usize) -> Result<(), JsValue>;
}

/// A scene that another worker's view shows, drawn for it.
#[wasm_bindgen]
pub struct Drawer {
    renderer: Renderer,
    map: Option<Arc<EnvironmentMap>>,
}

#[wasm_bindgen]
impl Drawer {
    /// A scene of [`ModelView::pack_scene`] without some of its objects, and the map of [`ModelView::pack_map`].
    ///
    /// # Errors
    /// An exception for other bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(scene: &[u8], hidden: Vec<u32>, map: Option<Vec<u8>>) -> Result<Self, JsError> {
        let scene = Arc::new(luxel::unpack(scene).map_err(exception)?);
        let mut renderer = Renderer::new(scene, &execution()).map_err(exception)?;
        show_all_but(&mut renderer, &hidden);
        let map = map.map(|map| luxel::unpack_map(&map)).transpose().map_err(exception)?;
        Ok(Self { renderer, map: map.map(Arc::new) })
    }

    /// Draws a share of the picture of a view of [`ModelView::pack`] into `pixels`: of rows of tiles, which are 64
    /// pixels high, every `parts`-th from number `part` on, one below the other. A draft has one sample and casts no
    /// rays; other pictures have the view's `samples` if these are 0.
    ///
    /// # Errors
    /// An exception for other bytes, for a picture that is too large, and for too few `pixels`.
    pub fn draw_part(
        &self,
        view: &[u8],
        is_draft: bool,
        samples: u32,
        part: usize,
        parts: usize,
        pixels: &Pixels,
    ) -> Result<(), JsError> {
        let view = chosen(view, self.map.as_ref(), is_draft, samples)?;
        draw_part(&self.renderer, &view, (part, parts), pixels)
    }
}

#[wasm_bindgen]
impl ModelView {
    /// As [`Drawer::draw_part`].
    ///
    /// # Errors
    /// As there.
    pub fn draw_part(
        &self,
        view: &[u8],
        is_draft: bool,
        samples: u32,
        part: usize,
        parts: usize,
        pixels: &Pixels,
    ) -> Result<(), JsError> {
        let map = self.view.environment.map().map(OrientedMap::map);
        draw_part(&self.renderer, &chosen(view, map, is_draft, samples)?, (part, parts), pixels)
    }

    /// The view as it is now but for the map of its environment, for drawers.
    pub fn pack(&self) -> Vec<u8> {
        luxel::pack_view_without_map(&self.view)
    }

    /// The scene with the settings' materials and normals, for drawers.
    pub fn pack_scene(&self) -> Vec<u8> {
        luxel::pack(self.renderer.scene())
    }

    /// The map of the view's environment, for drawers, if it has one.
    pub fn pack_map(&self) -> Option<Vec<u8>> {
        self.view.environment.map().map(|map| luxel::pack_map(map.map()))
    }
}

/// Draws all objects of the scene but those with these numbers.
pub(crate) fn show_all_but(renderer: &mut Renderer, hidden: &[u32]) {
    let objects = renderer.scene().objects().into_iter().enumerate();
    let shown = objects.filter(|(at, _)| !hidden.contains(&(*at as u32)));
    renderer.show_objects(shown.map(|(_, object)| object).collect());
}

thread_local! {
    /// What the views of this worker are drawn into, one after the other: fresh memory costs a quarter of a frame.
    static PICTURE: RefCell<Picture<[u8; 4]>> = RefCell::default();
}

/// A packed view with the map that it lacks, as a draft or with other samples.
fn chosen(
    view: &[u8],
    map: Option<&Arc<EnvironmentMap>>,
    is_draft: bool,
    samples: u32,
) -> Result<View, JsError> {
    let view = luxel::unpack_view_with_map(view, map).map_err(exception)?;
    Ok(if is_draft { draft(view) } else { sampled(view, samples) })
}

fn draw_part(
    renderer: &Renderer,
    view: &View,
    (part, parts): (usize, usize),
    pixels: &Pixels,
) -> Result<(), JsError> {
    let parts = parts.max(1);
    let width = view.size.width as usize;
    let across = width.div_ceil(TILE_SIDE as usize);
    let is_mine = |tile: usize| (tile / across) % parts == part;
    PICTURE.with_borrow_mut(|picture| {
        renderer.rgba8_tiles_into(view, is_mine, picture).map_err(exception)?;
        if parts == 1 {
            return pixels.set(picture.pixels.as_flattened(), 0).map_err(too_few);
        }
        let mut at = 0;
        for band in picture.pixels.chunks(TILE_SIDE as usize * width).skip(part).step_by(parts) {
            pixels.set(band.as_flattened(), at).map_err(too_few)?;
            at += band.as_flattened().len();
        }
        Ok(())
    })
}

fn too_few(_: JsValue) -> JsError {
    JsError::new("the picture is larger than the memory given for it")
}
