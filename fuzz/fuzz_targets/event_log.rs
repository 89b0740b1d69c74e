#![no_main]
#![allow(dead_code, reason = "each target calls one entry of its file")]

#[path = "../entries/event_log.rs"]
mod event_log;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| event_log::event_log(bytes));
