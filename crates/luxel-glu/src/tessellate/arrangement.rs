//! Edges that meet at their ends only.
//!
//! Pairs of edges that cross are split at the point of the grid next to the crossing, edges with a vertex on them at that
//! vertex. Rounding moves edges a little, so that new crossings may arise: this repeats until there are none. Each pass
//! sweeps in x, and tests edges whose ranges of x and y overlap.

use super::plane::{Plane, Point, area};
use super::{Failure, Listener, Vertex};
use std::collections::{BTreeMap, HashMap};

/// The most vertices and edges: polygons with more crossings are given up.
const MOST: usize = 1 << 24;
/// The most passes; what is left then are crossings below the grid's step.
const PASSES: usize = 64;

/// An edge, from the end that the sweep meets first to the other one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Edge {
    pub(super) from: u32,
    pub(super) to: u32,
    /// How often contours run along it, less how often against it: what the winding number grows by from below it, or
    /// from its right, to the other side.
    pub(super) winding: i32,
}

/// Vertices and edges.
pub(super) struct Arrangement {
    points: Vec<Point>,
    vertices: Vec<Vertex>,
    pub(super) edges: Vec<Edge>,
}

impl Arrangement {
    /// The arrangement of all contours.
    pub(super) fn new(
        contours: &[Vec<Vertex>],
        plane: &Plane,
        listener: &mut impl Listener,
    ) -> Result<Self, Failure> {
        let mut made = Builder::default();
        for contour in contours {
            let mut ids = Vec::with_capacity(contour.len());
            for vertex in contour {
                ids.push(made.vertex(plane.point(vertex.coordinates), *vertex)?);
            }
            for (at, &id) in ids.iter().enumerate() {
                made.add_edge(id, ids[(at + 1) % ids.len()], 1);
            }
        }
        for _ in 0..PASSES {
            let splits = made.find_splits(listener)?;
            if splits.is_empty() {
                break;
            }
            made.split(splits);
        }
        let edges = made.edges.iter().map(|(&(from, to), &winding)| Edge { from, to, winding });
        Ok(Self { edges: edges.collect(), points: made.points, vertices: made.vertices })
    }

    /// Where a vertex is.
    pub(super) fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    /// The caller's handle of a vertex.
    pub(super) fn handle(&self, vertex: u32) -> usize {
        self.vertices[vertex as usize].handle
    }

    /// How many vertices there are.
    pub(super) fn vertex_count(&self) -> usize {
        self.points.len()
    }
}

#[derive(Default)]
struct Builder {
    points: Vec<Point>,
    vertices: Vec<Vertex>,
    at: HashMap<Point, u32>,
    /// By their ends, so that edges between the same ends are one.
    edges: BTreeMap<(u32, u32), i32>,
}

impl Builder {
    /// The vertex at a point: the one that is there, or a new one.
    fn vertex(&mut self, point: Point, vertex: Vertex) -> Result<u32, Failure> {
        if let Some(&id) = self.at.get(&point) {
            return Ok(id);
        }
        if self.points.len() >= MOST {
            return Err(Failure::TooMany);
        }
        let id = self.points.len() as u32;
        self.points.push(point);
        self.vertices.push(vertex);
        self.at.insert(point, id);
        Ok(id)
    }

    fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    /// Adds `winding` runs from one vertex to another; edges whose runs cancel vanish.
    fn add_edge(&mut self, from: u32, to: u32, winding: i32) {
        if from == to || winding == 0 {
            return;
        }
        let (key, winding) = if self.point(from) < self.point(to) {
            ((from, to), winding)
        } else {
            ((to, from), -winding)
        };
        let sum = self.edges.entry(key).or_insert(0);
        *sum += winding;
        if *sum == 0 {
            self.edges.remove(&key);
        }
    }

    /// For each edge that has to be split, the vertices to split it at.
    fn find_splits(
        &mut self,
        listener: &mut impl Listener,
    ) -> Result<BTreeMap<(u32, u32), Vec<u32>>, Failure> {
        let mut order: Vec<(u32, u32)> = self.edges.keys().copied().collect();
        order.sort_by_key(|&(from, to)| (self.point(from), self.point(to)));
        let mut splits: BTreeMap<(u32, u32), Vec<u32>> = BTreeMap::new();
        let mut active: Vec<(u32, u32)> = Vec::new();
        for edge in order {
            let start = self.point(edge.0);
            active.retain(|other| self.point(other.1).x >= start.x);
            for &other in &active {
                if self.y_ranges_overlap(edge, other) {
                    self.meet(edge, other, &mut splits, listener)?;
                }
            }
            active.push(edge);
        }
        Ok(splits)
    }

