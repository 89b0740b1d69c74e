//! `LUXEL_BLESS=1` rewrites the files that tests compare with.

use std::path::Path;

/// Whether `LUXEL_BLESS` is set.
#[must_use]
pub fn is_blessing() -> bool {
    std::env::var_os("LUXEL_BLESS").is_some()
}

/// Fails the test that has written `path` instead of comparing with it.
///
/// A run that blesses compares nothing, so it must never pass as a check.
///
/// # Panics
/// Always.
#[track_caller]
pub fn fail(path: &Path) -> ! {
    let path = path.display();
    panic!(
        "LUXEL_BLESS is set: {path} is written, nothing is compared. Look at it, and test again without."
    )
}
