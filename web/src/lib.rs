//! luxel in WebAssembly: a view of a model that turns under the hand and explains its pixels.
//!
//! Pictures have the same bytes as those of the program. Nothing is fetched and nothing is sent.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

use luxel::navigation::{Command, Event, Gesture, Mode, Settings, State, advance};
use luxel::pick::{PickView, Picker};
use luxel::render::{At, Execution, Renderer, Unseen, View};
use luxel::report::Report;
use luxel::scene::{Bounds, DVec2, DVec3, Projection, Size, fit_planes};
use std::fmt::Display;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// A model seen by a camera that pointers and keys move.
#[wasm_bindgen]
pub struct ModelView {
    renderer: Renderer,
    picker: Option<Picker>,
    bounds: Bounds,
    /// The view that `home` goes back to.
    start: View,
    view: View,
    settings: Settings,
    state: State,
}

/// An exception with a message.
fn exception(error: impl Display) -> JsError {
    JsError::new(&error.to_string())
}

#[wasm_bindgen]
impl ModelView {
    /// The view of a scene, both packed by the same version of luxel.
    ///
    /// # Errors
    /// An exception for other bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(scene: &[u8], view: &[u8]) -> Result<Self, JsError> {
        let scene = Arc::new(luxel::unpack(scene).map_err(exception)?);
        let view = luxel::unpack_view(view).map_err(exception)?;
        let renderer =
            Renderer::new(Arc::clone(&scene), &Execution::default()).map_err(exception)?;
        let bounds = scene.bounds();
        let settings = Settings::new(bounds, scene.up, view.camera.projection.lens, view.size);
        let pivot = if bounds.is_empty() { DVec3::ZERO } else { bounds.centre() };
        let state = State::new(Mode::Turntable, &view.camera.view_from_world, pivot);
        Ok(Self { renderer, picker: None, bounds, start: view.clone(), view, settings, state })
    }

    /// The picture's width in pixels.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.view.size.width
    }

    /// The picture's height in pixels.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.view.size.height
    }

    /// From world to camera coordinates: 16 numbers, column by column.
    #[wasm_bindgen(getter)]
    pub fn camera(&self) -> Vec<f64> {
        self.view.camera.view_from_world.to_cols_array().to_vec()
    }

    /// The picture, four bytes a pixel, rows from the top. `samples` a pixel; 0 for the view's own.
    ///
    /// # Errors
    /// An exception for other numbers of samples than 0, 1, 2, 4, 8 and 16.
    pub fn draw(&self, samples: u32) -> Result<Vec<u8>, JsError> {
        let mut view = self.view.clone();
        if samples != 0 {
            view.samples = samples;
        }
        let picture = self.renderer.rgba8(&view).map_err(exception)?;
        Ok(picture.pixels.into_flattened())
    }

    /// Whether the view casts rays for shadows or occlusion, which takes its time.
    #[wasm_bindgen(getter)]
    pub fn has_rays(&self) -> bool {
        self.view.shadows || self.view.ground || self.view.ambient_occlusion.is_some()
    }

    /// The picture with one sample, without shadows and occlusion: quick, for a moving hand.
    ///
    /// # Errors
    /// None that could be named.
    pub fn draft(&self) -> Result<Vec<u8>, JsError> {
        let mut view = self.view.clone();
        view.samples = 1;
        view.shadows = false;
        view.ground = false;
        view.ambient_occlusion = None;
        let picture = self.renderer.rgba8(&view).map_err(exception)?;
        Ok(picture.pixels.into_flattened())
    }

    /// A pointer goes down: `turn`, `pan` or `zoom` begins there.
    ///
    /// # Errors
    /// An exception for another word.
    pub fn grab(&mut self, gesture: &str, x: f64, y: f64) -> Result<(), JsError> {
        let gesture = match gesture {
            "turn" => Gesture::Turn,
            "pan" => Gesture::Pan,
            "zoom" => Gesture::Zoom,
            other => return Err(exception(format!("`{other}` is none of turn, pan, zoom"))),
        };
        let point = self.point_at(x, y)?;
        self.happen(&Event::Grab { gesture, at: DVec2::new(x, y), point });
        Ok(())
    }

    /// The pointer moves.
    pub fn drag(&mut self, x: f64, y: f64) {
        self.happen(&Event::Drag { at: DVec2::new(x, y) });
    }

    /// The pointer goes up.
    pub fn release(&mut self) {
        self.happen(&Event::Release);
    }

    /// The wheel turns; positive notches zoom towards the point under the pointer.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn wheel(&mut self, notches: f64, x: f64, y: f64) -> Result<(), JsError> {
        let point = self.point_at(x, y)?;
        self.happen(&Event::Wheel { notches, at: DVec2::new(x, y), point });
        Ok(())
    }

    /// A key: a command of luxel's navigation by its name, as in logs, some steps of it.
    ///
    /// # Errors
    /// An exception for an unknown name.
    pub fn tap(&mut self, command: &str, steps: f64) -> Result<(), JsError> {
        let command: Command = command.parse().map_err(exception)?;
        self.happen(&Event::Tap { command, steps });
        Ok(())
    }

    /// Back to the first camera.
    pub fn home(&mut self) {
        self.view.camera = self.start.camera;
        let pivot = if self.bounds.is_empty() { DVec3::ZERO } else { self.bounds.centre() };
        self.state = State::new(Mode::Turntable, &self.view.camera.view_from_world, pivot);
    }

    /// The object under a point of the picture, by its name; nothing where the background is.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn pick(&mut self, x: f64, y: f64) -> Result<Option<String>, JsError> {
        let view = self.view.clone();
        let hit = self.with_picks(&view, |picks| picks.at([x, y]))?;
        let scene = self.renderer.scene();
        let object = hit.and_then(|hit| scene.objects().into_iter().nth(hit.object));
        Ok(object.map(|object| scene.nodes[object.node.index()].name.clone()))
    }

    /// Why a pixel has its colour: the text of `luxel explain`.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain(&self, x: u32, y: u32) -> Result<String, JsError> {
        self.report(x, y, |report| report.to_text())
    }

    /// The same as JSON, as `luxel explain --json` prints it.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain_json(&self, x: u32, y: u32) -> Result<String, JsError> {
        self.report(x, y, |report| report.to_json().to_string())
    }
}

