//! The program from the outside: arguments, output, exit status
//! and written files.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod batch;
mod bytes;
mod check;
mod corpus;
mod damaged;
mod explain;
mod explain_pages;
mod explain_terms;
mod exposure;
#[cfg(feature = "gallery")]
mod gallery;
mod info;
#[cfg(target_os = "linux")]
mod memory;
mod models;
mod navigate;
mod output;
mod pick;
mod program;
mod render;
mod samples;
mod scene_files;
mod up;
mod usage;
mod view;
