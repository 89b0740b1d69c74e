//! Reads a path or bytes into a scene.

use crate::{Error, Format, Limits, Loaded, model_file};
#[cfg(feature = "toml")]
use crate::{files, scene_toml};
use std::path::Path;

/// Reads a model file; its extension decides the format.
///
/// # Errors
/// [`Error`] with file and place, if the file can't be read, is damaged or exceeds the limits.
pub fn open(path: &Path, limits: &Limits) -> Result<Loaded, Error> {
    #[cfg(feature = "toml")]
    if model_file::format_of(path) == Ok(Format::Toml) {
        let bytes = files::read_file(path, limits)?;
        let read = read(&bytes, Format::Toml, "", path.parent(), limits);
        return read.map_err(|error| error.in_file(path));
    }
    model_file::open(path, limits)
}

/// Reads a model from bytes. `name` is the name of objects without one; files that the model
/// refers to are read from `folder`, or refused without one.
///
/// # Errors
/// [`Error`] with its place, if the input is damaged or exceeds the limits.
pub fn read(
    bytes: &[u8],
    format: Format,
    name: &str,
    folder: Option<&Path>,
    limits: &Limits,
) -> Result<Loaded, Error> {
    #[cfg(feature = "toml")]
    if format == Format::Toml {
        model_file::check_not_empty(bytes)?;
        return scene_toml::read(bytes, folder, limits);
    }
    model_file::read(bytes, format, name, folder, limits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Hint;

    fn message(path: &Path, limits: &Limits) -> String {
        open(path, limits).unwrap_err().to_string()
    }

    #[test]
    fn errors_name_the_file() {
        let folder = std::env::temp_dir().join(format!("luxel-open-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("folder.obj")).unwrap();
        let write = |name: &str, bytes: &[u8]| {
            std::fs::write(folder.join(name), bytes).unwrap();
            folder.join(name)
        };
        let limits = Limits::default();
        for (path, expected) in [
            (folder.join("missing.obj"), "missing.obj: "),
            (folder.join("folder.obj"), "folder.obj: this is a folder"),
            (write("empty.PLY", b""), "empty.PLY: the file is empty"),
            (write("model", b"x"), "model: the file name has no extension"),
            (write("model.xyz", b"x"), "`xyz` is not a format that luxel reads"),
        ] {
            let message = message(&path, &limits);
            assert!(message.contains(expected), "{message}");
        }
        let solid = write("part.STL", b"solid\nendsolid\n");
        assert_eq!(open(&solid, &limits).unwrap().format, Format::Stl);
        let small = Limits { max_memory: 4, ..Limits::default() };
        assert_eq!(open(&solid, &small).unwrap_err().hint(), Some(Hint::RaiseMemoryLimit));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn long_files_are_read_whole() {
        let path = std::env::temp_dir().join(format!("luxel-long-{}", std::process::id()));
        let bytes: Vec<u8> = (0..9_000_001_u32).map(|byte| (byte % 251) as u8).collect();
        std::fs::write(&path, &bytes).unwrap();
        assert!(files::read_file(&path, &Limits::default()).unwrap() == bytes);
        std::fs::remove_file(&path).unwrap();
    }
}
