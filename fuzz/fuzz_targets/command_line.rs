#![no_main]
#![allow(dead_code, reason = "each target calls one entry of its file")]

#[path = "../entries/command_line.rs"]
mod command_line;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| command_line::command_line(bytes));
