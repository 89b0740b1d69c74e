//! Any bytes as a scene file.

#![no_main]

#[path = "check.rs"]
mod check;

use luxel_formats::{Format, scene_settings};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    check::check(bytes, Format::Toml);
    let _ = scene_settings(bytes, &check::LIMITS);
});
