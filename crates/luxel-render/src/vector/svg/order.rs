//! What is hidden, and in which order the rest must be painted so that what is nearer lies on top.
//!
//! A painter's order by a depth per polygon is wrong where polygons overlap one another in a ring,
//! or pass through one another (Newell, Newell and Sancha 1972). Here each pair of faces that share
//! a part of the window is compared in that part: depth is linear over the window, so corners of the
//! part decide. Faces that pass through each other are cut along the line where their depths are
//! equal; a ring is opened by cutting off what the nearer face hides. What is left is an order that
//! any sequence may follow, and none of it rests on one depth a polygon.

use super::convex::{half, inside, overlap, shared, without};
use super::face::{Face, Grid, for_each};
use super::paint::UNDER;
use super::web::{Corner, Place, Polygon, Web};
use std::collections::BTreeSet;

/// More parts than this, and a face counts as seen: painting a hidden one costs bytes, no truth.
const MOST_PARTS: usize = 48;
/// Depths that differ less than this part of the largest difference are equal.
const LEVEL: f64 = 1e-6;
/// Depths that differ less than this everywhere are one plane's.
const COPLANAR: f64 = 1e-11;
/// How often what passes through one another is cut. Each time, every face may be cut once.
const MOST_ROUNDS: usize = 64;

/// How two faces lie where they share a part of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Apart,
    /// The first lies behind the second.
    Behind,
    Before,
    /// They pass through each other.
    Crossing,
}

/// Compares two faces.
fn relation(web: &Web, a: &Face, b: &Face) -> Relation {
    let mut found = Relation::Apart;
    for p in a.places(web) {
        for q in &b.places(web) {
            if !overlap(&p, q) {
                continue;
            }
            let part = shared(&p, q);
            let differences = || part.iter().map(|&place| a.depth(place) - b.depth(place));
            let (low, high) = differences().fold((0.0_f64, 0.0_f64), |(low, high), difference| {
                (low.min(difference), high.max(difference))
            });
            if part.len() < 3 {
                continue;
            }
            let level = LEVEL * high.max(-low);
            let here = if high.max(-low) < COPLANAR {
                // At equal depth the first in the scene is seen.
                if a.number > b.number { Relation::Behind } else { Relation::Before }
            } else if low >= -level {
                Relation::Behind
            } else if high <= level {
                Relation::Before
            } else {
                Relation::Crossing
            };
            found = match found {
                Relation::Apart => here,
                _ if found == here => here,
                _ => Relation::Crossing,
            };
        }
    }
    found
}

/// Whether faces that are known to be seen hide another wholly.
pub(super) fn is_hidden(web: &Web, faces: &[Face], seen: &Grid, face: &Face) -> bool {
    let mut left = face.places(web);
    let mut parts: Vec<Vec<Place>> = Vec::new();
    seen.near(faces, face, |other| {
        let other = &faces[other as usize];
        if !other.opaque || other.number == face.number {
            return false;
        }
        for polygon in other.places(web) {
            if !left.iter().any(|part| overlap(part, &polygon)) {
                continue;
            }
            // Only what lies before the face hides it.
            let nearer = |place: Place| face.depth(place) - other.depth(place);
            let most = polygon.iter().map(|&place| nearer(place).abs()).fold(0.0, f64::max);
            let front = if most < COPLANAR {
                if other.number > face.number {
                    continue;
                }
                polygon
            } else {
                let mut front = Vec::new();
                half(&polygon, nearer, &mut front);
                front
            };
            if front.len() < 3 {
                continue;
            }
            parts.clear();
            for part in &left {
                without(part, &front, &mut parts);
            }
            std::mem::swap(&mut left, &mut parts);
        }
        left.is_empty() || left.len() > MOST_PARTS
    });
    left.is_empty()
}

/// Faces with what must be painted before what.
pub(super) struct Order {
    /// For each face, those that must come later.
    pub(super) later: Vec<Vec<u32>>,
    /// For each face, how many must come before it.
    pub(super) before: Vec<u32>,
}

