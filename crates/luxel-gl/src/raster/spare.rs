//! Lists that batches have left, for the next ones: memory that the system doesn't have to clear again.

use super::build::PIECES_RUN;
use super::pieces::Pieces;
use crate::limits::LOG_BYTES;
use crate::vertex::Processed;
use std::sync::{Mutex, PoisonError};

/// Lists of pieces that are kept, and how long these are.
const MOST_LISTS: usize = 64;
const LONGEST_LIST: usize = 2 * PIECES_RUN;

/// Lists with room. Those of vertices take no more memory than the log.
#[derive(Debug, Default)]
pub(crate) struct Spare {
    #[expect(clippy::vec_box, reason = "batches take them and give them back as they are")]
    vertices: Vec<Box<Processed>>,
    pieces: Mutex<Vec<Pieces>>,
    bytes: usize,
}

impl Spare {
    /// Lists for vertices.
    pub(crate) fn vertices(&mut self) -> Box<Processed> {
        let vertices = self.vertices.pop().unwrap_or_default();
        self.bytes = self.bytes.saturating_sub(vertices.bytes());
        vertices
    }

    pub(crate) fn put_vertices(&mut self, vertices: Box<Processed>) {
        let bytes = vertices.bytes();
        if self.bytes + bytes <= LOG_BYTES {
            self.bytes += bytes;
            self.vertices.push(vertices);
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
