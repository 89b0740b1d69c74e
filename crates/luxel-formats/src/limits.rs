//! Limits of allocation, the progress of reading, the files to read and those read.

use crate::{Error, ErrorKind, GivenFiles, Place};
use std::collections::BTreeMap;
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::SystemTime;

/// Bounds that readers check before they allocate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes that one model may take in memory, textures included.
    pub max_memory: u64,
    /// How deep nodes, groups or JSON values may nest.
    pub max_depth: u32,
    /// Reports progress, and cancels reading on request.
    pub progress: Option<Progress>,
    /// Lists the files that a model is made of.
    pub files: Option<FileList>,
    /// The files that there are, instead of those on a disk.
    pub given: Option<GivenFiles>,
}

/// The files that a reader looked for: the model, and all that it refers to. Clones share the list.
#[derive(Clone, Debug, Default)]
pub struct FileList(Arc<Mutex<BTreeMap<PathBuf, Version>>>);

/// Length and time of the last change of a file that is there.
type Version = Option<(u64, SystemTime)>;

/// A file that a reader looked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadFile {
    /// Its path, as it was opened.
    pub path: PathBuf,
    /// Its length in bytes and when it was changed, as the system says, before it was read; `None` if it
    /// isn't there.
    pub version: Option<(u64, SystemTime)>,
}

impl ReadFile {
    /// A file as it is now.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        let metadata = std::fs::metadata(path).ok();
        Self { path: path.to_owned(), version: version_of(metadata.as_ref()) }
    }
}

fn version_of(metadata: Option<&Metadata>) -> Version {
    metadata.and_then(|of| Some((of.len(), of.modified().ok()?)))
}

impl FileList {
    /// The files in the order of their paths, each once.
    #[must_use]
    pub fn files(&self) -> Vec<ReadFile> {
        let files = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let file = |(path, version): (&PathBuf, &Version)| ReadFile {
            path: path.clone(),
            version: *version,
        };
        files.iter().map(file).collect()
    }

    /// Adds a file, unless it is there.
    pub(crate) fn add(&self, path: &Path, metadata: Option<&Metadata>) {
        let version = version_of(metadata);
        let mut files = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        files.entry(path.to_owned()).or_insert(version);
    }
}

/// Always equal: a list is not a limit.
impl PartialEq for FileList {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for FileList {}

/// The progress of reading. Clones share the counts, so that another thread can display them.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<Counts>);

#[derive(Debug, Default)]
struct Counts {
    /// Bytes of files: read, and expected in all.
    read: AtomicU64,
    all: AtomicU64,
    is_stopped: AtomicBool,
}

impl Progress {
    /// Bytes read, and all bytes of the files that are known so far.
    #[must_use]
    pub fn bytes(&self) -> (u64, u64) {
        (self.0.read.load(Ordering::Relaxed), self.0.all.load(Ordering::Relaxed))
    }

    /// Ends reading with [`ErrorKind::Stopped`] at its next check.
    pub fn stop(&self) {
        self.0.is_stopped.store(true, Ordering::Relaxed);
    }

    /// Whether [`stop`](Self::stop) was called.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.0.is_stopped.load(Ordering::Relaxed)
    }

    /// Adds the length of a file that will be read.
    pub(crate) fn expect(&self, bytes: u64) {
        self.0.all.fetch_add(bytes, Ordering::Relaxed);
    }

    /// Adds bytes that have been read.
    pub(crate) fn advance(&self, bytes: u64) {
        self.0.read.fetch_add(bytes, Ordering::Relaxed);
    }
}

/// Always equal: progress is not a limit.
impl PartialEq for Progress {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Progress {}

impl Default for Limits {
    /// 8 GiB, 1024 levels.
    fn default() -> Self {
        Self { max_memory: 8 << 30, max_depth: 1024, progress: None, files: None, given: None }
    }
}

impl Limits {
    /// Checks that `count` elements of `bytes_each` fit.
    ///
    /// # Errors [`ErrorKind::TooLarge`] if they don't, also where the product overflows;
    /// [`ErrorKind::Stopped`] if [`Progress::stop`] was called.
    pub fn check(
        &self,
        what: &str,
        count: u64,
        bytes_each: u64,
        place: Place,
    ) -> Result<(), Error> {
        if self.progress.as_ref().is_some_and(Progress::is_stopped) {
            return Err(Error::at(place, ErrorKind::Stopped));
        }
        let needed = count.saturating_mul(bytes_each);
        if needed <= self.max_memory {
            return Ok(());
        }
        let kind = ErrorKind::TooLarge { what: what.to_owned(), needed, limit: self.max_memory };
        Err(Error::at(place, kind))
    }
}
