//! The log: a line for each task that was tried, appended when its outputs are whole.

use crate::Digest;
use crate::answer::Answer;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A line of the log.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Entry {
    /// The digest of the task's line and of the program's version.
    pub(crate) task: Digest,
    /// Its id.
    pub(crate) id: String,
    #[serde(flatten)]
    pub(crate) answer: Answer,
    /// The shard that holds its outputs, and where the shard ends with them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) shard: Option<(String, u64)>,
}

/// A log that this run appends to.
#[derive(Debug)]
pub(crate) struct Log {
    file: File,
    end: u64,
}

impl Log {
    /// Opens a log, and cuts off a line that a killed run left unfinished.
    ///
    /// # Errors
    /// The file can't be written, or another run holds it.
    pub(crate) fn open(path: &Path) -> io::Result<Self> {
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let text = "another run is at work there";
                return Err(io::Error::new(io::ErrorKind::WouldBlock, text));
            }
            // Not all file systems have locks.
            Err(TryLockError::Error(_)) => {}
        }
        let end = whole_lines(&mut file)?;
        file.set_len(end)?;
        file.seek(SeekFrom::Start(end))?;
        Ok(Self { file, end })
    }

    /// Appends a line; the place where it begins.
    pub(crate) fn append(&mut self, entry: &Entry) -> io::Result<u64> {
        let mut line = serde_json::to_vec(entry)?;
        line.push(b'\n');
        let place = self.end;
        self.file.write_all(&line)?;
        self.end += line.len() as u64;
        Ok(place)
    }
}

/// Where the last whole line ends.
fn whole_lines(file: &mut File) -> io::Result<u64> {
    let mut end = file.seek(SeekFrom::End(0))?;
    let mut block = [0; 4096];
    while end > 0 {
        let length = end.min(block.len() as u64);
        file.seek(SeekFrom::Start(end - length))?;
        let bytes = &mut block[..length as usize];
        file.read_exact(bytes)?;
        if let Some(place) = bytes.iter().rposition(|&byte| byte == b'\n') {
            return Ok(end - length + place as u64 + 1);
        }
        end -= length;
    }
    Ok(0)
}

/// Gives each entry of a log and its place; lines that can't be read are as if they weren't there.
///
/// # Errors
/// The file can't be read.
pub(crate) fn read(path: &Path, mut take: impl FnMut(u64, Entry)) -> io::Result<()> {
    let mut input = BufReader::with_capacity(1 << 20, File::open(path)?);
    let (mut place, mut line) = (0, Vec::new());
    loop {
        line.clear();
        let length = input.read_until(b'\n', &mut line)? as u64;
        if length == 0 || !line.ends_with(b"\n") {
            return Ok(());
        }
        if let Ok(entry) = serde_json::from_slice(&line) {
            take(place, entry);
        }
        place += length;
    }
}

/// The entry at a place.
///
/// # Errors
/// It can't be read.
pub(crate) fn entry_at(log: &mut BufReader<File>, place: u64) -> io::Result<Entry> {
    let here = log.stream_position()?;
    log.seek_relative(i64::try_from(place).unwrap_or(i64::MAX) - i64::try_from(here).unwrap_or(0))?;
    let mut line = Vec::new();
    log.read_until(b'\n', &mut line)?;
    Ok(serde_json::from_slice(&line)?)
}

/// The names of all logs in a folder, in order.
///
/// # Errors
/// The folder can't be read.
pub(crate) fn logs_in(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut logs = Vec::new();
    for file in std::fs::read_dir(folder)? {
        let path = file?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name == "log.jsonl" || (name.starts_with("log-") && name.ends_with(".jsonl")) {
            logs.push(path);
        }
    }
    logs.sort();
    Ok(logs)
}
