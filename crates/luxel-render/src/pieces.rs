//! Recursive subdivision: a triangle into pieces so small that interpolating the light between
//! their corners gives what lighting every pixel would give, to a tolerance.
//!
//! An edge is halved if the light at places along it differs from what its ends interpolate to, and
//! the longest edge with any other, so that no slivers arise. Where the edges are fine and the inside
//! is not, all three are halved. Neighbours may decide differently about an edge that is fine; the
//! seam is then within the tolerance. Edges shorter than a small part of a pixel stay whole: there
//! the light jumps, as a highlight does where N.L becomes 0.

use luxel_lighting::PictureEncoding;
use luxel_math::elementary;
use std::collections::HashMap;

/// Pixels between the places where an edge is tried.
const STEP: f64 = 6.0;
/// Most places where an edge is tried: a highlight narrower than a part of a large triangle must
/// not slip through.
const MOST_TRIED: usize = 24;
/// Most places along a side of the grid where an inside is tried.
const MOST_INSIDE: usize = 12;
/// Edges shorter than this, in pixels, stay whole.
const SHORTEST: f64 = 1.0 / 64.0;
/// How often pieces are divided again at most.
const DEEPEST: u32 = 12;
/// Most places that are lit for one triangle.
const MOST_LIT: usize = 1 << 18;

/// A place by its barycentrics.
type Place = [f32; 3];

/// What subdividing a triangle took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PieceCount {
    /// The pieces.
    pub(crate) pieces: u32,
    /// The largest difference to lighting each place by itself, where that was tried, in steps of
    /// 8 bits.
    pub(crate) error: f32,
}

/// A triangle's pieces.
#[derive(Clone, Debug)]
pub(crate) struct Pieces {
    places: Vec<(Place, [f32; 3])>,
    nodes: Vec<Node>,
    pub(crate) count: PieceCount,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    corners: [u32; 3],
    /// The first of its parts, which follow one another; none in a piece.
    first: u32,
    parts: u32,
}

/// What subdividing asks for.
pub(crate) struct Asked<'a> {
    /// In steps of 8 bits.
    pub(crate) tolerance: f32,
    pub(crate) encoding: PictureEncoding,
    /// The light at a place.
    pub(crate) light: &'a mut dyn FnMut(Place) -> [f32; 3],
    /// Where a place lies in the window, in pixels; `None` if it isn't before the eye.
    pub(crate) window: &'a dyn Fn(Place) -> Option<[f64; 2]>,
}

struct Builder<'a> {
    asked: Asked<'a>,
    pieces: Pieces,
    /// Places that are lit already, by the bits of their first two barycentrics.
    known: HashMap<[u32; 2], u32>,
}

impl Pieces {
    pub(crate) fn new(asked: Asked<'_>) -> Self {
        let count = PieceCount { pieces: 0, error: 0.0 };
        let pieces = Self { places: Vec::new(), nodes: Vec::new(), count };
        let mut builder = Builder { asked, pieces, known: HashMap::new() };
        let corners =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|place| builder.lit(place));
        builder.pieces.nodes.push(Node { corners, first: 0, parts: 0 });
        builder.divide(0, 0);
        builder.pieces
    }

    /// The corners of the piece that holds a place, and the place's barycentrics in it.
    pub(crate) fn piece(&self, place: Place) -> ([Place; 3], [f32; 3]) {
        let (corners, weights) = self.find(place);
        (corners.map(|corner| self.places[corner as usize].0), weights)
    }

    /// The interpolated light at a place.
    pub(crate) fn light(&self, place: Place) -> [f32; 3] {
        let (corners, weights) = self.find(place);
        mixed(corners.map(|corner| self.places[corner as usize].1), weights)
    }

    fn find(&self, place: Place) -> ([u32; 3], [f32; 3]) {
        let mut node = &self.nodes[0];
        let mut inside = place.map(f64::from);
        while node.parts > 0 {
            let parts = &self.nodes[node.first as usize..(node.first + node.parts) as usize];
            let mut best = f64::NEG_INFINITY;
            for part in parts {
                let local = self.local(part, place);
                let least = local[0].min(local[1]).min(local[2]);
                if least > best {
                    (best, node, inside) = (least, part, local);
                }
            }
            if best == f64::NEG_INFINITY {
                break;
            }
        }
        let inside = inside.map(|weight| weight.max(0.0));
        let sum = inside[0] + inside[1] + inside[2];
        (node.corners, inside.map(|weight| (weight / sum) as f32))
    }

    /// A place's barycentrics in a node.
    fn local(&self, node: &Node, place: Place) -> [f64; 3] {
        let [a, b, c] = node.corners.map(|corner| self.places[corner as usize].0.map(f64::from));
        let at = place.map(f64::from);
        let twice = |p: [f64; 3], q: [f64; 3], r: [f64; 3]| {
            (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])
        };
        let whole = twice(a, b, c);
        [twice(at, b, c) / whole, twice(a, at, c) / whole, twice(a, b, at) / whole]
    }
}

