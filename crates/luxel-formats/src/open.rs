//! The door: a path or bytes in, a scene out.

use crate::{Error, ErrorKind, Limits, Place, files, gltf, obj, ply, scene_toml, stl};
use luxel_scene::Scene;
use std::path::Path;
use std::str::FromStr;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// glTF 2.0 as JSON.
    Gltf,
    /// glTF 2.0 in one binary file.
    Glb,
    /// Wavefront OBJ with MTL.
    Obj,
    /// Stereolithography, binary or ASCII.
    Stl,
    /// Stanford polygons, binary or ASCII.
    Ply,
    /// A scene file of luxel's own: models, materials, lights, cameras.
    Toml,
}

/// A scene with what was said on reading it.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// What the file holds.
    pub scene: Scene,
    /// Its format.
    pub format: Format,
    /// What was left out or replaced, a sentence each with its place.
    pub warnings: Vec<String>,
}

impl Format {
    /// The file name extension, which is also the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gltf => "gltf",
            Self::Glb => "glb",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Ply => "ply",
            Self::Toml => "toml",
        }
    }
}

impl FromStr for Format {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        [Self::Gltf, Self::Glb, Self::Obj, Self::Stl, Self::Ply, Self::Toml]
            .into_iter()
            .find(|format| format.name().eq_ignore_ascii_case(name))
            .ok_or_else(|| match name {
                "" => "the name has no extension to tell the format: say it with --format".into(),
                _ => format!(
                    "`{name}` is no format that luxel reads: use glb, gltf, obj, stl, ply or toml"
                ),
            })
    }
}

/// Reads a model file; its extension tells the format.
///
/// # Errors
/// [`Error`] with file and place, if the file can't be read, is damaged or asks for too much.
pub fn open(path: &Path, limits: &Limits) -> Result<Loaded, Error> {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let format = extension.parse();
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    if matches!(format, Ok(Format::Ply | Format::Stl))
        && let Some(file) = files::Stored::open(path, limits)?
    {
        let streamed = match format {
            Ok(Format::Ply) => ply::stream(&file, &stem, limits),
            _ => stl::stream(&file, &stem, limits),
        };
        if let Some(loaded) = streamed.map_err(|error| error.in_file(path))? {
            return Ok(loaded);
        }
    }
    let bytes = files::read_file(path, limits)?;
    let unknown = |message| Error::at(Place::File, ErrorKind::Unsupported(message)).in_file(path);
    let format = format.map_err(unknown)?;
    read(&bytes, format, &stem, path.parent(), limits).map_err(|error| error.in_file(path))
}

/// Reads a model from bytes. `name` stands for objects that the file doesn't name; files that it
/// refers to are looked for in `folder`, or refused without one.
///
/// # Errors
/// [`Error`] with its place, if the input is damaged or asks for too much.
pub fn read(
    bytes: &[u8],
    format: Format,
    name: &str,
    folder: Option<&Path>,
    limits: &Limits,
) -> Result<Loaded, Error> {
    if bytes.is_empty() {
        return Err(Error::at(Place::File, ErrorKind::Malformed("the file is empty".to_owned())));
    }
    match format {
        Format::Gltf | Format::Glb => gltf::read(bytes, format, name, folder, limits),
        Format::Obj => obj::read(bytes, name, folder, limits),
        Format::Stl => stl::read(bytes, name, limits),
        Format::Ply => ply::read(bytes, name, limits),
        Format::Toml => scene_toml::read(bytes, folder, limits),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(path: &Path, limits: &Limits) -> String {
        open(path, limits).unwrap_err().to_string()
    }

    #[test]
    fn what_is_no_model_file_is_told_with_its_name() {
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
            (write("model", b"x"), "model: the name has no extension"),
            (write("model.xyz", b"x"), "`xyz` is no format that luxel reads"),
        ] {
            let message = message(&path, &limits);
            assert!(message.contains(expected), "{message}");
        }
        let solid = write("part.STL", b"solid\nendsolid\n");
        assert_eq!(open(&solid, &limits).unwrap().format, Format::Stl);
        let small = Limits { max_memory: 4, ..Limits::default() };
        assert!(message(&solid, &small).contains("--max-memory"));
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
