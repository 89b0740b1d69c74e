//! Pixels between the framebuffer and the program's memory.

pub(crate) mod format;
pub(crate) mod store;
pub(crate) mod unpack;
