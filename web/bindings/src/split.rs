//! Takes the part that answers out of a module.

use std::error::Error;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use walrus::{ModuleConfig, RawCustomSection};
use wasm_split_cli_support::{Options, transform};

/// Writes `answers.wasm`, `answers.js` and `answers.d.ts`, and returns the rest of the module.
///
/// The module has to have its relocations (`--emit-relocs`) and its names.
///
/// # Errors
/// If nothing is marked as `answers`, more than that is, or a file can't be written.
pub fn without_answers(
    module: &[u8],
    name: &str,
    folder: &Path,
) -> Result<Vec<u8>, Box<dyn Error>> {
    let parts = folder.join("parts");
    let rest = parts.join("rest.wasm");
    let drawing = format!("./{name}.js");
    let mut options = Options::new(module);
    options.output_dir = &parts;
    options.main_out_path = &rest;
    options.link_name = "./answers.js";
    options.main_module = &drawing;
    let split = transform(options).map_err(|error| format!("can't split: {error:#}"))?;
    let [answers] = &split.split_modules[..] else {
        return Err(format!("split in {} parts", split.split_modules.len()).into());
    };
    let mut hasher = DefaultHasher::new();
    module.hash(&mut hasher);
    let build = format!("{:016x}", hasher.finish());
    // Written anew, numbers are as short as they can be.
    let mut config = ModuleConfig::new();
    config.generate_name_section(false).generate_producers_section(false);
    let mut answers = config.parse_file(answers)?;
    // Linked to another build, it would write anywhere.
    let data = build.clone().into_bytes();
    answers.customs.add(RawCustomSection { name: "luxel-build".to_owned(), data });
    answers.emit_wasm_file(folder.join("answers.wasm"))?;
    // The script that comes with the split fetches by itself; this one is given what was compiled.
    let script =
        include_str!("answers.js").replace("{drawing}", &drawing).replace("{build}", &build);
    std::fs::write(folder.join("answers.js"), script)?;
    std::fs::write(folder.join("answers.d.ts"), include_str!("answers.d.ts"))?;
    let rest = std::fs::read(rest)?;
    std::fs::remove_dir_all(parts)?;
    Ok(rest)
}
