//! Selection mode (OpenGL 1.5, section 5.2): hit records by [`luxel_pick::Selection`].

use crate::enums as gl;
use glam::DMat4;
use luxel_pick::{NameError, Selection};

/// The buffer that a program has given, and the records of the mode.
#[derive(Debug, Default)]
pub(crate) struct SelectionMode {
    room: Option<usize>,
    records: Option<Selection>,
}

fn error_of(error: NameError) -> u32 {
    match error {
        NameError::Overflow => gl::STACK_OVERFLOW,
        NameError::Underflow => gl::STACK_UNDERFLOW,
        _ => gl::INVALID_OPERATION,
    }
}

impl SelectionMode {
    pub(crate) fn set_room(&mut self, words: usize) {
        self.room = Some(words);
    }

    pub(crate) fn has_buffer(&self) -> bool {
        self.room.is_some()
    }

    /// Words of the buffer.
    pub(crate) fn room(&self) -> usize {
        self.room.unwrap_or(0)
    }

    /// Names on the stack; 0 outside of the mode.
    pub(crate) fn depth(&self) -> usize {
        self.records.as_ref().map_or(0, Selection::depth)
    }

    /// Begins the mode with an empty stack.
    pub(crate) fn start(&mut self) {
        self.records = Some(Selection::new(DMat4::IDENTITY, self.room()));
    }

    /// Ends the mode: the number of records, -1 if not all had room, and the words of those that had.
    pub(crate) fn finish(&mut self) -> (i32, Vec<u32>) {
        let Some(records) = self.records.take() else { return (0, Vec::new()) };
        let selected = records.finish();
        let mut words = Vec::new();
        for record in &selected.records {
            words.push(record.names.len() as u32);
            words.extend(record.z_bits());
            words.extend(&record.names);
        }
        let count = i32::try_from(selected.records.len()).unwrap_or(i32::MAX);
        (if selected.overflowed { -1 } else { count }, words)
    }

    /// Window depths of a primitive that reaches into the clip volume.
    pub(crate) fn hit(&mut self, depths: [f64; 2]) {
        if let Some(records) = &mut self.records {
            records.hit(depths);
        }
    }

    pub(crate) fn init_names(&mut self) {
        if let Some(records) = &mut self.records {
            records.init_names();
        }
    }

    fn names(
        &mut self,
        change: impl FnOnce(&mut Selection) -> Result<(), NameError>,
    ) -> Result<(), u32> {
        self.records.as_mut().map_or(Ok(()), |records| change(records).map_err(error_of))
    }

    pub(crate) fn load_name(&mut self, name: u32) -> Result<(), u32> {
        self.names(|records| records.load_name(name))
    }

    pub(crate) fn push_name(&mut self, name: u32) -> Result<(), u32> {
        self.names(|records| records.push_name(name))
    }

    pub(crate) fn pop_name(&mut self) -> Result<(), u32> {
        self.names(Selection::pop_name)
    }
}
