#![no_main]
#![allow(dead_code, reason = "each target calls one entry of its file")]

#[path = "../entries/key_file.rs"]
mod key_file;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| key_file::key_file(bytes));
