//! Files in: whole, in parallel blocks, and never more than the limits allow.

use crate::{Error, Limits, Place, Progress};
use luxel_parallel::each;
use std::fs::{File, Metadata};
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
use std::path::PathBuf;

/// What one thread reads at a time.
const BLOCK: usize = 4 << 20;
/// Shorter files are read in one go.
pub(crate) const LONG: u64 = 2 * BLOCK as u64;

/// Reads a file.
pub(crate) fn read_file(path: &Path, limits: &Limits) -> Result<Vec<u8>, Error> {
    let metadata = checked(path, limits)?;
    if let Some(watch) = &limits.watch {
        watch.expect(metadata.len());
    }
    let in_file = |error: Error| error.in_file(path);
    let read = if metadata.is_file() && metadata.len() >= LONG {
        read_blocks(path, metadata.len(), limits.watch.as_ref())
    } else {
        read_stream(path, limits)
    };
    let bytes = read.map_err(|error| in_file(Error::at(Place::File, error.into())))?;
    // Where the blocks have not counted by themselves.
    if let Some(watch) = limits.watch.as_ref().filter(|_| (bytes.len() as u64) < LONG) {
        watch.advance(metadata.len());
    }
    // Pipes don't tell their length beforehand.
    limits.check("the file", bytes.len() as u64, 1, Place::File).map_err(in_file)?;
    Ok(bytes)
}

/// What the system says of a file that may be read.
pub(crate) fn checked(path: &Path, limits: &Limits) -> Result<Metadata, Error> {
    let in_file = |kind| Error::at(Place::File, kind).in_file(path);
    let metadata = std::fs::metadata(path).map_err(|error| in_file(error.into()))?;
    if metadata.is_dir() {
        let folder = std::io::Error::new(std::io::ErrorKind::IsADirectory, "this is a folder");
        return Err(in_file(folder.into()));
    }
    let fits = limits.check("the file", metadata.len(), 1, Place::File);
    fits.map_err(|error| error.in_file(path))?;
    Ok(metadata)
}

fn read_stream(path: &Path, limits: &Limits) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(limits.max_memory.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Several threads copy from the page cache faster than one.
fn read_blocks(path: &Path, length: u64, watch: Option<&Progress>) -> std::io::Result<Vec<u8>> {
    let too_long = |_| std::io::Error::from(std::io::ErrorKind::FileTooLarge);
    let mut bytes = vec![0; usize::try_from(length).map_err(too_long)?];
    let read = |index: usize, block: &mut [u8]| {
        let mut file = File::open(path)?;
        file.seek(SeekFrom::Start((index * BLOCK) as u64))?;
        // What is not wanted any more ends at the next check of the limits.
        if watch.is_none_or(|watch| !watch.is_stopped()) {
            file.read_exact(block)?;
        }
        if let Some(watch) = watch {
            watch.advance(block.len() as u64);
        }
        Ok(())
    };
    let mut failures: Vec<Option<std::io::Error>> = Vec::new();
    failures.resize_with(bytes.len().div_ceil(BLOCK), || None);
    let blocks = bytes.chunks_mut(BLOCK).enumerate().zip(&mut failures);
    each(blocks, &|((index, block), failure)| *failure = read(index, block).err());
    failures.into_iter().flatten().next().map_or(Ok(bytes), Err)
}

/// The file that a name in a model file refers to: within the model's folder, whatever the system
/// writes between folders. What is wrong with the name is told in a sentence.
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
pub(crate) fn within(folder: Option<&Path>, name: &str) -> Result<PathBuf, String> {
    let folder = folder.ok_or_else(|| {
        format!("`{name}` isn't read: a model from the standard input has no folder beside it")
    })?;
    let parts = || name.split(['/', '\\']);
    // A drive letter, a scheme, or a stream of NTFS.
    let foreign = name.contains([':', '\0']);
    if name.is_empty() || foreign || name.starts_with(['/', '\\']) || parts().any(|p| p == "..") {
        return Err(format!("`{name}` isn't read: it leads out of the model's folder"));
    }
    Ok(folder.join(parts().filter(|part| *part != ".").collect::<PathBuf>()))
}
