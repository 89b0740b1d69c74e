#![no_main]
#![allow(dead_code, reason = "each target calls one entry of its file")]

#[path = "../entries/formats.rs"]
mod formats;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| formats::environment(bytes));