    fn y_ranges_overlap(&self, a: (u32, u32), b: (u32, u32)) -> bool {
        let range = |(from, to): (u32, u32)| {
            let (y, z) = (self.point(from).y, self.point(to).y);
            (y.min(z), y.max(z))
        };
        let (a, b) = (range(a), range(b));
        a.0 <= b.1 && b.0 <= a.1
    }

    /// Notes where two edges have to be split.
    fn meet(
        &mut self,
        first: (u32, u32),
        second: (u32, u32),
        splits: &mut BTreeMap<(u32, u32), Vec<u32>>,
        listener: &mut impl Listener,
    ) -> Result<(), Failure> {
        let [a, b] = [first.0, first.1].map(|id| self.point(id));
        let [c, d] = [second.0, second.1].map(|id| self.point(id));
        let sides = [area(a, b, c), area(a, b, d), area(c, d, a), area(c, d, b)];
        // A vertex on the other edge, between its ends.
        let mut touched = false;
        for (side, end, (edge, from, to)) in [
            (sides[0], second.0, (first, a, b)),
            (sides[1], second.1, (first, a, b)),
            (sides[2], first.0, (second, c, d)),
            (sides[3], first.1, (second, c, d)),
        ] {
            let point = self.point(end);
            if side == 0 && from < point && point < to {
                splits.entry(edge).or_default().push(end);
                touched = true;
            }
        }
        let crosses =
            sides[0].signum() * sides[1].signum() < 0 && sides[2].signum() * sides[3].signum() < 0;
        if touched || !crosses {
            return Ok(());
        }
        // The crossing is a + (b - a) s / (s - t) for areas s, t of a and b over the other edge.
        let (part, whole) = (sides[2], sides[2] - sides[3]);
        let along = |from: i64, to: i64| from + rounded(i128::from(to - from) * part, whole) as i64;
        let point = Point { x: along(a.x, b.x), y: along(a.y, b.y) };
        let ends = [first.0, first.1, second.0, second.1];
        let vertex = match self.at.get(&point) {
            Some(&vertex) => vertex,
            None => {
                let new = self.combined(point, ends, listener)?;
                self.vertex(point, new)?
            }
        };
        for edge in [first, second] {
            if vertex != edge.0 && vertex != edge.1 {
                splits.entry(edge).or_default().push(vertex);
            }
        }
        Ok(())
    }

    /// The vertex at the crossing of two edges: half of each, by distance from the ends.
    fn combined(
        &self,
        point: Point,
        ends: [u32; 4],
        listener: &mut impl Listener,
    ) -> Result<Vertex, Failure> {
        let distance = |id: u32| {
            let end = self.point(id);
            ((point.x - end.x).unsigned_abs() + (point.y - end.y).unsigned_abs()) as f64
        };
        let mut weights = [0.0; 4];
        for pair in [0, 2] {
            let (from, to) = (distance(ends[pair]), distance(ends[pair + 1]));
            weights[pair] = 0.5 * to / (from + to);
            weights[pair + 1] = 0.5 * from / (from + to);
        }
        let mut coordinates = [0.0; 3];
        for (weight, end) in weights.iter().zip(ends) {
            for (sum, x) in coordinates.iter_mut().zip(self.vertices[end as usize].coordinates) {
                *sum += weight * x;
            }
        }
        let handles = ends.map(|id| self.vertices[id as usize].handle);
        let handle = listener.combine(coordinates, handles, weights.map(|weight| weight as f32));
        Ok(Vertex { coordinates, handle: handle.ok_or(Failure::NoCombine)? })
    }

    /// Replaces edges by chains through the vertices where they are split.
    fn split(&mut self, splits: BTreeMap<(u32, u32), Vec<u32>>) {
        for (edge, mut vertices) in splits {
            let Some(winding) = self.edges.remove(&edge) else { continue };
            let (from, to) = (self.point(edge.0), self.point(edge.1));
            let along = |id: &u32| {
                let point = self.point(*id);
                i128::from(point.x - from.x) * i128::from(to.x - from.x)
                    + i128::from(point.y - from.y) * i128::from(to.y - from.y)
            };
            vertices.sort_by_key(|id| (along(id), *id));
            vertices.dedup();
            let mut last = edge.0;
            for vertex in vertices.into_iter().chain([edge.1]) {
                self.add_edge(last, vertex, winding);
                last = vertex;
            }
        }
    }
}

/// The nearest whole number to a fraction.
fn rounded(numerator: i128, denominator: i128) -> i128 {
    let (numerator, denominator) =
        if denominator < 0 { (-numerator, -denominator) } else { (numerator, denominator) };
    (numerator + denominator / 2).div_euclid(denominator)
}