impl ModelView {
    fn report(
        &self,
        x: u32,
        y: u32,
        text: impl Fn(&Report<'_>) -> String,
    ) -> Result<String, JsError> {
        let explanation =
            self.renderer.explain(&self.view, At::Pixel([x, y])).map_err(exception)?;
        let unseen = Unseen::new(&self.renderer, &self.view, &explanation).map_err(exception)?;
        let report = Report::new(&explanation, self.renderer.scene(), &self.view);
        Ok(text(&report.with_unseen(&unseen)))
    }

    /// Moves the camera; near and far planes follow it.
    fn happen(&mut self, event: &Event) {
        self.state = advance(&self.state, &self.settings, event, 0.0);
        let view_from_world = self.state.view_from_world();
        let (near, far) = fit_planes(&self.bounds, &view_from_world);
        let lens = self.state.lens(self.settings.lens);
        self.view.camera.view_from_world = view_from_world;
        self.view.camera.projection = Projection { lens, near, far };
    }

    /// The surface under a point of the window.
    fn point_at(&mut self, x: f64, y: f64) -> Result<Option<DVec3>, JsError> {
        let view = self.view.clone();
        let Size { width, height } = view.size;
        let is_inside =
            (0.0..f64::from(width)).contains(&x) && (0.0..f64::from(height)).contains(&y);
        if !is_inside {
            return Ok(None);
        }
        let hit = self.with_picks(&view, |picks| picks.at([x, y]))?;
        Ok(hit.map(|hit| hit.position))
    }

    fn with_picks<T>(
        &mut self,
        view: &View,
        work: impl FnOnce(&PickView<'_>) -> T,
    ) -> Result<T, JsError> {
        if self.picker.is_none() {
            let scene = Arc::clone(self.renderer.scene());
            self.picker = Some(Picker::new(scene).map_err(exception)?);
        }
        let Some(picker) = &self.picker else { return Err(exception("no picker")) };
        let picks = PickView::new(picker, view.camera, view.size, view.cull).map_err(exception)?;
        Ok(work(&picks))
    }
}
