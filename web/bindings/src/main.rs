//! Writes the JavaScript that a browser loads a module with: `NAME.js`, `NAME_bg.wasm` and `NAME.d.ts`.
//!
//! ```text
//! luxel-web-bindings script|module|split NAME MODULE.wasm FOLDER
//! ```
//!
//! A script also runs in pages that are read from a disk, which may not start workers of modules. Of a module that is
//! split, what it marks as `answers` becomes `answers.wasm`, and `answers.js` links it.

mod split;

use std::error::Error;
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [kind, name, module, folder] = &arguments[..] else {
        return Err("usage: luxel-web-bindings script|module|split NAME MODULE.wasm FOLDER".into());
    };
    let module = std::fs::read(module).map_err(|error| format!("{module}: {error}"))?;
    let folder = Path::new(folder);
    std::fs::create_dir_all(folder)?;
    let module = match kind.as_str() {
        "split" => split::without_answers(&module, name, folder)?,
        _ => module,
    };
    let mut bindgen = Bindgen::new();
    bindgen.input_bytes(name, module).out_name(name).typescript(true);
    bindgen.remove_name_section(true).remove_producers_section(true);
    // What the parts of a split module share.
    bindgen.keep_lld_exports(kind == "split");
    match kind.as_str() {
        "script" => bindgen.no_modules(true)?,
        "module" | "split" => bindgen.web(true)?,
        other => return Err(format!("`{other}` is none of script, module, split").into()),
    };
    bindgen.omit_default_module_path(true);
    bindgen.generate(folder)?;
    Ok(())
}
