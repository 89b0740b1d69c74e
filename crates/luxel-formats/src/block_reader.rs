//! Block-wise reading of long files.

use crate::files::{Checked, LONG, checked};
use crate::{Error, ErrorKind, Limits, Place, Progress};
use std::cell::RefCell;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// Reads blocks of a long file on demand into a per-thread buffer: the file isn't
/// held in memory, and the system zeroes no pages for it.
pub(crate) struct BlockReader<'a> {
    path: &'a Path,
    length: u64,
    progress: Option<&'a Progress>,
    /// Bytes that `progress` has counted.
    reported: AtomicU64,
    /// The first read error.
    failure: Mutex<Option<std::io::Error>>,
}

thread_local! {
    static READ: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

impl<'a> BlockReader<'a> {
    /// `None` for short files, for pipes, and for files in memory.
    pub(crate) fn open(path: &'a Path, limits: &'a Limits) -> Result<Option<Self>, Error> {
        let Checked { length, is_regular } = checked(path, limits)?;
        if !is_regular || length < LONG || limits.given.is_some() {
            return Ok(None);
        }
        let progress = limits.progress.as_ref();
        Ok(Some(Self {
            path,
            length,
            progress,
            reported: AtomicU64::new(0),
            failure: Mutex::new(None),
        }))
    }

    pub(crate) const fn length(&self) -> u64 {
        self.length
    }

    /// Calls `use_block` with `length` bytes from `start`, or with none if they can't be read;
    /// [`check`](Self::check) returns the error.
    pub(crate) fn with_block<R>(
        &self,
        start: u64,
        length: usize,
        use_block: impl FnOnce(&[u8]) -> R,
    ) -> R {
        READ.with_borrow_mut(|bytes| {
            bytes.resize(bytes.len().max(length), 0);
            let bytes = &mut bytes[..length];
            // After a stop the next check of the limits ends reading.
            if self.progress.is_some_and(Progress::is_stopped) {
                return use_block(&[]);
            }
            let read = File::open(self.path).and_then(|mut file| {
                file.seek(SeekFrom::Start(start))?;
                file.read_exact(bytes)
            });
            match read {
                Ok(()) => use_block(bytes),
                Err(error) => {
                    let mut failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner);
                    failure.get_or_insert(error);
                    use_block(&[])
                }
            }
        })
    }

    /// Adds the file to the bytes expected by the progress.
    pub(crate) fn begin(&self) {
        if let Some(progress) = self.progress {
            progress.expect(self.length);
        }
    }

    /// Advances the progress to this byte.
    pub(crate) fn advance_to(&self, byte: u64) {
        if let Some(progress) = self.progress {
            progress.advance(byte - self.reported.swap(byte, Ordering::Relaxed));
        }
    }

    /// The first error of reading.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(error) = failure {
            return Err(Error::at(Place::File, error.into()));
        }
        if self.progress.is_some_and(Progress::is_stopped) {
            return Err(Error::at(Place::File, ErrorKind::Stopped));
        }
        Ok(())
    }
}