/// Cuts faces that pass through one another; answers with all pairs, what lies behind first.
fn pairs(web: &mut Web, faces: &mut Vec<Face>, window: [f64; 2], limit: usize) -> Vec<[u32; 2]> {
    let mut pairs: Vec<[u32; 2]> = Vec::new();
    let mut changed = vec![true; faces.len()];
    for round in 0..=MOST_ROUNDS {
        let grid = Grid::new(faces, window, &vec![true; faces.len()]);
        let asked: Vec<u32> =
            (0..faces.len() as u32).filter(|&face| changed[face as usize]).collect();
        let found = for_each(&asked, |number| {
            let face = &faces[number as usize];
            let mut own = Vec::new();
            grid.near(faces, face, |other| {
                // Pairs of two changed faces are asked about once.
                if other != number && !(changed[other as usize] && other < number) {
                    match relation(web, face, &faces[other as usize]) {
                        Relation::Apart => {}
                        relation => own.push((other, relation)),
                    }
                }
                false
            });
            (number, own)
        });
        pairs.retain(|pair| pair.iter().all(|&face| !changed[face as usize]));
        changed.fill(false);
        let may_cut = round < MOST_ROUNDS && faces.len() < limit;
        for (number, own) in found {
            for (other, relation) in own {
                match relation {
                    Relation::Apart => {}
                    Relation::Behind => pairs.push([number, other]),
                    Relation::Before => pairs.push([other, number]),
                    Relation::Crossing => {
                        // The smaller one is cut, once a round.
                        let size = |face: u32| {
                            let [left, top, right, bottom] = faces[face as usize].bounds;
                            (right - left) * (bottom - top)
                        };
                        let small = size(number) < size(other);
                        let [cut, by] = if small { [number, other] } else { [other, number] };
                        let free = !changed[cut as usize] && !changed[by as usize];
                        if may_cut && (!free || cut_by(web, faces, cut, by)) {
                            changed.resize(faces.len(), true);
                            changed[cut as usize] = true;
                        } else {
                            pairs.push(by_middle(web, faces, number, other));
                        }
                    }
                }
            }
        }
        pairs.retain(|pair| pair.iter().all(|&face| !changed[face as usize]));
        if !changed.contains(&true) {
            break;
        }
    }
    pairs
}

/// Cuts a face where its depth is another's; whether there are two parts now.
fn cut_by(web: &mut Web, faces: &mut Vec<Face>, cut: u32, by: u32) -> bool {
    let (face, other) = (faces[cut as usize].clone(), faces[by as usize].clone());
    let mut parts: [Vec<Polygon>; 2] = Default::default();
    for polygon in &face.polygons {
        let values: Vec<f64> =
            web.places(polygon).map(|place| face.depth(place) - other.depth(place)).collect();
        let most = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let values: Vec<f64> = values
            .iter()
            .map(|&value| if value.abs() <= most * 1e-9 { 0.0 } else { value })
            .collect();
        for (parts, polygon) in parts.iter_mut().zip(web.cut(polygon, &values)) {
            if !polygon.is_empty() {
                parts.push(polygon);
            }
        }
    }
    if parts.iter().any(Vec::is_empty) {
        return false;
    }
    let [behind, before] = parts;
    faces[cut as usize] = face.part(web, behind);
    faces.push(face.part(web, before));
    true
}

/// Which lies behind in the middle of what two faces share: for what rounding can't tell apart.
fn by_middle(web: &Web, faces: &[Face], a: u32, b: u32) -> [u32; 2] {
    let (first, second) = (&faces[a as usize], &faces[b as usize]);
    let mut difference = 0.0;
    for p in first.places(web) {
        for q in &second.places(web) {
            let part = shared(&p, q);
            for place in part {
                difference += first.depth(place) - second.depth(place);
            }
        }
    }
    let behind = if difference == 0.0 { first.number > second.number } else { difference > 0.0 };
    if behind { [a, b] } else { [b, a] }
}

/// Puts faces into an order: cuts what passes through one another, and opens rings.
pub(super) fn order(web: &mut Web, faces: &mut Vec<Face>, window: [f64; 2], limit: usize) -> Order {
    let pairs = pairs(web, faces, window, limit);
    let mut later: Vec<Vec<u32>> = vec![Vec::new(); faces.len()];
    let mut earlier: Vec<Vec<u32>> = vec![Vec::new(); faces.len()];
    for [behind, before] in pairs {
        later[behind as usize].push(before);
        earlier[before as usize].push(behind);
    }
    open_rings(web, faces, &mut later, &earlier);
    let mut before = vec![0; faces.len()];
    for &face in later.iter().flatten() {
        before[face as usize] += 1;
    }
    Order { later, before }
}

