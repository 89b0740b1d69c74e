//! The outlines of the inside, which is on their left.

use super::arrangement::Arrangement;
use super::plane::{Point, area};
use super::winding::BoundaryEdge;
use std::cmp::Ordering;
use std::collections::HashSet;

/// The edges of outlines, by their ends in increasing order.
pub(super) fn edge_set(boundary: &[BoundaryEdge]) -> HashSet<(u32, u32)> {
    boundary.iter().map(|edge| (edge.from.min(edge.to), edge.from.max(edge.to))).collect()
}

/// The outlines as loops of vertices. Where several meet at a vertex, each stays with its own piece of the inside.
pub(super) fn outlines(arrangement: &Arrangement, boundary: &[BoundaryEdge]) -> Vec<Vec<u32>> {
    let directed: Vec<(u32, u32)> = boundary
        .iter()
        .map(|edge| if edge.inside_above { (edge.from, edge.to) } else { (edge.to, edge.from) })
        .collect();
    let mut leaving = vec![Vec::new(); arrangement.vertex_count()];
    for (edge, &(from, _)) in directed.iter().enumerate() {
        leaving[from as usize].push(edge);
    }
    let mut used = vec![false; directed.len()];
    let mut outlines = Vec::new();
    for first in 0..directed.len() {
        let mut outline = Vec::new();
        let mut edge = first;
        while !used[edge] {
            used[edge] = true;
            let (from, at) = directed[edge];
            outline.push(from);
            let (back, center) = (arrangement.point(from), arrangement.point(at));
            let end = |&edge: &usize| arrangement.point(directed[edge].1);
            let candidates =
                leaving[at as usize].iter().filter(|&&edge| !used[edge] || edge == first);
            let next = candidates.min_by(|a, b| clockwise(center, back, end(a), end(b)));
            match next {
                Some(&next) => edge = next,
                None => break,
            }
        }
        if outline.len() > 2 {
            outlines.push(outline);
        }
    }
    outlines
}

/// Which of two directions a turn clockwise from `back` meets first; `back` itself is met last.
fn clockwise(center: Point, back: Point, a: Point, b: Point) -> Ordering {
    // Directions right of `back`, those opposite to it, those left of it.
    let half = |to: Point| {
        let side = area(center, back, to);
        let opposite = i128::from(back.x - center.x) * i128::from(to.x - center.x)
            + i128::from(back.y - center.y) * i128::from(to.y - center.y)
            < 0;
        match side.cmp(&0) {
            Ordering::Less => 0,
            Ordering::Equal if opposite => 1,
            Ordering::Greater => 2,
            Ordering::Equal => 3,
        }
    };
    half(a).cmp(&half(b)).then_with(|| area(center, a, b).cmp(&0))
}
