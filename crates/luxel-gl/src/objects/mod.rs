//! Objects with names.

pub(crate) mod image_calls;
pub(crate) mod list;
