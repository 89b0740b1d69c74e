//! Recursive subdivision: a triangle into pieces so small that interpolating the light between
//! their corners gives what lighting every pixel would give, to a tolerance.
//!
//! An edge is halved if the light at places along it differs from what its ends interpolate to, and
//! the longest edge with any other, so that no slivers arise. Where the edges are fine and the inside
//! is not, all three are halved. What seems fine so is tried once more, at places so close together
//! that no pixel goes without, before it becomes a piece. The largest difference found there, with a
//! reserve for what lies between, is the bound that [`PieceCount`] holds. Neighbours may decide
//! differently about an edge that is fine; the seam is then within the tolerance. Edges shorter than a
//! small part of a pixel stay whole: there the light jumps, as at the edge of a cone, or as a highlight
//! does where N.L becomes 0. [`PieceCount`] has the number of pieces that are beyond the tolerance for
//! that, and their area.

use super::texel_light::TexelLight;
use super::tries::{Comparison, Place, PlaceLight, Tries};
use luxel_math::LANES;
use std::collections::HashMap;

/// Pixels between the places where an edge or an inside is tried first.
const STEP: f64 = 6.0;
/// Pixels between the places where it is tried before it becomes a piece.
const FINE_STEP: f64 = 1.0;
/// What may be wrong where it is tried, as a part of the tolerance: in highlights of few pixels places
/// between are a little worse. In the demos, with exponents up to 100, one pixel in thirty thousand
/// was beyond the bound.
const RESERVE: f32 = 0.7;
/// Most of the fine places along a side.
const MOST_FINE: usize = 256;
/// Most places that are tried in one triangle; beyond, only the first steps are.
const MOST_TRIES: usize = 1 << 20;
/// Most places where an edge is tried: a highlight narrower than a part of a large triangle must
/// not slip through.
const MOST_TRIED: usize = 24;
/// Most places along a side of the grid where an inside is tried.
const MOST_INSIDE: usize = 12;
/// Edges shorter than this, in pixels, stay whole: the samples of a pixel lie no closer together.
const SHORTEST: f64 = 1.0 / 16.0;
/// How often pieces are divided again at most. Halving its longest edge makes a piece half as large,
/// so that two times make it half as long: enough from 256 pixels to the shortest.
const DEEPEST: u32 = 24;
/// Most places that are lit for one triangle.
const MOST_LIT: usize = 1 << 18;

/// How closely places are tried.
#[derive(Clone, Copy)]
struct Grid {
    /// Pixels between them.
    step: f64,
    most_along: usize,
    most_inside: usize,
    /// Only those that lie in the window.
    only_inside: bool,
}

const COARSE: Grid =
    Grid { step: STEP, most_along: MOST_TRIED, most_inside: MOST_INSIDE, only_inside: false };
const FINE: Grid =
    Grid { step: FINE_STEP, most_along: MOST_FINE, most_inside: MOST_FINE, only_inside: true };

impl Grid {
    /// How many places are tried along an edge of a length: an odd number, so that the middle is among them.
    fn along(&self, length: f64) -> usize {
        ((length / self.step) as usize).clamp(1, self.most_along) | 1
    }

    /// How many parts an extent of an inside has.
    fn inside(&self, extent: f64) -> usize {
        ((extent / self.step) as usize).min(self.most_inside)
    }
}

/// What the subdivision of one triangle came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PieceCount {
    /// The pieces.
    pub(crate) pieces: u32,
    /// The largest difference to lighting each place by itself, with the reserve, in steps of 8 bits.
    pub(crate) error: f32,
    /// Pieces that are beyond the tolerance and not divided further.
    pub(crate) beyond: u32,
    /// Their area in the window, in 1/65536 pixel.
    pub(crate) beyond_area: u64,
}

/// A triangle's pieces.
#[derive(Clone, Debug)]
pub(crate) struct Pieces {
    places: Vec<(Place, TexelLight)>,
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
pub(crate) struct Asked<'a, L> {
    /// In steps of 8 bits.
    pub(crate) tolerance: f32,
    pub(crate) light: &'a L,
    /// How it is compared: under texels that it must be within the tolerance of.
    pub(crate) comparison: Comparison<'a>,
    /// Where a place lies in the window, in pixels; `None` if it isn't before the eye.
    pub(crate) window: &'a dyn Fn(Place) -> Option<[f64; 2]>,
    /// The window's width and height: what lies outside needs no second try.
    pub(crate) size: [f64; 2],
}

struct Builder<'a, L> {
    asked: Asked<'a, L>,
    pieces: Pieces,
    /// Where the pieces' places lie in the window.
    windows: Vec<Option<[f64; 2]>>,
    /// Places that are lit already, by the bits of their first two barycentrics.
    known: HashMap<[u32; 2], u32>,
    /// Places that are tried together, and what of a piece each belongs to.
    tries: Tries,
    parts: [Part; LANES],
    /// How many places were tried.
    tried: usize,
}

