//! The log of draws, and the tiles that it is carried out in.

mod framebuffer;
mod log;

pub(crate) use framebuffer::Framebuffer;
pub(crate) use log::{Clear, Log};
