//! Any bytes as glTF, in JSON and in one binary file.

#![no_main]

#[path = "check.rs"]
mod check;

use luxel_formats::Format;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let format = if bytes.starts_with(b"glTF") { Format::Glb } else { Format::Gltf };
    check::check(bytes, format);
});
