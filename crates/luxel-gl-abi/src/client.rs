//! What the library keeps of its caller's memory: addresses that a later command writes to.

use crate::mapped::Mapped;
use crate::memory::CallerArray;
use crate::window::Window;
use luxel_gl::{Context, Words};
use std::ffi::c_void;

/// Addresses of the caller's memory, one set for each context.
pub(crate) struct Client {
    /// The caller's colour buffer.
    pub(crate) window: Window,
    /// The array of glSelectBuffer.
    pub(crate) selection: CallerArray<u32>,
    /// The array of glFeedbackBuffer.
    pub(crate) feedback: CallerArray<f32>,
    /// The buffer objects that the caller has mapped.
    mapped: Mapped,
}

impl Client {
    /// Of a context that has been given no memory yet.
    pub(crate) fn new(window: Window) -> Self {
        Self {
            window,
            selection: CallerArray::NONE,
            feedback: CallerArray::NONE,
            mapped: Mapped::default(),
        }
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

    /// glBufferData (2.9): new storage ends a mapping.
    pub(crate) fn buffer_data(
        &mut self,
        gl: &mut Context,
        target: u32,
        size: isize,
        data: Option<&[u8]>,
        usage: u32,
    ) {
        self.mapped.replace(gl, target, |gl| gl.buffer_data(target, size, data, usage));
    }

    /// glDeleteBuffers (2.9).
    pub(crate) fn delete_buffers(&mut self, gl: &mut Context, names: &[u32]) {
        gl.delete_buffers(names);
        self.mapped.forget(names);
    }

    /// glMapBuffer (2.9.1).
    pub(crate) fn map_buffer(&mut self, gl: &mut Context, target: u32, access: u32) -> *mut c_void {
        self.mapped.map(gl, target, access)
    }

    /// glMapBufferRange (of later versions).
    pub(crate) fn map_range(
        &mut self,
        gl: &mut Context,
        target: u32,
        offset: isize,
        length: isize,
        access: u32,
    ) -> *mut c_void {
        self.mapped.map_range(gl, target, [offset, length], access)
    }

    /// glFlushMappedBufferRange (of later versions).
    pub(crate) fn flush_range(
        &mut self,
        gl: &mut Context,
        target: u32,
        offset: isize,
        length: isize,
    ) {
        self.mapped.flush(gl, target, [offset, length]);
    }

    /// glGetBufferPointerv (6.1.13).
    pub(crate) fn mapped_address(
        &mut self,
        gl: &mut Context,
        target: u32,
        pname: u32,
    ) -> Option<*mut c_void> {
        self.mapped.address(gl, target, pname)
    }

    /// glUnmapBuffer (2.9.1).
    pub(crate) fn unmap_buffer(&mut self, gl: &mut Context, target: u32) -> u8 {
        u8::from(self.mapped.unmap(gl, target))
    }
}
