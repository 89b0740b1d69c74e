//! Objects with names.

pub(crate) mod list;
