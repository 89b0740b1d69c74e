//! The folder of public models, which `LUXEL_TEST_MODELS` names, and tests that are skipped.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The folder of public models; without it, the calling test counts as skipped.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("LUXEL_TEST_MODELS").map(PathBuf::from);
    if folder.is_none() {
        skip("LUXEL_TEST_MODELS names no folder of models");
    }
    folder
}

/// Records that the calling test is skipped, or a part of it, in the file that `LUXEL_SKIPPED_TESTS` names.
///
/// Rust's test harness counts a test that returns as passed; `.ci/run` subtracts those in this file.
///
/// # Panics
/// If the file can't be written.
pub fn skip(reason: &str) {
    let program = std::env::current_exe().unwrap_or_default();
    let suite = program.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    // Cargo appends a hash to the name.
    let suite = suite.rsplit_once('-').map_or(suite.as_str(), |(name, _)| name);
    let thread = std::thread::current();
    let line = format!("SKIPPED: {suite}::{}: {reason}\n", thread.name().unwrap_or("main"));
    eprint!("{line}");
    if let Some(path) = std::env::var_os("LUXEL_SKIPPED_TESTS") {
        append(Path::new(&path), &line);
    }
}

/// One write a line, so that tests that run side by side don't mix theirs.
fn append(path: &Path, line: &str) {
    let file = OpenOptions::new().create(true).append(true).open(path);
    let written = file.and_then(|mut file| file.write_all(line.as_bytes()));
    assert!(written.is_ok(), "{} can't be written: {written:?}", path.display());
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_skipped_test_is_a_line_in_the_file() {
        let path = std::env::temp_dir().join(format!("luxel-skipped-{}", std::process::id()));
        super::append(&path, "SKIPPED: one\n");
        super::append(&path, "SKIPPED: two\n");
        let lines = std::fs::read_to_string(&path);
        assert!(std::fs::remove_file(&path).is_ok());
        assert!(lines.is_ok_and(|lines| lines == "SKIPPED: one\nSKIPPED: two\n"));
    }
}
