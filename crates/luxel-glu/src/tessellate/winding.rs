//! Winding numbers: which edges lie between inside and outside.

use super::arrangement::{Arrangement, Edge};
use super::plane::area;

/// Which winding numbers are inside (`GLU_TESS_WINDING_RULE`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindingRule {
    /// Odd ones.
    Odd,
    /// All but 0.
    Nonzero,
    /// Those above 0.
    Positive,
    /// Those below 0.
    Negative,
    /// 2 and more, -2 and less.
    AbsGeqTwo,
}

impl WindingRule {
    const ALL: [Self; 5] =
        [Self::Odd, Self::Nonzero, Self::Positive, Self::Negative, Self::AbsGeqTwo];
    /// `GLU_TESS_WINDING_ODD`; the others follow.
    const FIRST: f64 = 100_130.0;

    /// The rule by GLU's number.
    pub(super) fn from_number(value: f64) -> Option<Self> {
        Self::ALL.into_iter().find(|rule| rule.number() == value)
    }

    /// GLU's number.
    pub(super) fn number(self) -> f64 {
        Self::FIRST + f64::from(self as u8)
    }

    fn is_inside(self, winding: i32) -> bool {
        match self {
            Self::Odd => winding & 1 != 0,
            Self::Nonzero => winding != 0,
            Self::Positive => winding > 0,
            Self::Negative => winding < 0,
            Self::AbsGeqTwo => winding.abs() >= 2,
        }
    }
}

/// An edge between inside and outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BoundaryEdge {
    pub(super) from: u32,
    pub(super) to: u32,
    /// Whether the inside is above it, or left of it if it is vertical.
    pub(super) inside_above: bool,
}

/// The edges of each vertex, and a sweep's order of vertices.
pub(super) struct Sweep {
    /// Vertices by x, then y.
    pub(super) order: Vec<u32>,
    /// Of each vertex, the edges that begin there, from the lowest to the highest.
    pub(super) starting: Vec<Vec<u32>>,
}

impl Sweep {
    /// Of edges that meet at ends only.
    pub(super) fn new(arrangement: &Arrangement, ends: &[(u32, u32)]) -> Self {
        let mut starting = vec![Vec::new(); arrangement.vertex_count()];
        let mut order = Vec::new();
        for (edge, &(from, to)) in ends.iter().enumerate() {
            starting[from as usize].push(edge as u32);
            order.extend([from, to]);
        }
        order.sort_unstable_by_key(|&vertex| arrangement.point(vertex));
        order.dedup();
        for (vertex, edges) in starting.iter_mut().enumerate() {
            let vertex = arrangement.point(vertex as u32);
            let end = |edge: u32| arrangement.point(ends[edge as usize].1);
            edges.sort_by(|&a, &b| 0.cmp(&area(vertex, end(a), end(b))));
        }
        Self { order, starting }
    }
}

/// The edges between inside and outside of all.
pub(super) fn boundary(arrangement: &Arrangement, rule: WindingRule) -> Vec<BoundaryEdge> {
    let edges = &arrangement.edges;
    let ends: Vec<(u32, u32)> = edges.iter().map(|edge| (edge.from, edge.to)).collect();
    let sweep = Sweep::new(arrangement, &ends);
    let mut boundary = Vec::new();
    // The edges that the sweep's line crosses, from the lowest, each with the winding number above it.
    let mut status: Vec<(Edge, i32)> = Vec::new();
    for &vertex in &sweep.order {
        let point = arrangement.point(vertex);
        let first = status.partition_point(|(edge, _)| {
            area(arrangement.point(edge.from), arrangement.point(edge.to), point) > 0
        });
        let ending = status[first..].iter().take_while(|(edge, _)| edge.to == vertex).count();
        let mut winding = if first > 0 { status[first - 1].1 } else { 0 };
        let starting = sweep.starting[vertex as usize].iter().map(|&edge| {
            let edge = edges[edge as usize];
            let below = winding;
            winding += edge.winding;
            let sides = [below, winding].map(|winding| rule.is_inside(winding));
            if sides[0] != sides[1] {
                boundary.push(BoundaryEdge {
                    from: edge.from,
                    to: edge.to,
                    inside_above: sides[1],
                });
            }
            (edge, winding)
        });
        let starting: Vec<(Edge, i32)> = starting.collect();
        status.splice(first..first + ending, starting);
    }
    boundary
}
