//! Feedback mode (OpenGL 1.5, section 5.3): tokens by [`luxel_pick::FeedbackBuffer`].

use crate::enums as gl;
use luxel_pick::{Feedback, FeedbackBuffer, FeedbackType};
use std::sync::{Mutex, PoisonError};

/// Buffers of parts that are written at a time, and kept for the next ones: memory that the system doesn't have to clear
/// again.
pub(crate) const FEEDBACK_PARTS: usize = 64;
/// Values that a buffer has room for, if it is kept.
const LARGEST_SPARE: usize = 1 << 17;

/// The buffer that a program has given, and what is in it.
#[derive(Debug)]
pub(crate) struct FeedbackMode {
    room: Option<usize>,
    of: u32,
    buffer: Option<FeedbackBuffer>,
    /// Of the same room and type.
    spare: Mutex<Vec<FeedbackBuffer>>,
}

impl Default for FeedbackMode {
    fn default() -> Self {
        Self { room: None, of: gl::_2D, buffer: None, spare: Mutex::default() }
    }
}

impl FeedbackMode {
    pub(crate) fn set_buffer(&mut self, room: usize, of: u32) {
        if (self.room, self.of) != (Some(room), of) {
            self.spare.get_mut().unwrap_or_else(PoisonError::into_inner).clear();
        }
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

    /// Whether vertices are written with colours, and with texture coordinates.
    pub(crate) fn parts_of_vertices(&self) -> [bool; 2] {
        let of = self.type_of_values();
        let has_textures =
            matches!(of, FeedbackType::ThreeDColorTexture | FeedbackType::FourDColorTexture);
        [has_textures || of == FeedbackType::ThreeDColor, has_textures]
    }

    pub(crate) fn start(&mut self) {
        self.buffer = Some(self.empty());
    }

    fn empty(&self) -> FeedbackBuffer {
        FeedbackBuffer::from_bottom(self.type_of_values(), self.room())
    }

    fn type_of_values(&self) -> FeedbackType {
        match self.of {
            gl::_2D => FeedbackType::TwoD,
            gl::_3D => FeedbackType::ThreeD,
            gl::_3D_COLOR => FeedbackType::ThreeDColor,
            gl::_3D_COLOR_TEXTURE => FeedbackType::ThreeDColorTexture,
            _ => FeedbackType::FourDColorTexture,
        }
    }

    /// Ends the mode: the number of values, -1 if not all had room, and those that had.
    pub(crate) fn finish(&mut self) -> (i32, Vec<f32>) {
        let Some(buffer) = self.buffer.take() else { return (0, Vec::new()) };
        let count = i32::try_from(buffer.count()).unwrap_or(i32::MAX);
        (count, buffer.into_values())
    }

    /// Whether some values had no room: those that come have none either.
    pub(crate) fn is_full(&self) -> bool {
        self.buffer.as_ref().is_none_or(|buffer| buffer.count() < 0)
    }

    /// An empty buffer like that of the mode, for a part of what comes next; of any thread.
    pub(crate) fn part(&self) -> FeedbackBuffer {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
        spare.unwrap_or_else(|| self.empty())
    }

    /// Appends parts in order.
    pub(crate) fn append(&mut self, parts: impl Iterator<Item = FeedbackBuffer>) {
        let Some(buffer) = &mut self.buffer else { return };
        let spare = self.spare.get_mut().unwrap_or_else(PoisonError::into_inner);
        for mut part in parts {
            buffer.append(&part);
            if spare.len() < FEEDBACK_PARTS && part.capacity() <= LARGEST_SPARE {
                part.clear();
                spare.push(part);
            }
        }
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
