//! The inside as triangles, in one sweep.
//!
//! Between two neighbouring edges that the sweep's line crosses, with the inside between them, a piece grows: a chain of
//! vertices below and one above, monotone in x, from which triangles are cut as soon as they can be (Garey, Johnson,
//! Preparata and Tarjan 1978). Where the inside splits around a vertex, a diagonal from the piece's last vertex makes two
//! of one; where two pieces meet they stay two, until the next vertex between their outer edges ends the diagonal.

use super::arrangement::Arrangement;
use super::plane::area;
use super::winding::{BoundaryEdge, Sweep};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Lower,
    Upper,
}

/// A monotone piece: the vertices from which no triangle has been cut, all but the first on one side.
struct Piece {
    rest: Vec<u32>,
    side: Side,
}

/// What lies between two edges.
struct Region {
    lower: Piece,
    /// The piece above it, if two have met and no vertex has come since.
    upper: Option<Piece>,
}

struct Crossed {
    edge: BoundaryEdge,
    /// What lies above it, if that is inside.
    region: Option<Region>,
}

struct Cutter<'a> {
    arrangement: &'a Arrangement,
    triangles: Vec<[u32; 3]>,
}

/// Counter-clockwise triangles of the inside.
pub(super) fn triangles(arrangement: &Arrangement, boundary: &[BoundaryEdge]) -> Vec<[u32; 3]> {
    let ends: Vec<(u32, u32)> = boundary.iter().map(|edge| (edge.from, edge.to)).collect();
    let sweep = Sweep::new(arrangement, &ends);
    let mut cutter = Cutter { arrangement, triangles: Vec::new() };
    let mut status: Vec<Crossed> = Vec::new();
    for &vertex in &sweep.order {
        let point = arrangement.point(vertex);
        let first = status.partition_point(|crossed| {
            let (from, to) = (crossed.edge.from, crossed.edge.to);
            area(arrangement.point(from), arrangement.point(to), point) > 0
        });
        let ending = status[first..].iter().take_while(|crossed| crossed.edge.to == vertex).count();
        let mut starting: Vec<Crossed> = sweep.starting[vertex as usize]
            .iter()
            .map(|&edge| Crossed { edge: boundary[edge as usize], region: None })
            .collect();
        // The regions that the vertex is on the upper and on the lower side of.
        let below = first.checked_sub(1).and_then(|place| status[place].region.take());
        let mut ended: Vec<Option<Region>> =
            status[first..first + ending].iter_mut().map(|crossed| crossed.region.take()).collect();
        let above = ended.pop().flatten();
        for region in ended.into_iter().flatten() {
            cutter.finish(region.lower, vertex);
            if let Some(upper) = region.upper {
                cutter.finish(upper, vertex);
            }
        }
        let (below, above) = if ending == 0 {
            match below {
                Some(region) => {
                    let (lower, upper) = cutter.split(region, vertex);
                    (Some(lower), Some(upper))
                }
                None => (None, None),
            }
        } else {
            (
                below.map(|region| cutter.end_above(region, vertex)),
                above.map(|region| cutter.end_below(region, vertex)),
            )
        };
        let count = starting.len();
        for crossed in starting.iter_mut().take(count.saturating_sub(1)) {
            if crossed.edge.inside_above {
                let piece = Piece { rest: vec![vertex], side: Side::Lower };
                crossed.region = Some(Region { lower: piece, upper: None });
            }
        }
        let alone = |lower| Region { lower, upper: None };
        let below = match starting.last_mut() {
            Some(last) => {
                last.region = above.map(alone);
                below.map(alone)
            }
            // Two pieces meet.
            None => below.map(|lower| Region { lower, upper: above }),
        };
        if let Some(place) = first.checked_sub(1) {
            status[place].region = below;
        }
        status.splice(first..first + ending, starting);
    }
    cutter.triangles
}

impl Cutter<'_> {
    /// A vertex ends the edge above a region: the piece that goes on.
    fn end_above(&mut self, region: Region, vertex: u32) -> Piece {
        if let Some(upper) = region.upper {
            self.finish(upper, vertex);
        }
        self.add(region.lower, vertex, Side::Upper)
    }

    /// A vertex ends the edge below a region: the piece that goes on.
    fn end_below(&mut self, region: Region, vertex: u32) -> Piece {
        match region.upper {
            Some(upper) => {
                self.finish(region.lower, vertex);
                self.add(upper, vertex, Side::Lower)
            }
            None => self.add(region.lower, vertex, Side::Lower),
        }
    }

    /// A vertex within a region makes two pieces of it.
    fn split(&mut self, region: Region, vertex: u32) -> (Piece, Piece) {
        if let Some(upper) = region.upper {
            return (
                self.add(region.lower, vertex, Side::Upper),
                self.add(upper, vertex, Side::Lower),
            );
        }
        let piece = region.lower;
        // The diagonal goes to the vertex that came last; the new piece begins there.
        let last = piece.rest.last().copied().unwrap_or(vertex);
        let side = piece.side;
        let new = Piece { rest: vec![last], side };
        match side {
            Side::Lower => {
                (self.add(new, vertex, Side::Upper), self.add(piece, vertex, Side::Lower))
            }
            Side::Upper => {
                (self.add(piece, vertex, Side::Upper), self.add(new, vertex, Side::Lower))
            }
        }
    }

    /// Adds a vertex to a piece, and cuts off the triangles that it completes.
    fn add(&mut self, mut piece: Piece, vertex: u32, side: Side) -> Piece {
        if piece.rest.len() > 1 && side != piece.side {
            self.fan(&piece, vertex);
            piece.rest = piece.rest.split_off(piece.rest.len() - 1);
        }
        piece.side = side;
        while let [.., second, first] = piece.rest[..] {
            let turn = self.area(second, first, vertex);
            let is_ear = if side == Side::Lower { turn > 0 } else { turn < 0 };
            if !is_ear {
                break;
            }
            self.triangles.push(match side {
                Side::Lower => [second, first, vertex],
                Side::Upper => [first, second, vertex],
            });
            piece.rest.pop();
        }
        piece.rest.push(vertex);
        piece
    }

    /// Ends a piece at a vertex that both of its chains lead to.
    fn finish(&mut self, piece: Piece, vertex: u32) {
        self.fan(&piece, vertex);
    }

    /// Triangles from a vertex to a chain on the other side.
    fn fan(&mut self, piece: &Piece, vertex: u32) {
        for pair in piece.rest.windows(2) {
            self.triangles.push(match piece.side {
                Side::Lower => [pair[0], pair[1], vertex],
                Side::Upper => [pair[1], pair[0], vertex],
            });
        }
    }

    fn area(&self, a: u32, b: u32, c: u32) -> i128 {
        area(self.arrangement.point(a), self.arrangement.point(b), self.arrangement.point(c))
    }
}
