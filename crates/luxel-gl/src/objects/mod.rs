//! Objects with names.

pub(crate) mod buffer;
pub(crate) mod framebuffer;
pub(crate) mod image_calls;
pub(crate) mod list;
pub(crate) mod map_calls;
mod names;
pub(crate) mod query;
pub(crate) mod renderbuffer;
