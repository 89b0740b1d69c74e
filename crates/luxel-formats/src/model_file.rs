//! Model files of all formats that a scene file may use.

#[cfg(any(feature = "ply", feature = "stl"))]
use crate::block_reader::BlockReader;
use crate::{Error, ErrorKind, Format, Limits, Loaded, Place, UnknownFormat, files};
use std::path::Path;

/// The format that a file's extension names.
pub(crate) fn format_of(path: &Path) -> Result<Format, UnknownFormat> {
    path.extension().unwrap_or_default().to_string_lossy().parse()
}

/// Reads a model file other than a scene file; its extension decides the format.
pub(crate) fn open(path: &Path, limits: &Limits) -> Result<Loaded, Error> {
    let format = format_of(path);
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    if let Ok(format) = format
        && let Some(loaded) = stream(path, format, &stem, limits)?
    {
        return Ok(loaded);
    }
    let bytes = files::read_file(path, limits)?;
    let format = format.map_err(|unknown| Error::at(Place::File, unknown.into()).in_file(path))?;
    read(&bytes, format, &stem, path.parent(), limits).map_err(|error| error.in_file(path))
}

/// Reads a long binary file block by block; `None` for all others.
#[cfg(any(feature = "ply", feature = "stl"))]
fn stream(
    path: &Path,
    format: Format,
    stem: &str,
    limits: &Limits,
) -> Result<Option<Loaded>, Error> {
    let streams: fn(&BlockReader<'_>, &str, &Limits) -> Result<Option<Loaded>, Error> = match format
    {
        #[cfg(feature = "ply")]
        Format::Ply => crate::ply::stream,
        #[cfg(feature = "stl")]
        Format::Stl => crate::stl::stream,
        _ => return Ok(None),
    };
    let Some(file) = BlockReader::open(path, limits)? else { return Ok(None) };
    streams(&file, stem, limits).map_err(|error| error.in_file(path))
}

/// No reader of this build streams.
#[cfg(not(any(feature = "ply", feature = "stl")))]
fn stream(_: &Path, _: Format, _: &str, _: &Limits) -> Result<Option<Loaded>, Error> {
    Ok(None)
}

/// Reads a model other than a scene file from bytes, like [`crate::read`].
#[cfg_attr(
    not(all(feature = "gltf", feature = "obj", feature = "ply", feature = "stl")),
    allow(unused_variables, reason = "some readers are left out of this build")
)]
pub(crate) fn read(
    bytes: &[u8],
    format: Format,
    name: &str,
    folder: Option<&Path>,
    limits: &Limits,
) -> Result<Loaded, Error> {
    check_not_empty(bytes)?;
    format.check_not_utf16(bytes)?;
    match format {
        #[cfg(feature = "gltf")]
        Format::Gltf | Format::Glb => crate::gltf::read(bytes, format, name, folder, limits),
        #[cfg(feature = "obj")]
        Format::Obj => crate::obj::read(bytes, name, folder, limits),
        #[cfg(feature = "stl")]
        Format::Stl => crate::stl::read(bytes, name, limits),
        #[cfg(feature = "ply")]
        Format::Ply => crate::ply::read(bytes, name, limits),
        #[cfg(feature = "toml")]
        Format::Toml => {
            let message = "scene files can't contain scene files".to_owned();
            Err(Error::at(Place::File, ErrorKind::Unsupported(message)))
        }
        #[allow(unreachable_patterns, reason = "a build with all features has all readers")]
        format => Err(Error::at(Place::File, format.missing_feature())),
    }
}

/// Refuses an empty file.
pub(crate) fn check_not_empty(bytes: &[u8]) -> Result<(), Error> {
    if bytes.is_empty() {
        return Err(Error::at(Place::File, ErrorKind::Malformed("the file is empty".to_owned())));
    }
    Ok(())
}
