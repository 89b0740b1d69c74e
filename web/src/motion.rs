//! Navigation: pointers and keys move the camera, and all of it is in a log.

use crate::answers::answers;
use crate::error::exception;
use crate::view::ModelView;
use luxel::navigation::{
    Change, Command, Entry, Event, Gesture, Log, Mode, Settings as Motion, StandardView, State,
    advance,
};
use luxel::scene::{DVec2, DVec3, Lens, Projection, Size, fit_planes};
use wasm_bindgen::prelude::*;

/// The mode that a view begins with.
pub(crate) const FIRST_MODE: Mode = Mode::Turntable;

#[wasm_bindgen]
impl ModelView {
    /// From world to camera coordinates: 16 numbers, column by column.
    #[wasm_bindgen(getter)]
    pub fn camera(&self) -> Vec<f64> {
        self.view.camera.view_from_world.to_cols_array().to_vec()
    }

    /// From camera to clip coordinates: 16 numbers, column by column.
    #[wasm_bindgen(getter)]
    pub fn projection(&self) -> Vec<f64> {
        self.view.camera.projection.clip_from_view(self.view.size).to_cols_array().to_vec()
    }

    /// The camera as settings: pairs of names and texts, one after the other. With them any view of the model has
    /// this camera.
    pub fn camera_settings(&self) -> Vec<String> {
        let join =
            |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        let (name, text) = match self.view.camera.projection.lens {
            Lens::Perspective { fov_y_radians } => ("fov", fov_y_radians.to_degrees().to_string()),
            Lens::Orthographic { height } => ("ortho", height.to_string()),
            Lens::Intrinsics { fx, fy, cx, cy } => ("intrinsics", join(&[fx, fy, cx, cy])),
        };
        ["view-matrix".to_owned(), join(&self.camera()), name.to_owned(), text].into()
    }

    /// Whether a hand has moved the camera since the settings chose it.
    #[wasm_bindgen(getter)]
    pub fn is_moved(&self) -> bool {
        self.is_moved
    }

    /// The navigation mode.
    #[wasm_bindgen(getter)]
    pub fn mode(&self) -> String {
        self.state.mode().to_string()
    }

    /// Whether the camera still moves by itself: a held key, inertia, the way to a standard view.
    #[wasm_bindgen(getter)]
    pub fn is_moving(&self) -> bool {
        self.state.is_moving()
    }

    /// A pointer goes down: `turn`, `pan` or `zoom` begins there.
    ///
    /// # Errors
    /// An exception for another word.
    pub fn grab(&mut self, gesture: &str, x: f64, y: f64) -> Result<(), JsError> {
        let gesture: Gesture = gesture.parse().map_err(exception)?;
        let point = self.point_at(x, y)?;
        self.happen(Event::Grab { gesture, at: DVec2::new(x, y), point }, 0.0);
        Ok(())
    }

    /// The pointer moves.
    pub fn drag(&mut self, x: f64, y: f64) {
        self.happen(Event::Drag { at: DVec2::new(x, y) }, 0.0);
    }

    /// The pointer goes up.
    pub fn release(&mut self) {
        self.happen(Event::Release, 0.0);
    }

