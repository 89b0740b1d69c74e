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
use super::ways::Ways;
use super::web::{Place, Web};

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
    ways: &Ways,
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
    for number in numbers.into_iter().filter(|&number| needed[number as usize]) {
        for way in ways.around(number) {
            let Some(first) = way.beyond().filter(|&other| !needed[other as usize]) else {
                continue;
            };
            debug_assert_ne!(first, number, "a piece beside itself");
            let ends = [way.to, way.from].map(|point| web.place(point));
            found.clear();
            found.push(first);
            let mut next = 0;
            while let Some(&piece) = found.get(next) {
                next += 1;
                for way in ways.around(piece) {
                    let is_near = [way.to, way.from]
                        .iter()
                        .any(|&point| distance(ends, web.place(point)) < KEPT);
                    if let Some(other) = way.beyond()
                        && is_near
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