/// Where faces overlap one another in a ring: takes one of those with the fewest left behind it, and
/// cuts what it hides off from them, so that they may come after it.
fn open_rings(web: &mut Web, faces: &mut [Face], later: &mut [Vec<u32>], earlier: &[Vec<u32>]) {
    let mut waits: Vec<u32> = earlier.iter().map(|list| list.len() as u32).collect();
    let mut done = vec![false; faces.len()];
    let mut ready: Vec<u32> =
        (0..faces.len() as u32).filter(|&face| waits[face as usize] == 0).collect();
    let mut waiting: Option<BTreeSet<(u32, u32)>> = None;
    loop {
        while let Some(face) = ready.pop() {
            done[face as usize] = true;
            for &next in &later[face as usize] {
                let wait = &mut waits[next as usize];
                if let Some(waiting) = &mut waiting {
                    waiting.remove(&(*wait, next));
                    if *wait > 1 {
                        waiting.insert((*wait - 1, next));
                    }
                }
                *wait -= 1;
                if *wait == 0 {
                    ready.push(next);
                }
            }
        }
        let set = waiting.get_or_insert_with(|| {
            let all = (0..faces.len() as u32).filter(|&face| waits[face as usize] > 0);
            all.map(|face| (waits[face as usize], face)).collect()
        });
        let Some((_, front)) = set.pop_first() else { return };
        let hiding = faces[front as usize].polygons.clone();
        for &behind in &earlier[front as usize] {
            if done[behind as usize] {
                continue;
            }
            let face = &faces[behind as usize];
            let mut parts = face.polygons.clone();
            for polygon in &hiding {
                let places: Vec<Place> = web.places(polygon).collect();
                parts = parts.iter().flat_map(|part| cut_off(web, part, &places)).collect();
            }
            for &next in later[behind as usize].iter().filter(|&&next| next != front) {
                let next = &faces[next as usize];
                if !next.opaque {
                    continue;
                }
                for strip in strips_beside(web, &hiding, &next.polygons) {
                    parts = parts.iter().flat_map(|part| cut_off(web, part, &strip)).collect();
                }
            }
            let bounds = face.bounds;
            faces[behind as usize] = face.part(web, parts);
            faces[behind as usize].bounds = bounds;
            later[behind as usize].retain(|&next| next != front);
        }
        waits[front as usize] = 0;
        ready.push(front);
    }
}

/// Where what is beside polygons lies within a pixel of the edge that they share. What is painted first
/// reaches under the other there, and what came between them would show through both.
fn strips_beside(web: &Web, polygons: &[Polygon], beside: &[Polygon]) -> Vec<Vec<Place>> {
    let mut strips = Vec::new();
    for polygon in polygons {
        for at in 0..polygon.len() {
            let [from, to] = [polygon[at], polygon[(at + 1) % polygon.len()]];
            let shares = |other: &&Polygon| other.iter().any(|corner| corner.line == from.line);
            for other in beside.iter().filter(shares) {
                let ends = [from, to].map(|corner| web.place(corner.point));
                let places: Vec<Place> = web.places(other).collect();
                let mut strip = Vec::new();
                half(&places, |place| inside(ends[0], ends[1], place) + UNDER, &mut strip);
                if strip.len() >= 3 {
                    strips.push(strip);
                }
            }
        }
    }
    strips
}

/// What is left of a polygon without another, as polygons of the web.
fn cut_off(web: &mut Web, polygon: &[Corner], other: &[Place]) -> Vec<Polygon> {
    let own: Vec<Place> = web.places(polygon).collect();
    if !overlap(&own, other) {
        return vec![polygon.to_vec()];
    }
    let mut left = polygon.to_vec();
    let mut parts = Vec::new();
    for at in 0..other.len() {
        let (from, to) = (other[at], other[(at + 1) % other.len()]);
        let values: Vec<f64> = web
            .places(&left)
            .map(|place| inside(from, to, place))
            .map(|value| if value.abs() < super::convex::TOUCHING { 0.0 } else { value })
            .collect();
        let [hidden, seen] = web.cut(&left, &values);
        if !seen.is_empty() {
            parts.push(seen);
        }
        if hidden.is_empty() {
            break;
        }
        left = hidden;
    }
    parts
}
