//! Exceptions.

use std::fmt::Display;
use wasm_bindgen::prelude::*;

/// An exception with a message.
pub(crate) fn exception(error: impl Display) -> JsError {
    JsError::new(&error.to_string())
}

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
