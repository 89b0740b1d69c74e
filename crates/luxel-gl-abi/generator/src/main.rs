//! Writes `src/generated` of `luxel-gl-abi`: the 1292 `gl*` entry points of libOSMesa.so.8.
//!
//! ```text
//! cargo run --manifest-path crates/luxel-gl-abi/generator/Cargo.toml
//! cargo run --manifest-path crates/luxel-gl-abi/generator/Cargo.toml -- --check
//! ```
//!
//! Three inputs: the registry (`gl.xml` of the crate `khronos_api`) has the prototypes, `names.txt` the
//! names to export, `commands.toml` says how a command is carried out. A name that `commands.toml` leaves
//! out is an alias of one that it has, or it sets GL_INVALID_OPERATION. `--check` writes nothing and fails
//! if a file would change.

mod plan;
mod registry;
mod types;
mod variants;
mod write;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let check = match std::env::args().nth(1).as_deref() {
        None => false,
        Some("--check") => true,
        Some(other) => {
            eprintln!("{other} is not an option: there is --check alone");
            return ExitCode::from(2);
        }
    };
    match run(check) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run(check: bool) -> Result<(), String> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read =
        |name: &str| fs::read_to_string(own.join(name)).map_err(|error| format!("{name}: {error}"));
    let registry = registry::Registry::read(khronos_api::GL_XML)?;
    let names: Vec<String> = read("names.txt")?.lines().map(str::to_owned).collect();
    let plan = plan::Plan::make(&registry, &names, &read("commands.toml")?)?;
    println!("{plan}");
    compare_or_write(&own.join("../src/generated"), &write::files(&plan)?, check)
}

/// Replaces the files of `folder` by `files`, or fails if that would change one.
fn compare_or_write(folder: &Path, files: &[(String, String)], check: bool) -> Result<(), String> {
    let present: Vec<PathBuf> = match fs::read_dir(folder) {
        Ok(entries) => entries.filter_map(|entry| entry.ok().map(|entry| entry.path())).collect(),
        Err(_) => Vec::new(),
    };
    let mut stale: Vec<String> = present
        .iter()
        .filter_map(|path| path.file_name()?.to_str().map(str::to_owned))
        .filter(|name| !files.iter().any(|(file, _)| file == name))
        .collect();
    let surplus = stale.clone();
    for (name, text) in files {
        if fs::read_to_string(folder.join(name)).ok().as_ref() != Some(text) {
            stale.push(name.clone());
        }
    }
    if check {
        return match stale.as_slice() {
            [] => Ok(()),
            _ => Err(format!(
                "src/generated differs from what the generator writes: {}",
                stale.join(", ")
            )),
        };
    }
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(failed)?;
    for name in surplus {
        fs::remove_file(folder.join(name)).map_err(failed)?;
    }
    for (name, text) in files {
        fs::write(folder.join(name), text).map_err(failed)?;
    }
    Ok(())
}
