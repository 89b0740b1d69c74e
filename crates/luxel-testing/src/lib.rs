//! What the tests of several crates share. Internal: no crate depends on it outside of its tests.
//!
//! - [`golden`] compares pictures with PNG files, and writes three files where they differ.
//! - [`blessing`] writes what tests compare with, if `LUXEL_BLESS` is set, and fails them.
//! - [`models`] finds public models, and records the tests that are skipped without them.

pub mod blessing;
pub mod golden;
pub mod models;
