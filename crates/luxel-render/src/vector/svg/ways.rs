//! Ways from point to point around pieces: which piece lies beyond each, and which ways are left around
//! several pieces.

use super::flatten::Piece;
use super::web::{Map, Mixing, Place, Web};

/// The way from a point to the next one around a piece, which lies to its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Way {
    pub(super) from: u32,
    pub(super) to: u32,
    beyond: u32,
}

/// Instead of the number of a piece where there is none.
const NONE: u32 = u32::MAX;

impl Way {
    /// The piece on the left, the first one if there are several.
    pub(super) fn beyond(self) -> Option<u32> {
        (self.beyond != NONE).then_some(self.beyond)
    }

    /// Where it begins and ends.
    pub(super) fn ends(self, web: &Web) -> [Place; 2] {
        [self.from, self.to].map(|point| web.place(point))
    }
}

/// The ways around each of some pieces.
pub(super) struct Ways {
    /// Where those of each piece begin in `all`, and last where those of the last end.
    starts: Vec<usize>,
    all: Vec<Way>,
}

/// So many ways are looked at by one thread at a time.
const RUN: usize = 1 << 12;

impl Ways {
    pub(super) fn new(web: &Web, pieces: &[Piece]) -> Self {
        let mut starts = Vec::with_capacity(pieces.len() + 1);
        let mut all = Vec::with_capacity(3 * pieces.len());
        let mut around = Vec::new();
        for piece in pieces {
            starts.push(all.len());
            web.around(&piece.polygon, &mut around);
            let next = around.iter().cycle().skip(1);
            all.extend(around.iter().zip(next).map(|(&from, &to)| Way { from, to, beyond: NONE }));
        }
        starts.push(all.len());
        let mut right_of: Map<[u32; 2], u32> =
            Map::with_capacity_and_hasher(all.len(), Mixing::default());
        for (number, range) in (0..).zip(starts.windows(2)) {
            for way in &all[range[0]..range[1]] {
                right_of.entry([way.from, way.to]).or_insert(number);
            }
        }
        luxel_parallel::fill(&mut all, RUN, &|_, run| {
            for way in run {
                way.beyond = right_of.get(&[way.to, way.from]).copied().unwrap_or(NONE);
            }
        });
        Self { starts, all }
    }

    /// The ways around a piece, clockwise to the eye.
    pub(super) fn around(&self, piece: u32) -> &[Way] {
        let piece = piece as usize;
        &self.all[self.starts[piece]..self.starts[piece + 1]]
    }
}

/// The ways around pieces, in rings.
pub(super) fn rings(ways: &Ways, members: &[u32]) -> Vec<Vec<Way>> {
    let around = members.iter().flat_map(|&member| ways.around(member));
    let mut ways: Vec<Way> = around.copied().collect();
    ways.sort_unstable();
    // Ways that two members go in opposite directions lie inside.
    let mut taken = vec![false; ways.len()];
    for at in 0..ways.len() {
        let Way { from, to, .. } = ways[at];
        if from < to && !taken[at] {
            let back = ways.partition_point(|way| [way.from, way.to] < [to, from]);
            let is_back = |&back: &usize| [ways[back].from, ways[back].to] == [to, from];
            let free = (back..ways.len()).take_while(is_back);
            if let Some(back) = { free }.find(|&back| !taken[back]) {
                taken[at] = true;
                taken[back] = true;
            }
        }
    }
    let mut rings = Vec::new();
    for start in 0..ways.len() {
        if taken[start] {
            continue;
        }
        let mut ring = Vec::new();
        let mut at = start;
        loop {
            taken[at] = true;
            ring.push(ways[at]);
            let to = ways[at].to;
            let next = ways.partition_point(|way| way.from < to);
            let leaving = (next..ways.len()).take_while(|&next| ways[next].from == to);
            match { leaving }.find(|&next| !taken[next]) {
                Some(next) => at = next,
                None => break,
            }
        }
        rings.push(ring);
    }
    rings
}
