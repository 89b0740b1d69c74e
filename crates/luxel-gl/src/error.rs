//! Errors: one flag a context (OpenGL 1.5, section 2.5).

use crate::enums as gl;

/// The context's error flag.
///
/// A command that generates an error has no other effect; the first one is kept until it is read.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ErrorFlag(u32);

impl ErrorFlag {
    /// Keeps an error, unless there is an earlier one that nobody has read.
    pub(crate) fn set(&mut self, error: u32) {
        if self.0 == gl::NO_ERROR {
            self.0 = error;
        }
    }

    /// The error, and none from now on.
    pub(crate) fn take(&mut self) -> u32 {
        std::mem::take(&mut self.0)
    }
}
