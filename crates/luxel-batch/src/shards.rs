//! Outputs in archives: tar files of about a size, as WebDataset reads them.

use crate::{Digest, Output};
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What ends an archive.
const END: [u8; 1024] = [0; 1024];

/// Archives that this run appends to.
#[derive(Debug)]
pub(crate) struct Shards {
    folder: PathBuf,
    /// What their names begin with.
    prefix: String,
    /// The size from which on the next one is begun.
    size: u64,
    number: u32,
    current: Option<(String, File)>,
    /// Where the outputs of a key are: tasks of the same content have one set of entries, since WebDataset takes no name
    /// twice.
    taken: Taken,
}

/// The archive of a key's outputs, and where it ends with them; by the shortened key.
pub(crate) type Taken = HashMap<[u8; 16], (Arc<str>, u64)>;

impl Shards {
    /// Archives in a folder; `ends` says where those end that are there, as logs know it, and `taken` what they hold.
    /// What follows was not whole when a run was killed, and is cut off.
    ///
    /// # Errors
    /// An archive can't be written.
    pub(crate) fn new(
        folder: &Path,
        prefix: String,
        size: u64,
        ends: &HashMap<String, u64>,
        taken: Taken,
    ) -> io::Result<Self> {
        let folder = folder.to_owned();
        let mut shards = Self { folder, prefix, size, number: 0, current: None, taken };
        loop {
            let name = shards.name();
            let path = shards.folder.join(&name);
            let end = ends.get(&name).copied();
            if !path.exists() {
                if end.is_none() {
                    return Ok(shards);
                }
                // It was removed: its tasks are drawn again, into later ones.
                shards.number += 1;
                continue;
            }
            let end = end.unwrap_or(0);
            let file = OpenOptions::new().read(true).write(true).open(&path)?;
            file.set_len(end.min(file.metadata()?.len()))?;
            let last = !shards.has_later(ends);
            if end < size && last {
                shards.current = Some((name, file));
                return Ok(shards);
            }
            close(file)?;
            shards.number += 1;
        }
    }

    fn name(&self) -> String {
        self.name_of(self.number)
    }

    fn name_of(&self, number: u32) -> String {
        format!("{}{number:05}.tar", self.prefix)
    }

    /// Whether there are archives with higher numbers.
    fn has_later(&self, ends: &HashMap<String, u64>) -> bool {
        let later = self.name_of(self.number + 1);
        ends.contains_key(&later) || self.folder.join(later).exists()
    }

    /// Moves files that lie below `root` into the archive, unless an archive has those of the same key; their paths become
    /// `ARCHIVE/ENTRY`. The archive and where it ends with them.
    ///
    /// # Errors
    /// A file can't be read, or the archive can't be written.
    pub(crate) fn take(
        &mut self,
        root: &Path,
        key: &Digest,
        outputs: &mut [Output],
    ) -> io::Result<(String, u64)> {
        let entry_of = |path: &str| {
            let base = path.rsplit('/').next().unwrap_or_default();
            // Up to the first full stop, entries of one task have one name.
            format!("{key}.{base}")
        };
        if let Some((name, end)) = self.taken.get(&key.short()) {
            let length = std::fs::metadata(self.folder.join(&**name)).map_or(0, |of| of.len());
            if length >= *end {
                for output in outputs.iter_mut() {
                    // Another worker's file of the same task may have been moved already.
                    let _ = std::fs::remove_file(root.join(&output.path));
                    output.path = format!("{name}/{}", entry_of(&output.path));
                }
                return Ok((name.to_string(), *end));
            }
        }
        let (name, mut file) = match self.current.take() {
            Some(current) => current,
            None => {
                let name = self.name();
                let path = self.folder.join(&name);
                let options = OpenOptions::new().read(true).write(true).create_new(true).open(path);
                (name, options?)
            }
        };
        let mut end = file.seek(SeekFrom::End(0))?;
        for output in outputs.iter_mut() {
            let path = root.join(&output.path);
            let mut bytes = Vec::new();
            File::open(&path)?.read_to_end(&mut bytes)?;
            let entry = entry_of(&output.path);
            let mut header = tar::Header::new_gnu();
            header.set_size(bytes.len() as u64);
            header.set_mode(0o644);
            header.set_mtime(0);
            let mut builder = tar::Builder::new(Vec::new());
            builder.append_data(&mut header, &entry, &bytes[..])?;
            let archive = builder.into_inner()?;
            let whole = archive.len() - END.len();
            file.write_all(&archive[..whole])?;
            end += whole as u64;
            output.path = format!("{name}/{entry}");
            std::fs::remove_file(&path)?;
        }
        if let Some(folder) = outputs.first().and(Some(root.join(crate::store::path_of(key, "")))) {
            // Another worker may be at the same task.
            let _ = std::fs::remove_dir(folder);
        }
        let place = (name.clone(), end);
        self.taken.insert(key.short(), (Arc::from(&*name), end));
        if end >= self.size {
            close(file)?;
            self.number += 1;
        } else {
            self.current = Some((name, file));
        }
        Ok(place)
    }

    /// Ends the archive at work.
    ///
    /// # Errors
    /// It can't be written.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        match self.current.take() {
            Some((_, file)) => close(file),
            None => Ok(()),
        }
    }
}

fn close(mut file: File) -> io::Result<()> {
    file.seek(SeekFrom::End(0))?;
    file.write_all(&END)
}

/// The digests of all entries of an archive, by their names.
///
/// # Errors
/// It can't be read.
pub(crate) fn digests_of_entries(archive: &Path) -> io::Result<HashMap<String, Digest>> {
    let mut archive = tar::Archive::new(File::open(archive)?);
    let mut digests = HashMap::new();
    for entry in archive.entries()? {
        let entry = entry?;
        let name = entry.path()?.to_string_lossy().into_owned();
        digests.insert(name, Digest::of_reader(entry)?.0);
    }
    Ok(digests)
}
