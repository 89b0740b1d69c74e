//! Outputs as files under their names by content, whole or not at all.

use crate::{Digest, DrawnFile};
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// An output file, as logs and manifests list it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Output {
    /// The number of the view, from 0.
    pub view: u32,
    /// The name of the view, if it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The layer.
    pub layer: String,
    /// Its path below the folder of outputs, with `/`.
    pub path: String,
    /// The digest of its bytes.
    pub sha256: Digest,
    /// Its length.
    pub bytes: u64,
}

impl Output {
    /// The entry of a file at a path.
    #[must_use]
    pub fn new(file: &DrawnFile, path: String) -> Self {
        let DrawnFile { view, name, layer, bytes, .. } = file;
        Self {
            view: *view,
            name: name.clone(),
            layer: layer.clone(),
            path,
            sha256: Digest::of(bytes),
            bytes: bytes.len() as u64,
        }
    }
}

/// The path of a file among the outputs of a key: below two of its digits, so that no folder has too many entries.
#[must_use]
pub fn path_of(key: &Digest, file: &str) -> String {
    let key = key.to_string();
    format!("{}/{key}/{file}", &key[..2])
}

/// A folder of outputs.
#[derive(Debug)]
pub(crate) struct Store {
    root: PathBuf,
    /// Where files are written before they get their names.
    parts: PathBuf,
    /// Files written so far.
    count: u64,
}

impl Store {
    pub(crate) fn new(root: &Path, parts: &Path) -> Self {
        Self { root: root.to_owned(), parts: parts.to_owned(), count: 0 }
    }

    /// Writes an output.
    pub(crate) fn put(&mut self, key: &Digest, file: &DrawnFile) -> io::Result<Output> {
        let output = Output::new(file, path_of(key, &file.file));
        let target = self.root.join(&output.path);
        self.count += 1;
        let part = self.parts.join(format!("{}-{}", std::process::id(), self.count));
        write_whole(&part, &target, &file.bytes)?;
        Ok(output)
    }
}

/// Writes a file under another name and renames it.
pub(crate) fn write_whole(part: &Path, target: &Path, bytes: &[u8]) -> io::Result<()> {
    let in_file = |path: &Path| {
        let path = path.to_owned();
        move |error: io::Error| io::Error::new(error.kind(), format!("{}: {error}", path.display()))
    };
    /// Where outputs go into archives, a folder may be removed as often as tasks of the same content follow one another.
    const TRIES: u32 = 100;
    let place = || {
        let mut tries = 0;
        loop {
            if let Some(folder) = target.parent() {
                fs::create_dir_all(folder).map_err(in_file(folder))?;
            }
            tries += 1;
            match fs::rename(part, target) {
                Err(error) if error.kind() == io::ErrorKind::NotFound && tries < TRIES => {}
                renamed => return renamed.map_err(in_file(target)),
            }
        }
    };
    let written = fs::write(part, bytes).map_err(in_file(part)).and_then(|()| place());
    if written.is_err() {
        let _ = fs::remove_file(part);
    }
    written
}