    /// The wheel turns; positive notches zoom towards the point under the pointer.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn wheel(&mut self, notches: f64, x: f64, y: f64) -> Result<(), JsError> {
        let point = self.point_at(x, y)?;
        self.happen(Event::Wheel { notches, at: DVec2::new(x, y), point }, 0.0);
        Ok(())
    }

    /// A key: a command of luxel's navigation by its name, as in logs, some steps of it.
    ///
    /// # Errors
    /// An exception for an unknown name.
    pub fn tap(&mut self, command: &str, steps: f64) -> Result<(), JsError> {
        let command: Command = command.parse().map_err(exception)?;
        self.happen(Event::Tap { command, steps }, 0.0);
        Ok(())
    }

    /// Another navigation mode, by its name, as in logs.
    ///
    /// # Errors
    /// An exception for an unknown name.
    pub fn set_mode(&mut self, mode: &str) -> Result<(), JsError> {
        let mode: Mode = mode.parse().map_err(exception)?;
        self.happen(Event::Mode(mode), 0.0);
        Ok(())
    }

    /// A standard view: `front`, `back`, `left`, `right`, `top`, `bottom` or `isometric`.
    ///
    /// # Errors
    /// An exception for an unknown name.
    pub fn look_from(&mut self, name: &str) -> Result<(), JsError> {
        let view: StandardView = name.parse().map_err(exception)?;
        self.happen(Event::View(view), 0.0);
        Ok(())
    }

    /// Fits the model into the view.
    pub fn fit(&mut self) {
        self.happen(Event::Fit(None), 0.0);
    }

    /// The point about which the camera turns becomes the one under a point of the picture.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn turn_about(&mut self, x: f64, y: f64) -> Result<(), JsError> {
        if let Some(point) = self.point_at(x, y)? {
            self.happen(Event::Pivot(point), 0.0);
        }
        Ok(())
    }

    /// One line of a navigation log, as `press forward`; `seconds` have passed before.
    ///
    /// # Errors
    /// An exception for a line that isn't one.
    pub fn play(&mut self, line: &str, seconds: f64) -> Result<(), JsError> {
        let log: Log = format!("luxel-navigation 1\n{line}\n").parse().map_err(exception)?;
        for entry in log.entries {
            match entry {
                Entry::Set(change) => self.change(change),
                Entry::Event { seconds: before, event } => self.happen(event, before + seconds),
            }
        }
        Ok(())
    }

    /// The log of all that has moved the camera since the settings chose it: `luxel navigate --replay` plays it.
    pub fn log(&self) -> String {
        self.log.to_string()
    }

    /// Back to the first camera.
    pub fn home(&mut self) {
        self.view.camera = self.start.camera;
        self.rest();
    }
}

impl ModelView {
    /// The camera rests where the view has it.
    pub(crate) fn rest(&mut self) {
        let lens = self.view.camera.projection.lens;
        let up = self.choice.up.unwrap_or(self.model.up);
        self.motion = Motion::new(self.bounds, up, lens, self.view.size);
        let pivot = self.choice.pivot(self.renderer.scene());
        let camera = self.view.camera.view_from_world;
        self.state = State::new(self.state.mode(), &camera, pivot);
        self.is_moved = false;
        self.log = Log::default();
        self.log.entries.extend(Change::all_of(&self.motion).map(Entry::Set));
        for event in [Event::Mode(self.state.mode()), Event::Place(camera), Event::Pivot(pivot)] {
            self.log.entries.push(Entry::Event { seconds: 0.0, event });
        }
    }

    fn change(&mut self, change: Change) {
        self.motion = change.apply(&self.motion);
        self.log.entries.push(Entry::Set(change));
    }

    /// Moves the camera; near and far planes follow it.
    fn happen(&mut self, event: Event, seconds: f64) {
        self.state = advance(&self.state, &self.motion, &event, seconds);
        self.log.entries.push(Entry::Event { seconds, event });
        let view_from_world = self.state.view_from_world();
        self.is_moved |= view_from_world != self.view.camera.view_from_world;
        let lens = self.state.lens(self.motion.lens);
        let fitted = self.choice.with_planes(&self.bounds, view_from_world, lens);
        self.view.camera = fitted.unwrap_or_else(|_| {
            let (near, far) = fit_planes(&self.bounds, &view_from_world);
            luxel::scene::Camera { view_from_world, projection: Projection { lens, near, far } }
        });
    }

    /// The surface under a point of the window.
    fn point_at(&mut self, x: f64, y: f64) -> Result<Option<DVec3>, JsError> {
        let Size { width, height } = self.view.size;
        let is_inside =
            (0.0..f64::from(width)).contains(&x) && (0.0..f64::from(height)).contains(&y);
        if !is_inside {
            return Ok(None);
        }
        Ok((answers()?.hit_at)(self, [x, y])?.map(|hit| hit.position))
    }
}
