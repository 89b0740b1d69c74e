//! How this program starts itself, for workers.

use std::ffi::OsString;
use std::sync::OnceLock;

static LINE: OnceLock<Vec<OsString>> = OnceLock::new();

/// Sets the words that start this program; empty for the executable. Only the first call counts.
pub(crate) fn set_line(words: Vec<OsString>) {
    let _ = LINE.set(words);
}

/// The words that start this program.
pub(crate) fn line() -> Vec<OsString> {
    match LINE.get() {
        Some(words) if !words.is_empty() => words.clone(),
        _ => vec![std::env::current_exe().map_or_else(|_| "luxel".into(), Into::into)],
    }
}
