//! Objects with names.

pub(crate) mod buffer;
pub(crate) mod image_calls;
pub(crate) mod list;
