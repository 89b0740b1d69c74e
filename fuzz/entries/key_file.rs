//! Any text as a key file.

use luxel_viewer::Keys;

pub(crate) fn key_file(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Err(error) = Keys::read(text) {
        assert!(!error.to_string().is_empty());
    }
}
