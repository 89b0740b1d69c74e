//! Reads whole files within the limits, long ones in parallel.

#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
use crate::GivenFiles;
use crate::{Error, Limits, Place, Progress};
use luxel_parallel::each;
use std::borrow::Cow;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
use std::path::PathBuf;

/// Bytes per read of one thread.
const BLOCK: usize = 4 << 20;
/// Shorter files are read in one call.
pub(crate) const LONG: u64 = 2 * BLOCK as u64;

/// Reads a file; those in memory without a copy.
pub(crate) fn read_file<'l>(path: &Path, limits: &'l Limits) -> Result<Cow<'l, [u8]>, Error> {
    let Checked { length, is_regular } = checked(path, limits)?;
    if let Some(progress) = &limits.progress {
        progress.expect(length);
    }
    let in_file = |error: Error| error.in_file(path);
    let read = if let Some(given) = &limits.given {
        given.get(path).map(Cow::Borrowed).ok_or_else(missing)
    } else if is_regular && length >= LONG {
        read_blocks(path, length, limits.progress.as_ref()).map(Cow::Owned)
    } else {
        read_stream(path, limits).map(Cow::Owned)
    };
    let bytes = read.map_err(|error| in_file(Error::at(Place::File, error.into())))?;
    // `read_blocks` counts the bytes itself.
    let is_counted = limits.given.is_none() && (bytes.len() as u64) >= LONG;
    if let Some(progress) = limits.progress.as_ref().filter(|_| !is_counted) {
        progress.advance(length);
    }
    // The length of a pipe isn't known beforehand.
    limits.check("the file", bytes.len() as u64, 1, Place::File).map_err(in_file)?;
    Ok(bytes)
}

/// A file that exists, is not a folder and fits the limits.
pub(crate) struct Checked {
    /// Its length in bytes, 0 for a pipe.
    pub(crate) length: u64,
    /// Whether it is neither a pipe nor a device.
    pub(crate) is_regular: bool,
}

/// No file has the name.
fn missing() -> std::io::Error {
    std::io::ErrorKind::NotFound.into()
}

/// The length of a file, which a model refers to.
#[cfg(feature = "gltf")]
pub(crate) fn length(path: &Path, given: Option<&GivenFiles>) -> std::io::Result<u64> {
    match given {
        Some(given) => given.get(path).map(|bytes| bytes.len() as u64).ok_or_else(missing),
        None => std::fs::metadata(path).map(|metadata| metadata.len()),
    }
}

/// Whether there is a regular file.
#[cfg(feature = "gltf")]
pub(crate) fn is_file(path: &Path, given: Option<&GivenFiles>) -> bool {
    match given {
        Some(given) => given.get(path).is_some(),
        None => path.is_file(),
    }
}

/// Checks that a file exists, is not a folder and fits the limits.
pub(crate) fn checked(path: &Path, limits: &Limits) -> Result<Checked, Error> {
    let in_file = |kind| Error::at(Place::File, kind).in_file(path);
    if let Some(given) = &limits.given {
        let bytes = given.get(path).ok_or_else(|| in_file(missing().into()))?;
        let length = bytes.len() as u64;
        let fits = limits.check("the file", length, 1, Place::File);
        fits.map_err(|error| error.in_file(path))?;
        return Ok(Checked { length, is_regular: true });
    }
    let metadata = std::fs::metadata(path);
    if let Some(files) = &limits.files {
        files.add(path, metadata.as_ref().ok());
    }
    let metadata = metadata.map_err(|error| in_file(error.into()))?;
    if metadata.is_dir() {
        let folder = std::io::Error::new(std::io::ErrorKind::IsADirectory, "this is a folder");
        return Err(in_file(folder.into()));
    }
    let fits = limits.check("the file", metadata.len(), 1, Place::File);
    fits.map_err(|error| error.in_file(path))?;
    Ok(Checked { length: metadata.len(), is_regular: metadata.is_file() })
}

