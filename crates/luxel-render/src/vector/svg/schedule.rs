//! When pieces may be painted: when all that must come before their faces is.

use super::flatten::Piece;
use super::order::Order;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Which faces may be painted: those with nothing left to be painted before them.
pub(super) struct Schedule {
    order: Order,
    /// Pieces of each face that aren't painted.
    left: Vec<u32>,
    /// The first piece of each face; those of one follow one another.
    first: Vec<u32>,
    pub(super) ready: Vec<bool>,
    /// Pieces of faces that are ready, the first of the scene on top; all before one are painted.
    next: BinaryHeap<Reverse<u32>>,
}

impl Schedule {
    pub(super) fn new(order: Order, pieces: &[Piece]) -> Self {
        let count = order.before.len();
        let mut schedule = Self {
            order,
            left: vec![0; count],
            first: vec![0; count],
            ready: vec![false; count],
            next: BinaryHeap::new(),
        };
        for (number, piece) in (0..).zip(pieces) {
            let face = piece.face as usize;
            if schedule.left[face] == 0 {
                schedule.first[face] = number;
            }
            schedule.left[face] += 1;
        }
        let free: Vec<u32> =
            (0..count as u32).filter(|&face| schedule.order.before[face as usize] == 0).collect();
        schedule.open(free);
        schedule
    }

    /// Makes faces ready, and those that only waited for faces without pieces.
    fn open(&mut self, mut faces: Vec<u32>) {
        while let Some(face) = faces.pop() {
            self.ready[face as usize] = true;
            if self.left[face as usize] > 0 {
                self.next.push(Reverse(self.first[face as usize]));
            } else {
                self.finish(face, &mut faces);
            }
        }
    }

    /// A face is painted: what only waited for it may follow.
    fn finish(&mut self, face: u32, opened: &mut Vec<u32>) {
        for &next in &self.order.later[face as usize] {
            let before = &mut self.order.before[next as usize];
            *before -= 1;
            if *before == 0 {
                opened.push(next);
            }
        }
    }

    /// The first piece that may be painted.
    pub(super) fn seed(&mut self, groups: &[u32], pieces: &[Piece]) -> Option<u32> {
        while let Some(Reverse(piece)) = self.next.pop() {
            let following = piece + 1;
            let same_face = pieces
                .get(following as usize)
                .is_some_and(|next| next.face == pieces[piece as usize].face);
            if same_face {
                self.next.push(Reverse(following));
            }
            if groups[piece as usize] == 0 {
                return Some(piece);
            }
        }
        None
    }

    /// Pieces are painted: faces that waited for theirs may follow.
    pub(super) fn painted(&mut self, members: &[u32], pieces: &[Piece]) {
        let mut opened = Vec::new();
        for &member in members {
            let face = pieces[member as usize].face;
            self.left[face as usize] -= 1;
            if self.left[face as usize] == 0 {
                self.finish(face, &mut opened);
            }
        }
        self.open(opened);
    }
}
