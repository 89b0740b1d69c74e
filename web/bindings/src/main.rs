//! Writes the JavaScript that a browser loads a module with: `NAME.js`, `NAME_bg.wasm` and `NAME.d.ts`.
//!
//! ```text
//! luxel-web-bindings script|module NAME MODULE.wasm FOLDER
//! ```
//!
//! A script also runs in pages that are read from a disk, which may not start workers of modules.

use std::error::Error;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [kind, name, module, folder] = &arguments[..] else {
        return Err("usage: luxel-web-bindings script|module NAME MODULE.wasm FOLDER".into());
    };
    let mut bindgen = Bindgen::new();
    bindgen.input_path(module).out_name(name).typescript(true);
    bindgen.remove_name_section(true).remove_producers_section(true);
    match kind.as_str() {
        "script" => bindgen.no_modules(true)?,
        "module" => bindgen.web(true)?,
        other => return Err(format!("`{other}` is neither script nor module").into()),
    };
    bindgen.omit_default_module_path(true);
    bindgen.generate(folder)?;
    Ok(())
}