fn read_stream(path: &Path, limits: &Limits) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(limits.max_memory.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Several threads copy from the page cache faster than one.
fn read_blocks(path: &Path, length: u64, progress: Option<&Progress>) -> std::io::Result<Vec<u8>> {
    let too_long = |_| std::io::Error::from(std::io::ErrorKind::FileTooLarge);
    let mut bytes = vec![0; usize::try_from(length).map_err(too_long)?];
    let read = |index: usize, block: &mut [u8]| {
        let mut file = File::open(path)?;
        file.seek(SeekFrom::Start((index * BLOCK) as u64))?;
        // After a stop the next check of the limits ends reading.
        if progress.is_none_or(|progress| !progress.is_stopped()) {
            file.read_exact(block)?;
        }
        if let Some(progress) = progress {
            progress.advance(block.len() as u64);
        }
        Ok(())
    };
    let mut failures: Vec<Option<std::io::Error>> = Vec::new();
    failures.resize_with(bytes.len().div_ceil(BLOCK), || None);
    let blocks = bytes.chunks_mut(BLOCK).enumerate().zip(&mut failures);
    each(blocks, &|((index, block), failure)| *failure = read(index, block).err());
    failures.into_iter().flatten().next().map_or(Ok(bytes), Err)
}

/// Why a name that a model refers to is not read.
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
#[derive(Debug)]
pub(crate) struct Refusal {
    /// What is wrong with the name.
    pub(crate) message: String,
    /// Whether something is there that must not be read.
    #[cfg_attr(
        not(any(feature = "gltf", feature = "obj")),
        expect(dead_code, reason = "scene files read nothing that may be missing")
    )]
    pub(crate) is_there: bool,
}

#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
impl From<Refusal> for crate::ErrorKind {
    fn from(refusal: Refusal) -> Self {
        Self::Reference(refusal.message)
    }
}

/// The path of a file that a model refers to: a regular file within the model's folder, also after
/// symbolic links are followed. A pipe or a device could block for ever; a link could show files that
/// the model's author must not see. Whether the file exists is left to its reader.
///
/// # Errors
/// A message about the name.
#[cfg(any(feature = "obj", feature = "toml"))]
pub(crate) fn referenced(
    folder: Option<&Path>,
    name: &str,
    given: Option<&GivenFiles>,
) -> Result<PathBuf, Refusal> {
    let path = within(folder, name, given)?;
    check_reference(folder, &path, name, given)?;
    Ok(path)
}

/// Checks a path from [`within`] as [`referenced`] does.
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
pub(crate) fn check_reference(
    folder: Option<&Path>,
    path: &Path,
    name: &str,
    given: Option<&GivenFiles>,
) -> Result<(), Refusal> {
    if given.is_some() {
        // There are no links, pipes and devices among them.
        return Ok(());
    }
    let refused = |why: &dyn std::fmt::Display| {
        Err(Refusal { message: format!("`{name}` is not read: {why}"), is_there: true })
    };
    let folder = folder.filter(|folder| !folder.as_os_str().is_empty());
    let Ok(folder) = folder.unwrap_or(Path::new(".")).canonicalize() else { return Ok(()) };
    let resolved = match path.canonicalize() {
        Ok(resolved) => resolved,
        Err(error) if is_missing(&error) => return Ok(()),
        // Links in a circle, for example.
        Err(error) => return refused(&error),
    };
    if !resolved.starts_with(folder) {
        return refused(&"a link leads out of the model's folder");
    }
    match std::fs::metadata(&resolved) {
        Ok(metadata) if !metadata.is_file() => refused(&"it is not a regular file"),
        _ => Ok(()),
    }
}

/// Whether an error says that no file has the name.
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
fn is_missing(error: &std::io::Error) -> bool {
    use std::io::ErrorKind::{InvalidFilename, InvalidInput, NotADirectory, NotFound};
    matches!(error.kind(), InvalidFilename | InvalidInput | NotADirectory | NotFound)
}

/// The path of a name in the model's folder, with either separator.
///
/// # Errors
/// A message about the name.
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
pub(crate) fn within(
    folder: Option<&Path>,
    name: &str,
    given: Option<&GivenFiles>,
) -> Result<PathBuf, Refusal> {
    let refused = |why: &str, is_there: bool| Refusal {
        message: format!("`{name}` is not read: {why}"),
        is_there,
    };
    let folder =
        folder.ok_or_else(|| refused("a model from standard input has no folder", false))?;
    let parts = || name.split(['/', '\\']);
    // A drive letter, a scheme, or a stream of NTFS.
    let foreign = name.contains([':', '\0']);
    if name.is_empty() || foreign || name.starts_with(['/', '\\']) || parts().any(|p| p == "..") {
        return Err(refused(
            "it leads out of the model's folder",
            given.is_none() && is_anything(folder, name),
        ));
    }
    Ok(folder.join(parts().filter(|part| *part != ".").collect::<PathBuf>()))
}

/// Whether a name that leads out of a folder leads to something, so far as the system tells.
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
fn is_anything(folder: &Path, name: &str) -> bool {
    let name = name.replace('\\', "/");
    // Windows would ask another machine, with the user's credentials.
    if name.is_empty() || cfg!(windows) && name.starts_with("//") {
        return false;
    }
    std::fs::metadata(folder.join(name)).map_or_else(|error| !is_missing(&error), |_| true)
}
