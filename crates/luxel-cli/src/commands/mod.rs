//! The commands, one file each.

#[cfg_attr(not(feature = "batch"), path = "no_batch.rs")]
pub(crate) mod batch;
pub(crate) mod bench;
pub(crate) mod check;
#[cfg(feature = "manual")]
pub(crate) mod completions;
pub(crate) mod demos;
pub(crate) mod explain;
pub(crate) mod gallery;
pub(crate) mod info;
#[cfg(feature = "manual")]
pub(crate) mod manual;
pub(crate) mod navigate;
pub(crate) mod pick;
pub(crate) mod render;
pub(crate) mod schema;
pub(crate) mod view;
