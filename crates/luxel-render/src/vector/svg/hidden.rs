//! Pieces of faces that are seen elsewhere, but hidden here.
//!
//! What is hidden would do no harm if programs covered pixels by shapes. They blend each pixel of an
//! edge by the part that is covered, so that a tenth of what lies behind shows through where two
//! areas of the same surface meet: dark specks on a bright rim. Only what is next to something seen
//! is needed, to fill the pixels of the edge that hides it.

use super::convex::without;
use super::face::for_each;
use super::flatten::Piece;
use super::order::Order;
use super::web::{Map, Place, Web};

/// How far from what is seen hidden pieces are kept, in pixels.
const KEPT: f64 = 1.0;
/// The most pieces that are looked at from one edge, and parts that are left of one.
const MOST: usize = 64;

/// What may hide pieces: the parts of each face, none for those that let light through.
pub(super) type Hiding = Vec<Vec<Vec<Place>>>;

/// Which pieces are worth painting.
pub(super) fn needed(
    web: &Web,
    pieces: &[Piece],
    right_of: &Map<[u32; 2], u32>,
    order: &Order,
    hiding: &Hiding,
) -> Vec<bool> {
    let numbers: Vec<u32> = (0..pieces.len() as u32).collect();
    let mut needed = for_each(&numbers, |number| {
        let piece = &pieces[number as usize];
        !is_hidden(web, piece, &order.later[piece.face as usize], hiding)
    });
    let mut kept: Vec<u32> = Vec::new();
    let mut found: Vec<u32> = Vec::new();
    let (mut around, mut beyond) = (Vec::new(), Vec::new());
    for (number, piece) in pieces.iter().enumerate().filter(|(number, _)| needed[*number]) {
        web.around(&piece.polygon, &mut around);
        for at in 0..around.len() {
            let way = [around[(at + 1) % around.len()], around[at]];
            let Some(&first) = right_of.get(&way).filter(|&&other| !needed[other as usize]) else {
                continue;
            };
            debug_assert_ne!(first as usize, number, "a piece beside itself");
            let ends = way.map(|point| web.place(point));
            found.clear();
            found.push(first);
            let mut next = 0;
            while let Some(&piece) = found.get(next) {
                next += 1;
                web.around(&pieces[piece as usize].polygon, &mut beyond);
                for side in 0..beyond.len() {
                    let way = [beyond[(side + 1) % beyond.len()], beyond[side]];
                    let near = way.iter().any(|&point| distance(ends, web.place(point)) < KEPT);
                    if let Some(&other) = right_of.get(&way)
                        && near
                        && found.len() < MOST
                        && !needed[other as usize]
                        && !found.contains(&other)
                    {
                        found.push(other);
                    }
                }
            }
            kept.extend(&found);
        }
    }
    for piece in kept {
        needed[piece as usize] = true;
    }
    needed
}

/// Whether what is painted later covers a piece wholly.
fn is_hidden(web: &Web, piece: &Piece, later: &[u32], hiding: &Hiding) -> bool {
    if later.is_empty() {
        return false;
    }
    let mut left: Vec<Vec<Place>> = vec![web.places(&piece.polygon).collect()];
    let mut parts = Vec::new();
    for polygon in later.iter().flat_map(|&face| &hiding[face as usize]) {
        parts.clear();
        for part in &left {
            without(part, polygon, &mut parts);
        }
        std::mem::swap(&mut left, &mut parts);
        if left.is_empty() || left.len() > MOST {
            break;
        }
    }
    left.is_empty()
}

/// How far a place is from the way between two others.
fn distance([[ax, ay], [bx, by]]: [Place; 2], [x, y]: Place) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let squared = (dx * dx + dy * dy).max(f64::MIN_POSITIVE);
    let part = (((x - ax) * dx + (y - ay) * dy) / squared).clamp(0.0, 1.0);
    let (dx, dy) = (x - ax - dx * part, y - ay - dy * part);
    (dx * dx + dy * dy).sqrt()
}
