//! What the library keeps of its caller's memory: addresses that a later command writes to.

use crate::memory::CallerArray;
use crate::window::Window;
use luxel_gl::{Context, Words};

/// Addresses of the caller's memory, one set for each context.
pub(crate) struct Client {
    /// The caller's colour buffer.
    pub(crate) window: Window,
    /// The array of glSelectBuffer.
    pub(crate) selection: CallerArray<u32>,
    /// The array of glFeedbackBuffer.
    pub(crate) feedback: CallerArray<f32>,
}

impl Client {
    /// Of a context that has been given no memory yet.
    pub(crate) fn new(window: Window) -> Self {
        Self { window, selection: CallerArray::NONE, feedback: CallerArray::NONE }
    }

    /// glRenderMode (5.2, 5.3): writes what the mode that is left has collected.
    pub(crate) fn render_mode(&mut self, gl: &mut Context, mode: u32) -> i32 {
        let result = gl.render_mode(mode);
        match &result.words {
            Words::None => {}
            // SAFETY: by glSelectBuffer the caller keeps the array until another one is given (5.2).
            Words::Selection(words) => unsafe { self.selection.write(words) },
            // SAFETY: by glFeedbackBuffer the caller keeps the array until another one is given (5.3).
            Words::Feedback(words) => unsafe { self.feedback.write(words) },
        }
        result.count
    }

    /// Writes the colours to the caller's buffer, as glFlush and glFinish of OSMesa do.
    pub(crate) fn present(&mut self, gl: &mut Context) {
        self.window.present(gl);
    }
}
