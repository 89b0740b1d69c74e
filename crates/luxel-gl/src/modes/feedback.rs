//! Feedback mode (OpenGL 1.5, section 5.3): tokens by [`luxel_pick::FeedbackBuffer`].

use crate::enums as gl;
use luxel_pick::{Feedback, FeedbackBuffer, FeedbackType};

/// The buffer that a program has given, and what is in it.
#[derive(Debug)]
pub(crate) struct FeedbackMode {
    room: Option<usize>,
    of: u32,
    buffer: Option<FeedbackBuffer>,
}

impl Default for FeedbackMode {
    fn default() -> Self {
        Self { room: None, of: gl::_2D, buffer: None }
    }
}

impl FeedbackMode {
    pub(crate) fn set_buffer(&mut self, room: usize, of: u32) {
        self.room = Some(room);
        self.of = of;
    }

    pub(crate) fn has_buffer(&self) -> bool {
        self.room.is_some()
    }

    /// Values of the buffer.
    pub(crate) fn room(&self) -> usize {
        self.room.unwrap_or(0)
    }

    /// `GL_FEEDBACK_BUFFER_TYPE`
    pub(crate) fn of(&self) -> u32 {
        self.of
    }

    pub(crate) fn start(&mut self) {
        let of = match self.of {
            gl::_2D => FeedbackType::TwoD,
            gl::_3D => FeedbackType::ThreeD,
            gl::_3D_COLOR => FeedbackType::ThreeDColor,
            gl::_3D_COLOR_TEXTURE => FeedbackType::ThreeDColorTexture,
            _ => FeedbackType::FourDColorTexture,
        };
        self.buffer = Some(FeedbackBuffer::from_bottom(of, self.room()));
    }

    /// Ends the mode: the number of values, -1 if not all had room, and those that had.
    pub(crate) fn finish(&mut self) -> (i32, Vec<f32>) {
        let Some(buffer) = self.buffer.take() else { return (0, Vec::new()) };
        let count = i32::try_from(buffer.count()).unwrap_or(i32::MAX);
        (count, buffer.values().to_vec())
    }

    pub(crate) fn put(&mut self, item: &Feedback<'_>) {
        if let Some(buffer) = &mut self.buffer {
            buffer.put(item);
        }
    }

    pub(crate) fn pass_through(&mut self, mark: f32) {
        self.put(&Feedback::PassThrough(mark));
    }
}
