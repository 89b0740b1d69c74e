//! luxel's readers of model files in WebAssembly, a module of its own: a page that opens no file fetches none.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

use luxel::formats::{GivenFiles, Limits, Loaded, open};
use std::path::{Path, PathBuf};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = console, js_name = error)]
    fn console_error(message: &str);
}

/// Tells the console where a panic was, before the module ends.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|panic| console_error(&format!("luxel: {panic}"))));
}

/// Files in memory: a model and what it refers to.
#[wasm_bindgen]
#[derive(Default)]
pub struct Files(Vec<(PathBuf, Vec<u8>)>);

#[wasm_bindgen]
impl Files {
    /// No files.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file by its path, with `/` between folders.
    pub fn add(&mut self, path: &str, bytes: Vec<u8>) {
        self.0.push((path.into(), bytes));
    }
}

/// A model that was read, packed for the module that draws.
#[wasm_bindgen]
pub struct ReadModel {
    scene: Vec<u8>,
    warnings: String,
}

#[wasm_bindgen]
impl ReadModel {
    /// The scene.
    pub fn take_scene(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.scene)
    }

    /// What is odd in the file: a JSON list of texts.
    #[wasm_bindgen(getter)]
    pub fn warnings(&self) -> String {
        self.warnings.clone()
    }
}

/// Reads a model; the extension of its path decides the format. `max_memory` bounds the bytes that it may take.
///
/// # Errors
/// An exception with the place in the file, if it is damaged or exceeds the limit.
#[wasm_bindgen]
pub fn read(path: &str, files: Files, max_memory: f64) -> Result<ReadModel, JsError> {
    let limits = Limits {
        max_memory: max_memory as u64,
        given: Some(GivenFiles::new(files.0)),
        ..Limits::default()
    };
    let loaded = open(Path::new(path), &limits);
    let Loaded { scene, warnings, .. } =
        loaded.map_err(|error| JsError::new(&error.to_string()))?;
    // The files are no longer needed, and packing takes as much memory.
    drop(limits);
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    let warnings = serde_json::Value::from(warnings).to_string();
    Ok(ReadModel { scene: luxel::pack(&scene), warnings })
}