impl Builder<'_> {
    /// The number of a place, lit once.
    fn lit(&mut self, place: Place) -> u32 {
        let key = [place[0].to_bits(), place[1].to_bits()];
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let light = (self.asked.light)(place);
        let number = self.pieces.places.len() as u32;
        self.pieces.places.push((place, light));
        self.known.insert(key, number);
        number
    }

    fn place(&self, number: u32) -> Place {
        self.pieces.places[number as usize].0
    }

    /// How far the light at a place is from what corners interpolate to, in steps of 8 bits.
    fn error(&mut self, corners: [u32; 3], weights: [f32; 3]) -> f32 {
        let place = mixed(corners.map(|corner| self.place(corner)), weights);
        let lit = (self.asked.light)(place);
        let interpolated =
            mixed(corners.map(|corner| self.pieces.places[corner as usize].1), weights);
        let encoding = self.asked.encoding;
        let steps = |light: f32| 255.0 * encoded(encoding, light);
        let mut error = 0.0_f32;
        for channel in 0..3 {
            error = error.max((steps(lit[channel]) - steps(interpolated[channel])).abs());
        }
        error
    }

    /// An edge's length in the window; very long if an end isn't before the eye.
    fn length(&self, from: u32, to: u32) -> f64 {
        let window = self.asked.window;
        let (Some(p), Some(q)) = (window(self.place(from)), window(self.place(to))) else {
            return f64::from(u16::MAX);
        };
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        (x * x + y * y).sqrt()
    }

    /// The largest error along an edge.
    fn edge_error(&mut self, from: u32, to: u32, length: f64) -> f32 {
        let tried = ((length / STEP) as usize).clamp(1, MOST_TRIED);
        // An odd number, so that the middle is among them.
        let tried = tried | 1;
        let mut error = 0.0_f32;
        for at in 1..=tried {
            let t = at as f32 / (tried + 1) as f32;
            error = error.max(self.error([from, to, to], [1.0 - t, t, 0.0]));
        }
        error
    }

    /// The largest error inside of a triangle.
    fn inside_error(&mut self, corners: [u32; 3], longest: f64) -> f32 {
        let third = 1.0 / 3.0;
        let mut error = self.error(corners, [third; 3]);
        let side = ((longest / STEP) as usize).min(MOST_INSIDE);
        for row in 1..side {
            for column in 1..side - row {
                let [v, w] = [row, column].map(|at| at as f32 / side as f32);
                error = error.max(self.error(corners, [1.0 - v - w, v, w]));
            }
        }
        error
    }

    fn divide(&mut self, node: usize, depth: u32) {
        let corners = self.pieces.nodes[node].corners;
        let [a, b, c] = corners;
        let tolerance = self.asked.tolerance;
        let may = depth < DEEPEST && self.pieces.places.len() < MOST_LIT;
        let edges = [[b, c], [c, a], [a, b]];
        let lengths = edges.map(|[from, to]| self.length(from, to));
        let longest = lengths[0].max(lengths[1]).max(lengths[2]);
        let may = may && longest > SHORTEST;
        let off: [f32; 3] =
            std::array::from_fn(|at| self.edge_error(edges[at][0], edges[at][1], lengths[at]));
        let inside = self.inside_error(corners, longest);
        let rough = off.map(|off| off > tolerance && may);
        let any = rough.contains(&true);
        // The longest edge goes with the others, so that no slivers arise.
        let halves = |at: usize| match any {
            true => rough[at] || lengths[at] >= longest,
            false => inside > tolerance && may,
        };
        let mut halved = [None; 3];
        for at in 0..3 {
            if halves(at) {
                let ends = [self.place(edges[at][0]), self.place(edges[at][1]), [0.0; 3]];
                halved[at] = Some(self.lit(mixed(ends, [0.5, 0.5, 0.0])));
            }
        }
        let parts: Vec<[u32; 3]> = match halved {
            [None, None, None] => Vec::new(),
            [Some(x), None, None] => vec![[a, b, x], [a, x, c]],
            [None, Some(y), None] => vec![[b, c, y], [b, y, a]],
            [None, None, Some(z)] => vec![[c, a, z], [c, z, b]],
            [Some(x), Some(y), None] => vec![[y, x, c], [a, b, x], [a, x, y]],
            [None, Some(y), Some(z)] => vec![[z, y, a], [b, c, y], [b, y, z]],
            [Some(x), None, Some(z)] => vec![[x, z, b], [c, a, z], [c, z, x]],
            [Some(x), Some(y), Some(z)] => vec![[a, z, y], [z, b, x], [y, x, c], [x, y, z]],
        };
        if parts.is_empty() {
            self.pieces.count.pieces += 1;
            let error = off[0].max(off[1]).max(off[2]).max(inside);
            self.pieces.count.error = self.pieces.count.error.max(error);
            return;
        }
        let first = self.pieces.nodes.len();
        self.pieces.nodes[node].first = first as u32;
        self.pieces.nodes[node].parts = parts.len() as u32;
        let part = |corners| Node { corners, first: 0, parts: 0 };
        self.pieces.nodes.extend(parts.iter().copied().map(part));
        for number in 0..parts.len() {
            self.divide(first + number, depth + 1);
        }
    }
}

