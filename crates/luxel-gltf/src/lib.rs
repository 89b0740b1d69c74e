//! glTF 2.0 documents as types: the JSON part of a file, before any of it is looked up.
//!
//! Reading text into some forty types takes the compiler longer than it ever takes a reader: this
//! crate keeps it apart from what has to be fast.
//!
//! ```
//! let document = luxel_gltf::read(br#"{ "asset": { "version": "2.0" }, "nodes": [{}] }"#)?;
//! assert_eq!(document.nodes.len(), 1);
//! let error = luxel_gltf::read(br#"{ "nodes": [{ "mesh": "first" }] }"#).unwrap_err();
//! assert_eq!(error.fault, luxel_gltf::Fault::Value { pointer: "/nodes/0/mesh".to_owned() });
//! # Ok::<(), luxel_gltf::ReadError>(())
//! ```

#![forbid(unsafe_code)]

mod place;
mod read;
mod schema;

pub use read::{Fault, ReadError, read, read_asset};
pub use schema::*;

/// The examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
