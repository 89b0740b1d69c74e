//! What the generated entry points use.

pub(crate) use crate::entry::{
    aliases, call, call_uncaught, call_with_memory, call_with_memory_uncaught,
};
pub(crate) use crate::memory::{
    CallerArray, address, array, bytes, bytes_mut, caller_memory, copied, extent, few,
    optional_bytes, store, store_all,
};
pub(crate) use crate::parameters::{from_integers, single};
pub(crate) use crate::returned::returned;
pub(crate) use crate::{pointer_query, strings};
pub(crate) use luxel_gl::{convert, lengths};

/// The error for negative sizes.
pub(crate) const GL_INVALID_VALUE: u32 = 0x0501;
/// The target of volumes.
pub(crate) const GL_TEXTURE_3D: u32 = 0x806F;
/// The first texture unit.
pub(crate) const GL_TEXTURE0: u32 = 0x84C0;