/// A piece that is tried. Its longest edge goes from the first corner to the second.
struct Tried {
    corners: [u32; 3],
    /// Of the edges that go from each corner to the next.
    lengths: [f64; 3],
    /// Above the longest edge.
    height: f64,
    /// Of the edges: the largest error, or any that is more than enough.
    off: [f32; 3],
    /// The same of the inside, where the edges' isn't more than enough.
    inside: f32,
    /// The light in the middle of edges, where it is known.
    middles: [Option<TexelLight>; 3],
    /// How much is enough to know.
    enough: f32,
}

impl Tried {
    /// Whether the fine grid has places that the coarse one lacks.
    fn is_finer_tried(&self) -> bool {
        let is_longer = |length: &f64| FINE.along(*length) > COARSE.along(*length);
        self.lengths.iter().any(is_longer) || FINE.inside(self.height) > 1
    }

    /// Whether an edge will be halved: then the inside makes no difference.
    fn is_rough(&self) -> bool {
        self.off.iter().any(|off| *off > self.enough)
    }
}

/// What of a piece a place belongs to.
#[derive(Clone, Copy)]
enum Part {
    Edge { edge: usize, is_middle: bool },
    Inside,
}

impl Pieces {
    pub(crate) fn new<L: PlaceLight>(asked: Asked<'_, L>) -> Self {
        let count = PieceCount { pieces: 0, error: 0.0, beyond: 0, beyond_area: 0 };
        let pieces = Self { places: Vec::new(), nodes: Vec::new(), count };
        let (windows, known, tries) = (Vec::new(), HashMap::new(), Tries::new());
        let parts = [Part::Inside; LANES];
        let mut builder = Builder { asked, pieces, windows, known, tries, parts, tried: 0 };
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .map(|place| builder.lit(place, None));
        builder.pieces.nodes.push(Node { corners, first: 0, parts: 0 });
        builder.divide(0, 0);
        let mut pieces = builder.pieces;
        pieces.places.shrink_to_fit();
        pieces.nodes.shrink_to_fit();
        pieces
    }

    /// The corners of the piece that holds a place, by number, and the place's barycentrics in it.
    pub(crate) fn piece(&self, place: Place) -> ([(u32, Place); 3], [f32; 3]) {
        let (corners, weights) = self.find(place);
        (corners.map(|corner| (corner, self.places[corner as usize].0)), weights)
    }

