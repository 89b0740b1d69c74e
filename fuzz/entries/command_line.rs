//! Any text as a command line, one argument a line. No command runs.

use std::ffi::OsString;

pub(crate) fn command_line(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let words = ["luxel"].into_iter().chain(text.split('\n'));
    let refusal = luxel_cli::refusal(words.map(OsString::from).collect());
    assert_ne!(refusal.as_deref(), Some(""), "a refusal without a message");
}
