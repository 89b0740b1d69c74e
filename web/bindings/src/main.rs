//! Writes the JavaScript that a browser loads the module with: `luxel.js` and `luxel_bg.wasm` beside it.
//!
//! ```text
//! luxel-web-bindings MODULE.wasm FOLDER
//! ```

use std::error::Error;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, folder] = &arguments[..] else {
        return Err("usage: luxel-web-bindings MODULE.wasm FOLDER".into());
    };
    let mut bindgen = Bindgen::new();
    bindgen.input_path(module).out_name("luxel").typescript(true);
    bindgen.remove_name_section(true).remove_producers_section(true);
    // A script, since pages that are read from a disk may not start workers of modules.
    bindgen.no_modules(true)?.omit_default_module_path(true);
    bindgen.generate(folder)?;
    Ok(())
}
