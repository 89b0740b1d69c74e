//! Reads the model of the command line.

use crate::console::Console;
use crate::failure::Failure;
use crate::flag_words::warning_text;
use crate::options::{ExecutionOptions, InputOptions};
use luxel::formats::{self, Error, ErrorKind, Format, Limits, Loaded, Place, Progress};
use luxel::scene::{Scene, demos};
use std::borrow::Cow;
use std::ffi::OsStr;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::OnceLock;
use std::time::Instant;

/// A scene, with the format and the warnings of its reader.
#[derive(Debug)]
pub(crate) struct Model {
    /// The content of the input.
    pub(crate) scene: Scene,
    /// The format's name, `demo` for a built-in scene.
    pub(crate) format: &'static str,
    /// The parts left out or replaced.
    pub(crate) warnings: Vec<String>,
}

impl From<Loaded> for Model {
    fn from(loaded: Loaded) -> Self {
        let Loaded { scene, format, warnings } = loaded;
        let warnings = warnings.iter().map(warning_text).collect();
        Self { scene, format: format.name(), warnings }
    }
}

/// Reads the model of the command line and prints its warnings, for a command that ends with its result.
pub(crate) fn load(
    input: &InputOptions,
    execution: &ExecutionOptions,
    console: Console,
) -> Result<Model, Failure> {
    execution.take_part();
    load_with_progress(input, execution, console, None)
}

/// Like [`load`], with progress that another thread may display or cancel.
pub(crate) fn load_with_progress(
    input: &InputOptions,
    execution: &ExecutionOptions,
    console: Console,
    progress: Option<Progress>,
) -> Result<Model, Failure> {
    let start = Instant::now();
    let limits = Limits { max_memory: execution.max_memory, progress, ..Limits::default() };
    let model = read(input, &limits)?;
    for warning in &model.warnings {
        console.warn(warning);
    }
    let milliseconds = start.elapsed().as_secs_f64() * 1e3;
    console.detail(&format!("{}: read in {milliseconds:.1} ms", input.name()));
    Ok(model)
}

/// Reads a model within the limits.
pub(crate) fn read(input: &InputOptions, limits: &Limits) -> Result<Model, Failure> {
    Ok(if let Some(name) = input.model.to_str().and_then(|name| name.strip_prefix("demo:")) {
        demo(name)?
    } else if input.model == "-" {
        let bytes = standard_input(limits)?;
        let format = input.format.or_else(|| Format::of_bytes(bytes)).ok_or_else(|| {
            let what = "the standard input is no model that luxel knows by its first bytes";
            Failure::work(what, "name its format with --format: glb, gltf, obj, stl, ply or toml")
        })?;
        formats::read(bytes, format, "stdin", None, limits)?.into()
    } else {
        let path = Path::new(&input.model);
        match input.format {
            None => formats::open(path, limits)?.into(),
            Some(format) => open_as(path, format, limits)?.into(),
        }
    })
}

fn demo(name: &str) -> Result<Model, Failure> {
    let scene = demos::demo(name).ok_or_else(|| {
        let names: Vec<_> = demos::names().into_iter().map(|(name, _)| name).collect();
        Failure::work(format!("demo:{name}: no such scene"), format!("use {}", names.join(", ")))
    })?;
    Ok(Model { scene, format: "demo", warnings: Vec::new() })
}

/// Reads a file in a given format.
fn open_as(path: &Path, format: Format, limits: &Limits) -> Result<Loaded, Error> {
    let in_file = |error: std::io::Error| Error::at(Place::File, error.into()).in_file(path);
    let mut file = File::open(path).map_err(in_file)?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    read_all(&mut file, "the file", limits)
        .and_then(|bytes| formats::read(&bytes, format, &stem, path.parent(), limits))
        .map_err(|error| error.in_file(path))
}

/// Opens a regular file; a pipe could block for ever.
pub(crate) fn open_regular(path: &Path) -> std::io::Result<File> {
    if std::fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        return Err(std::io::Error::other("this is not a regular file"));
    }
    File::open(path)
}

/// The bytes of a file or of the standard input.
pub(crate) fn bytes_of(name: &OsStr, limits: &Limits) -> Result<Cow<'static, [u8]>, Error> {
    if name == "-" {
        return standard_input(limits).map(Cow::Borrowed);
    }
    let mut file = File::open(name).map_err(|error| Error::at(Place::File, error.into()))?;
    read_all(&mut file, "the file", limits).map(Cow::Owned)
}

/// The standard input, kept because a scene file is read twice: for its flags, and for its scene.
fn standard_input(limits: &Limits) -> Result<&'static [u8], Error> {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    if let Some(bytes) = BYTES.get() {
        return Ok(bytes);
    }
    let bytes = read_all(&mut std::io::stdin().lock(), "the standard input", limits)?;
    Ok(BYTES.get_or_init(|| bytes))
}

/// Reads to the end, within the limits.
fn read_all(input: &mut dyn Read, what: &str, limits: &Limits) -> Result<Vec<u8>, Error> {
    let at_file = |kind| Error::at(Place::File, kind);
    let mut bytes = Vec::new();
    let most = limits.max_memory.saturating_add(1);
    let read = input.take(most).read_to_end(&mut bytes).map_err(|error| at_file(error.into()))?;
    if read as u64 == most {
        let what = format!("{what}, which is {most} bytes long or longer,");
        return Err(at_file(ErrorKind::TooLarge { what, needed: most, limit: limits.max_memory }));
    }
    Ok(bytes)
}

/// A valid file without anything to draw.
pub(crate) fn nothing_to_draw(name: &str) -> Failure {
    Failure::work(format!("{name}: nothing to draw"), "the file has no triangles, lines or points")
}
