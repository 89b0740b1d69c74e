//! Ways from point to point around pieces: which piece lies beside each, and which ways are left around
//! several pieces.

use super::flatten::Piece;
use super::web::{Map, Mixing, Web};

/// The piece to the right of each way from point to point.
pub(super) fn right_of(web: &Web, pieces: &[Piece]) -> Map<[u32; 2], u32> {
    let mut right_of = Map::with_capacity_and_hasher(3 * pieces.len(), Mixing::default());
    let mut around = Vec::new();
    for (number, piece) in (0..).zip(pieces) {
        web.around(&piece.polygon, &mut around);
        for at in 0..around.len() {
            right_of.entry([around[at], around[(at + 1) % around.len()]]).or_insert(number);
        }
    }
    right_of
}

/// The ways around pieces, in rings.
pub(super) fn rings(web: &Web, pieces: &[Piece], members: &[u32]) -> Vec<Vec<[u32; 2]>> {
    let mut ways: Vec<[u32; 2]> = Vec::new();
    let mut around = Vec::new();
    for &member in members {
        web.around(&pieces[member as usize].polygon, &mut around);
        ways.extend((0..around.len()).map(|at| [around[at], around[(at + 1) % around.len()]]));
    }
    ways.sort_unstable();
    // Ways that two members go in opposite directions lie inside.
    let mut taken = vec![false; ways.len()];
    for at in 0..ways.len() {
        let [from, to] = ways[at];
        if from < to && !taken[at] {
            let back = ways.partition_point(|way| *way < [to, from]);
            let free = (back..ways.len()).take_while(|&back| ways[back] == [to, from]);
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
            let [_, to] = ways[at];
            let next = ways.partition_point(|way| *way < [to, 0]);
            let leaving = (next..ways.len()).take_while(|&next| ways[next][0] == to);
            match { leaving }.find(|&next| !taken[next]) {
                Some(next) => at = next,
                None => break,
            }
        }
        rings.push(ring);
    }
    rings
}