    /// The interpolated light at a place, under a texel.
    pub(crate) fn light(&self, place: Place, texel: [f32; 3]) -> [f32; 3] {
        let (corners, weights) = self.find(place);
        let corners = corners.map(|corner| &self.places[corner as usize].1);
        TexelLight::mixed(corners, weights).at(texel)
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

impl<L: PlaceLight> Builder<'_, L> {
    /// The number of a place, lit once: with `light`, if that is known.
    fn lit(&mut self, place: Place, light: Option<TexelLight>) -> u32 {
        let key = [place[0].to_bits(), place[1].to_bits()];
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let Asked { light: places, comparison, .. } = &self.asked;
        let light = light.unwrap_or_else(|| self.tries.light_alone(place, *places, comparison));
        let number = self.pieces.places.len() as u32;
        self.pieces.places.push((place, light));
        self.windows.push((self.asked.window)(place));
        self.known.insert(key, number);
        number
    }

    fn place(&self, number: u32) -> Place {
        self.pieces.places[number as usize].0
    }

    /// Whether a place lies in the window, or within a pixel of it.
    fn is_inside(&self, place: Place) -> bool {
        let inside = |at: f64, side: f64| (-1.0..side + 1.0).contains(&at);
        let [width, height] = self.asked.size;
        (self.asked.window)(place).is_some_and(|[x, y]| inside(x, width) && inside(y, height))
    }

    /// An edge's length in the window; very long if an end isn't before the eye.
    fn length(&self, from: u32, to: u32) -> f64 {
        let (Some(p), Some(q)) = (self.windows[from as usize], self.windows[to as usize]) else {
            return f64::from(u16::MAX);
        };
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        (x * x + y * y).sqrt()
    }

    /// A triangle's area in the window, in pixels; `None` if a corner isn't before the eye.
    fn area(&self, corners: [u32; 3]) -> Option<f64> {
        let place = |corner: u32| self.windows[corner as usize];
        let (a, b, c) = (place(corners[0])?, place(corners[1])?, place(corners[2])?);
        Some(((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs() / 2.0)
    }

    /// A triangle's height over its base; the base if a corner isn't before the eye.
    fn height(&self, corners: [u32; 3], base: f64) -> f64 {
        match self.area(corners) {
            Some(area) if base > 0.0 => 2.0 * area / base,
            _ => base,
        }
    }

    /// Tries a piece at the places of a grid. The inside is tried along rows above the base, so that places are as
    /// dense in the window in every direction.
    fn try_piece(&mut self, piece: &mut Tried, grid: Grid) {
        for edge in 0..3 {
            let count = grid.along(piece.lengths[edge]);
            for at in 1..=count {
                if piece.off[edge] > piece.enough {
                    break;
                }
                let t = at as f32 / (count + 1) as f32;
                let mut weights = [0.0; 3];
                (weights[edge], weights[(edge + 1) % 3]) = (1.0 - t, t);
                let is_middle = 2 * at == count + 1;
                self.try_place(piece, weights, Part::Edge { edge, is_middle }, grid);
            }
        }
        let rows = grid.inside(piece.height);
        // Of small pieces all places fit together.
        if rows > 1 || piece.is_rough() {
            self.compare(piece);
        }
        if piece.is_rough() {
            return;
        }
        self.try_place(piece, [1.0 / 3.0; 3], Part::Inside, grid);
        for row in 1..rows {
            let up = row as f32 / rows as f32;
            let columns = grid.inside(piece.lengths[0] * f64::from(1.0 - up));
            for column in 1..columns {
                if piece.inside > piece.enough {
                    break;
                }
                let along = column as f32 / columns as f32;
                let weights = [(1.0 - up) * (1.0 - along), (1.0 - up) * along, up];
                self.try_place(piece, weights, Part::Inside, grid);
            }
        }
        self.compare(piece);
    }

    /// Tries a place of a piece: at once, or together with others.
    fn try_place(&mut self, piece: &mut Tried, weights: [f32; 3], part: Part, grid: Grid) {
        let place = mixed(piece.corners.map(|corner| self.place(corner)), weights);
        if grid.only_inside && !self.is_inside(place) {
            return;
        }
        self.parts[self.tries.count() % LANES] = part;
        self.tries.push(weights, place);
        if self.tries.count() == LANES {
            self.compare(piece);
        }
    }

    /// Compares the places that wait.
    fn compare(&mut self, piece: &mut Tried) {
        let count = self.tries.count();
        self.tried += count;
        self.tries.compare(self.asked.light, &self.asked.comparison);
        for number in 0..count {
            let error = self.tries.error(number);
            match self.parts[number] {
                Part::Edge { edge, is_middle } => {
                    piece.off[edge] = piece.off[edge].max(error);
                    // The longest edge is halved with any other.
                    if is_middle && (edge == 0 || error > piece.enough) {
                        piece.middles[edge] = Some(self.tries.light(number));
                    }
                }
                Part::Inside => piece.inside = piece.inside.max(error),
            }
        }
    }

    fn divide(&mut self, node: usize, depth: u32) {
        let corners = self.pieces.nodes[node].corners;
        let [a, b, c] = corners;
        let tolerance = self.asked.tolerance * RESERVE;
        let may = depth < DEEPEST && self.pieces.places.len() < MOST_LIT;
        let edges = [[b, c], [c, a], [a, b]];
        let lengths = edges.map(|[from, to]| self.length(from, to));
        let longest = lengths[0].max(lengths[1]).max(lengths[2]);
        let may = may && longest > SHORTEST;
        let base = lengths.iter().position(|length| *length >= longest).unwrap_or_default();
        let over_base = [edges[base][0], edges[base][1], corners[base]];
        let mut piece = Tried {
            corners: over_base,
            lengths: [lengths[base], lengths[(base + 1) % 3], lengths[(base + 2) % 3]],
            height: self.height(over_base, longest),
            off: [0.0; 3],
            inside: 0.0,
            middles: [None; 3],
            // How much more is only of interest where nothing can be divided.
            enough: if may { tolerance } else { f32::INFINITY },
        };
        self.tries.begin(over_base.map(|corner| self.pieces.places[corner as usize].1));
        self.try_piece(&mut piece, COARSE);
        let is_fine = piece.off.iter().all(|off| *off <= tolerance) && piece.inside <= tolerance;
        if is_fine && self.tried < MOST_TRIES && piece.is_finer_tried() {
            self.try_piece(&mut piece, FINE);
        }
        let Tried { off, inside, middles, .. } = piece;
        let of_edge = |at: usize| (at + 3 - base) % 3;
        let rough = [0, 1, 2].map(|at| off[of_edge(at)] > tolerance && may);
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
                let middle = mixed(ends, [0.5, 0.5, 0.0]);
                halved[at] = Some(self.lit(middle, middles[of_edge(at)]));
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
            self.pieces.count.error = self.pieces.count.error.max(error / RESERVE);
            if error > tolerance {
                self.pieces.count.beyond += 1;
                let area = (self.area(corners).unwrap_or_default() * 65_536.0) as u64;
                let all = self.pieces.count.beyond_area.saturating_add(area);
                self.pieces.count.beyond_area = all;
            }
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

#[cfg(test)]
pub(super) mod tests;
