//! Handles of lights in the picture, and lights that are moved by them.

use crate::error::exception;
use crate::view::ModelView;
use luxel::formats::values;
use luxel::light_editing::{DirectionSphere, HandleKind, HandleView, LightHandle, LightSpaces};
use luxel::scene::{DVec2, SceneLight, Size};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl ModelView {
    /// The handles of lights, which are given as texts of `--light`: for each a list of JSON objects with `kind`
    /// (`position`, `target` or `direction`), `place` in pixels of the picture and `is_near`, which is false on the far
    /// side of the sphere of directions.
    ///
    /// # Errors
    /// An exception for a text that is no light.
    pub fn light_handles(&self, lights: Vec<String>) -> Result<String, JsError> {
        let all = lights.iter().map(|text| {
            let light = self.light(text)?;
            let handles = self.handles_of(&light).into_iter();
            Ok(handles.map(|handle| described(&handle)).collect::<Value>())
        });
        Ok(all.collect::<Result<Value, JsError>>()?.to_string())
    }

    /// A light of which a handle is moved to a place of the picture: its position and its direction, six numbers in
    /// its own coordinates; nothing if it has no such handle, or no point is there.
    ///
    /// # Errors
    /// An exception for a text that is no light.
    pub fn move_light(
        &self,
        light: &str,
        kind: &str,
        x: f64,
        y: f64,
        is_near: bool,
    ) -> Result<Option<Vec<f64>>, JsError> {
        let mut light = self.light(light)?;
        let (spaces, to) = (self.light_spaces(), DVec2::new(x, y));
        let pose = spaces.world_pose(&light);
        let handle = self.handles_of(&light).into_iter().find(|handle| name_of(handle) == kind);
        let moved =
            handle.and_then(|handle| self.handle_view().moved(handle.kind, to, is_near, pose));
        Ok(moved.map(|pose| {
            spaces.set_world_pose(&mut light, pose);
            [light.position.to_array(), light.direction.to_array()].concat()
        }))
    }
}

impl ModelView {
    fn light(&self, text: &str) -> Result<SceneLight, JsError> {
        values::light(text).map(|light| light.named(0)).map_err(exception)
    }

    /// Texts of lights place them in the world or on the camera.
    fn light_spaces(&self) -> LightSpaces<'static> {
        let view_from_world = self.view.camera.view_from_world;
        LightSpaces { view_from_world, world_from_nodes: &[] }
    }

    fn handle_view(&self) -> HandleView<'_> {
        let size @ Size { width, height } = self.view.size;
        let [width, height] = [width, height].map(f64::from);
        let sphere = DirectionSphere::within(DVec2::new(width, height) * 0.5, width, height);
        HandleView { camera: &self.view.camera, size, pivot: self.state.pivot(), sphere }
    }

    fn handles_of(&self, light: &SceneLight) -> Vec<LightHandle> {
        let pose = self.light_spaces().world_pose(light);
        self.handle_view().handles(light.light.kind, pose)
    }
}

fn name_of(handle: &LightHandle) -> &'static str {
    match handle.kind {
        HandleKind::Position(_) => "position",
        HandleKind::Target(_) => "target",
        HandleKind::Direction(_) => "direction",
    }
}

fn described(handle: &LightHandle) -> Value {
    json!({
        "kind": name_of(handle),
        "place": handle.place.to_array(),
        "is_near": handle.is_near(),
    })
}
