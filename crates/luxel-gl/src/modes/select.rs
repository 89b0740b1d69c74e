//! Selection mode (OpenGL 1.5, section 5.2): hit records by [`luxel_pick::Selection`].

use crate::enums as gl;
use crate::limits::PART_VERTICES;
use glam::DMat4;
use luxel_pick::{MAX_NAMES, NameError, Selection};

/// A change of the name stack.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NameChange {
    Init,
    Load(u32),
    Push(u32),
    Pop,
}

/// The buffer that a program has given, and the records of the mode.
///
/// Primitives that wait to be drawn don't know yet whether they are hits. Changes of names between them wait as well,
/// each with the number of vertices before it.
#[derive(Debug, Default)]
pub(crate) struct SelectionMode {
    room: Option<usize>,
    records: Option<Selection>,
    waiting: Vec<(u32, NameChange)>,
    /// Names on the stack after all changes.
    depth: usize,
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
        self.depth
    }

    /// Begins the mode with an empty stack.
    pub(crate) fn start(&mut self) {
        self.records = Some(Selection::new(DMat4::IDENTITY, self.room()));
        self.depth = 0;
    }

    /// Ends the mode: the number of records, -1 if not all had room, and the words of those that had.
    pub(crate) fn finish(&mut self) -> (i32, Vec<u32>) {
        let Some(records) = self.records.take() else { return (0, Vec::new()) };
        self.depth = 0;
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

    /// Changes the names of what is drawn after the vertices that wait.
    #[inline]
    pub(crate) fn change(&mut self, change: NameChange, vertices: usize) -> Result<(), u32> {
        self.depth = match (change, self.depth) {
            (NameChange::Init, _) => 0,
            (NameChange::Load(_), 0) => return Err(error_of(NameError::Empty)),
            (NameChange::Load(_), depth) => depth,
            (NameChange::Push(_), MAX_NAMES) => return Err(error_of(NameError::Overflow)),
            (NameChange::Push(_), depth) => depth + 1,
            (NameChange::Pop, 0) => return Err(error_of(NameError::Underflow)),
            (NameChange::Pop, depth) => depth - 1,
        };
        if vertices == 0 {
            return self.carry_out(change);
        }
        // A name that nothing was drawn with is the next one's place.
        if let (NameChange::Load(_), Some((at, NameChange::Load(_)))) =
            (change, self.waiting.last())
            && *at as usize == vertices
        {
            self.waiting.pop();
        }
        self.waiting.push((vertices as u32, change));
        Ok(())
    }

    /// Whether as many changes wait as may.
    pub(crate) fn is_full(&self) -> bool {
        self.waiting.len() >= PART_VERTICES
    }

    fn carry_out(&mut self, change: NameChange) -> Result<(), u32> {
        let Some(records) = &mut self.records else { return Ok(()) };
        let result = match change {
            NameChange::Init => {
                records.init_names();
                Ok(())
            }
            NameChange::Load(name) => records.load_name(name),
            NameChange::Push(name) => records.push_name(name),
            NameChange::Pop => records.pop_name(),
        };
        result.map_err(error_of)
    }

    /// The changes that wait, in order, each with the number of vertices before it.
    pub(super) fn take_waiting(&mut self) -> Vec<(u32, NameChange)> {
        std::mem::take(&mut self.waiting)
    }

    /// Carries out a change that has waited: whether the stack allows it is known.
    pub(super) fn carry_out_waiting(&mut self, change: NameChange) {
        let result = self.carry_out(change);
        debug_assert!(result.is_ok(), "its depth was checked");
    }
}
