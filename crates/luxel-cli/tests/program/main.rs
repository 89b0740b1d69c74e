//! The program as its users meet it: what it is given, what it prints, with which status it ends,
//! and which files it leaves.

#![allow(clippy::unwrap_used, reason = "what fails here is a failed test")]

mod bytes;
mod check;
mod damaged;
mod explain;
mod explain_pages;
mod explain_terms;
#[cfg(feature = "gallery")]
mod gallery;
mod info;
mod models;
mod navigate;
mod pick;
mod program;
mod render;
mod scene_files;
mod usage;
mod view;
