//! Lists that batches have left, for the next ones: memory that the system doesn't have to clear again.

use super::build::PIECES_RUN;
use super::pieces::Pieces;
use crate::limits::LOG_BYTES;
use crate::vertex::{Lists, Processed};
use std::sync::{Mutex, PoisonError};

/// Lists of pieces that are kept, and how long these are.
const MOST_LISTS: usize = 64;
const LONGEST_LIST: usize = 2 * PIECES_RUN;

/// Lists with room. Those of vertices take no more memory than the log.
#[derive(Debug, Default)]
pub(crate) struct Spare {
    vertices: Mutex<SpareVertices>,
    pieces: Mutex<Vec<Pieces>>,
}

/// Lists for vertices, and the bytes that they take.
#[derive(Debug, Default)]
struct SpareVertices {
    #[expect(clippy::vec_box, reason = "batches take them and give them back as they are")]
    lists: Vec<Box<Processed>>,
    bytes: usize,
}

impl Spare {
    /// Lists for vertices; of any thread. Preferably those that the same was written to: what they grow by is cleared.
    pub(crate) fn vertices(&self, of: Lists) -> Box<Processed> {
        let mut spare = self.vertices.lock().unwrap_or_else(PoisonError::into_inner);
        let alike = spare.lists.iter().rposition(|vertices| vertices.lists == of);
        let vertices = match alike {
            Some(number) => spare.lists.remove(number),
            None => spare.lists.pop().unwrap_or_default(),
        };
        spare.bytes = spare.bytes.saturating_sub(vertices.bytes());
        vertices
    }

    pub(crate) fn put_vertices(&mut self, vertices: Box<Processed>) {
        let bytes = vertices.bytes();
        let spare = self.vertices.get_mut().unwrap_or_else(PoisonError::into_inner);
        if spare.bytes + bytes <= LOG_BYTES {
            spare.bytes += bytes;
            spare.lists.push(vertices);
        }
    }

    /// A list for pieces; of any thread.
    pub(crate) fn pieces(&self) -> Pieces {
        self.pieces.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()
    }

    /// Keeps a list of pieces.
    pub(super) fn put_pieces(&mut self, mut list: Pieces) {
        list.clear();
        let kept = self.pieces.get_mut().unwrap_or_else(PoisonError::into_inner);
        if kept.len() < MOST_LISTS && list.capacity() <= LONGEST_LIST {
            kept.push(list);
        }
    }
}
