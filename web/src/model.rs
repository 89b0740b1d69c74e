//! Models: scenes that were read, or are built in.

use crate::describe::describe;
use crate::error::exception;
use luxel::lighting::EnvironmentMap;
use luxel::scene::{Scene, demos};
use serde_json::{Value, json};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// A scene in memory, from which views are made.
#[wasm_bindgen]
pub struct Model {
    scene: Arc<Scene>,
    warnings: Vec<String>,
    environments: Environments,
}

/// The maps that settings may name as environments, by the names of their files: those of a model and of its views.
pub(crate) type Environments = Rc<RefCell<BTreeMap<String, Arc<EnvironmentMap>>>>;

#[wasm_bindgen]
impl Model {
    /// A scene that the readers' module packed; `warnings` is a JSON list of texts.
    ///
    /// # Errors
    /// An exception for other bytes.
    pub fn unpack(scene: &[u8], warnings: &str) -> Result<Self, JsError> {
        let scene = Arc::new(luxel::unpack(scene).map_err(exception)?);
        let warnings = serde_json::from_str(warnings).map_err(exception)?;
        Ok(Self { scene, warnings, environments: Environments::default() })
    }

    /// A built-in scene.
    ///
    /// # Errors
    /// An exception for an unknown name.
    pub fn demo(name: &str) -> Result<Self, JsError> {
        let Some(scene) = demos::demo(name) else {
            let names: Vec<_> = demos::names().into_iter().map(|(name, _)| name).collect();
            return Err(exception(format!("there is no demo `{name}`: use {}", names.join(", "))));
        };
        Ok(Self {
            scene: Arc::new(scene),
            warnings: Vec::new(),
            environments: Environments::default(),
        })
    }

    /// The built-in scenes: a JSON list of `name` and `about`.
    pub fn demos() -> String {
        let demo = |(name, about): (&str, &str)| json!({ "name": name, "about": about });
        Value::from_iter(demos::names().into_iter().map(demo)).to_string()
    }

    /// Adds a map that the readers' module packed: the setting `environment` may have its name, which comes back.
    ///
    /// # Errors
    /// An exception for other bytes.
    pub fn add_environment(&self, map: &[u8]) -> Result<String, JsError> {
        let map = luxel::unpack_map(map).map_err(exception)?;
        let name = map.name().to_owned();
        self.environments.borrow_mut().insert(name.clone(), Arc::new(map));
        Ok(name)
    }

    /// What is in it, as JSON: counts, bounds, objects, materials, lights, cameras, warnings.
    pub fn describe(&self) -> String {
        describe(&self.scene, &self.warnings).to_string()
    }
}

impl Model {
    pub(crate) fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    pub(crate) fn environments(&self) -> &Environments {
        &self.environments
    }
}
