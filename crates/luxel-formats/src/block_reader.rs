//! Long files, read block by block.

use crate::files::{LONG, checked};
use crate::{Error, ErrorKind, Limits, Place, Progress};
use std::cell::RefCell;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// A long file, read where and when its bytes are wanted, into memory that is used again: it needs no
/// room of its own, and the system no time to make that.
pub(crate) struct BlockReader<'a> {
    path: &'a Path,
    length: u64,
    watch: Option<&'a Progress>,
    /// The bytes that whoever watches knows of.
    reached: AtomicU64,
    /// The first failure to read.
    failure: Mutex<Option<std::io::Error>>,
}

thread_local! {
    static READ: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

impl<'a> BlockReader<'a> {
    /// `None` for short files, and for pipes.
    pub(crate) fn open(path: &'a Path, limits: &'a Limits) -> Result<Option<Self>, Error> {
        let metadata = checked(path, limits)?;
        let length = metadata.len();
        if !metadata.is_file() || length < LONG {
            return Ok(None);
        }
        let watch = limits.watch.as_ref();
        Ok(Some(Self {
            path,
            length,
            watch,
            reached: AtomicU64::new(0),
            failure: Mutex::new(None),
        }))
    }

    pub(crate) const fn length(&self) -> u64 {
        self.length
    }

    /// Looks at some bytes; at none if they can't be read, and then the file is [unsound](Self::sound).
    pub(crate) fn with<R>(&self, start: u64, length: usize, look: impl FnOnce(&[u8]) -> R) -> R {
        READ.with_borrow_mut(|bytes| {
            bytes.resize(bytes.len().max(length), 0);
            let bytes = &mut bytes[..length];
            // What is not wanted any more ends at the next check of the limits.
            if self.watch.is_some_and(Progress::is_stopped) {
                return look(&[]);
            }
            let read = File::open(self.path).and_then(|mut file| {
                file.seek(SeekFrom::Start(start))?;
                file.read_exact(bytes)
            });
            match read {
                Ok(()) => look(bytes),
                Err(error) => {
                    let mut failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner);
                    failure.get_or_insert(error);
                    look(&[])
                }
            }
        })
    }

    /// Tells whoever watches that the file is going to be read.
    pub(crate) fn expect(&self) {
        if let Some(watch) = self.watch {
            watch.expect(self.length);
        }
    }

    /// Tells whoever watches that the bytes before this one have been read.
    pub(crate) fn reached(&self, byte: u64) {
        if let Some(watch) = self.watch {
            watch.advance(byte - self.reached.swap(byte, Ordering::Relaxed));
        }
    }

    /// Whether all that was looked at was there.
    pub(crate) fn sound(&self) -> Result<(), Error> {
        let failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(error) = failure {
            return Err(Error::at(Place::File, error.into()));
        }
        if self.watch.is_some_and(Progress::is_stopped) {
            return Err(Error::at(Place::File, ErrorKind::Stopped));
        }
        Ok(())
    }
}