/// The mean of three values by weight.
pub(crate) fn mixed([a, b, c]: [[f32; 3]; 3], weights: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|axis| a[axis] * weights[0] + b[axis] * weights[1] + c[axis] * weights[2])
}

/// encode(clamp(v, 0, 1)), to about a hundredth of a step of 8 bits.
pub(crate) fn encoded(encoding: PictureEncoding, light: f32) -> f32 {
    let unit = if light > 0.0 { light.min(1.0) } else { 0.0 };
    match encoding {
        PictureEncoding::None => unit,
        PictureEncoding::Srgb if unit <= 0.003_130_8 => 12.92 * unit,
        PictureEncoding::Srgb => 1.055 * elementary::power(unit, 1.0 / 2.4) - 0.055,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(tolerance: f32, light: impl Fn(Place) -> [f32; 3]) -> Pieces {
        Pieces::new(Asked {
            tolerance,
            encoding: PictureEncoding::None,
            light: &mut |place| light(place),
            window: &|[_, v, w]| Some([f64::from(v) * 300.0, f64::from(w) * 300.0]),
        })
    }

    /// A narrow highlight in the middle, which no corner and no edge sees.
    fn highlight([_, v, w]: Place) -> [f32; 3] {
        let (x, y) = (v - 0.3, w - 0.3);
        [1.0 / (1.0 + 60.0 * (x * x + y * y)), 0.2, 0.0]
    }

    #[test]
    fn even_light_needs_one_piece() {
        let even = pieces(0.5, |[_, v, w]| [v, w, 0.5]);
        assert_eq!(even.count.pieces, 1);
        assert!(even.count.error < 1e-3);
    }

    #[test]
    fn the_interpolated_light_is_within_the_tolerance_everywhere() {
        for tolerance in [0.5, 2.0, 8.0] {
            let pieces = pieces(tolerance, highlight);
            assert!(pieces.count.pieces > 10 && pieces.count.error <= tolerance);
            for row in 0..=97 {
                for column in 0..=97 - row {
                    let [v, w] = [row, column].map(|at| at as f32 / 97.0);
                    let place = [1.0 - v - w, v, w];
                    let (got, wanted) = (pieces.light(place), highlight(place));
                    let off = 255.0 * (got[0] - wanted[0]).abs();
                    // What was tried is within; between, a little more is allowed.
                    assert!(off <= tolerance * 1.5 + 0.1, "{place:?}: {off} of {tolerance}");
                }
            }
        }
    }

    #[test]
    fn a_finer_tolerance_takes_more_pieces() {
        let count = |tolerance| pieces(tolerance, highlight).count.pieces;
        assert!(count(0.5) > 2 * count(4.0));
    }

    #[test]
    fn a_piece_holds_its_place() {
        let pieces = pieces(1.0, highlight);
        let place = [0.41, 0.28, 0.31];
        let (corners, weights) = pieces.piece(place);
        let back = mixed(corners, weights);
        assert!(back.iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-5), "{back:?}");
    }
}
