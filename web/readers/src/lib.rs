//! luxel's readers of model files in WebAssembly, and its writer of pictures: a module of its own, so that a page that
//! neither opens nor saves a file fetches none of it.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

use luxel::formats::{Error, GivenFiles, Limits, Loaded, Warning, open, open_environment};
use luxel::lighting::PictureEncoding;
use luxel::render::{PictureFormat, write_rgba8};
use luxel::scene::Size;
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

/// What was read of a file, packed for the module that draws.
#[wasm_bindgen]
pub struct Packed {
    bytes: Vec<u8>,
    warnings: String,
}

#[wasm_bindgen]
impl Packed {
    /// The scene, or the map of an environment.
    pub fn take_bytes(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.bytes)
    }

    /// What is odd in the file: a JSON list of texts.
    #[wasm_bindgen(getter)]
    pub fn warnings(&self) -> String {
        self.warnings.clone()
    }
}

impl Packed {
    fn new(bytes: Vec<u8>, warnings: &[Warning]) -> Self {
        let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        Self { bytes, warnings: serde_json::Value::from(texts).to_string() }
    }
}

/// Reads a model; the extension of its path decides the format. `max_memory` bounds the bytes that it may take.
///
/// # Errors
/// An exception with the place in the file, if it is damaged or exceeds the limit.
#[wasm_bindgen]
pub fn read(path: &str, files: Files, max_memory: f64) -> Result<Packed, JsError> {
    // The files are no longer needed after it: packing takes as much memory.
    let Loaded { scene, warnings, .. } =
        within(files, max_memory, |limits| open(Path::new(path), limits))?;
    Ok(Packed::new(luxel::pack(&scene), &warnings))
}

/// Reads a picture of an environment, HDR or EXR; its path is the map's name. `max_memory` bounds the bytes that it may
/// take.
///
/// # Errors
/// An exception with the place in the file, if it is damaged or exceeds the limit.
#[wasm_bindgen]
pub fn read_environment(path: &str, files: Files, max_memory: f64) -> Result<Packed, JsError> {
    let loaded = within(files, max_memory, |limits| open_environment(Path::new(path), limits))?;
    Ok(Packed::new(luxel::pack_map(&loaded.map), &loaded.warnings))
}

/// A picture as a PNG file, with the bytes that the program writes: four bytes a pixel, rows from the top; encoded as
/// sRGB, or linear.
///
/// # Errors
/// An exception if `pixels` are not those of `width` x `height`.
#[wasm_bindgen]
pub fn write_png(
    width: u32,
    height: u32,
    is_srgb: bool,
    pixels: &[u8],
) -> Result<Vec<u8>, JsError> {
    let encoding = if is_srgb { PictureEncoding::Srgb } else { PictureEncoding::None };
    let (pixels, []) = pixels.as_chunks() else {
        return Err(JsError::new("pixels have four bytes each"));
    };
    let mut bytes = Vec::new();
    write_rgba8(PictureFormat::Png, Size { width, height }, pixels, encoding, &mut bytes)
        .map_err(|error| JsError::new(&error.to_string()))?;
    Ok(bytes)
}

fn within<T>(
    files: Files,
    max_memory: f64,
    read: impl FnOnce(&Limits) -> Result<T, Error>,
) -> Result<T, JsError> {
    let limits = Limits {
        max_memory: max_memory as u64,
        given: Some(GivenFiles::new(files.0)),
        ..Limits::default()
    };
    read(&limits).map_err(|error| JsError::new(&error.to_string()))
}
