//! Any bytes as STL.

#![no_main]

#[path = "check.rs"]
mod check;

use luxel_formats::Format;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check(bytes, Format::Stl));
