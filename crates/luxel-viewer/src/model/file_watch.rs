//! Detects that a file has changed, by polling.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Modification time and length.
type Stamp = (SystemTime, u64);

/// Polls a file for changes.
#[derive(Clone, Debug, Default)]
pub(crate) struct FileWatch {
    path: Option<PathBuf>,
    known: Option<Stamp>,
    /// A new stamp of a file that may still be being written.
    changing: Option<Stamp>,
}

impl FileWatch {
    /// Watches a file from its present state on. Demos and the standard input don't change.
    pub(crate) fn of(name: &OsStr) -> Self {
        let is_file = name != "-" && !name.to_string_lossy().starts_with("demo:");
        let path = is_file.then(|| PathBuf::from(name));
        let known = path.as_deref().and_then(stamp);
        Self { path, known, changing: None }
    }

    /// Whether there is a file to poll.
    pub(crate) fn is_needed(&self) -> bool {
        self.path.is_some()
    }

    /// Polls; true if the file has changed and is completely written.
    pub(crate) fn poll(&mut self) -> bool {
        let now = self.path.as_deref().and_then(stamp);
        self.update(now)
    }

    fn update(&mut self, now: Option<Stamp>) -> bool {
        // A missing file is often about to be replaced by another.
        let is_new = now.is_some() && now != self.known;
        // The same stamp twice: the writer has finished.
        let is_whole = is_new && now == self.changing;
        if is_whole {
            self.known = now;
        }
        self.changing = if is_new && !is_whole { now } else { None };
        is_whole
    }
}

fn stamp(path: &Path) -> Option<Stamp> {
    let about = std::fs::metadata(path).ok()?;
    Some((about.modified().ok()?, about.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn a_file_is_another_one_when_it_is_written_and_not_while() {
        let at =
            |second, length| Some((SystemTime::UNIX_EPOCH + Duration::from_secs(second), length));
        let mut watch = FileWatch { known: at(1, 10), ..FileWatch::default() };
        let looks = [
            (at(1, 10), false),
            (at(2, 3), false),
            (at(2, 7), false),
            (None, false),
            (at(2, 12), false),
            (at(2, 12), true),
            (at(2, 12), false),
            (at(3, 12), false),
            (at(3, 12), true),
            // Reverted at once to the version on display.
            (at(4, 1), false),
            (at(3, 12), false),
            (at(3, 12), false),
        ];
        for (step, (now, expected)) in looks.into_iter().enumerate() {
            assert_eq!(watch.update(now), expected, "look {step}");
        }
    }
}
