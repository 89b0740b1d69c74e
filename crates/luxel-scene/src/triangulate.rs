//! From a polygon to triangles: fans where they serve, ears cut off where they don't.
//!
//! Any polygon of n corners gives exactly n - 2 triangles with its orientation, so that triangle
//! indices follow from the file alone. A polygon is projected along the axis in which its
//! normal (Newell's; Sutherland, Sproull and Schumacker 1974, appendix) is longest: that leaves
//! coordinates as they are, so orientation tests can be exact (Shewchuk 1997).
//!
//! - All triangles of the fan from corner 0 are counter-clockwise: the fan it is. That covers
//!   every convex polygon without corners on a straight edge.
//! - Otherwise ears are cut off (Meisters 1975). Only corners that aren't convex can stand in an
//!   ear's way; they are kept sorted by x, so a small ear asks few of them. Holes that are joined
//!   to the outline by a bridge visit places twice: a corner at a place of the ear's own is in the
//!   way only if one of its edges runs into the ear.
//! - A polygon that crosses itself has no right answer. Demands are dropped one by one, so that
//!   the count of triangles holds all the same.

use robust::{Coord, orient2d};

/// The number of tests whether a corner lies in an ear, per corner of a polygon on average, before
/// ears are cut without that test. A comb of a hundred thousand teeth needs about ten, a long spiral
/// hundreds; the bound is there for polygons that cross themselves.
const TESTS_PER_CORNER: usize = 1_000;

/// How many ears are examined, for each corner on average, before corners are cut without any
/// examination. A polygon that doesn't cross itself needs about four.
const EARS_PER_CORNER: usize = 64;

/// Polygons with fewer corners than this get the bounds of one with so many.
const LEAST_CORNERS: usize = 10_000;

/// Cuts a polygon into triangles, named by its corners, and appends them: exactly n - 2 for n
/// corners, with the polygon's orientation; none for fewer than three corners.
///
/// Concave polygons, corners on straight edges, repeated corners and holes joined by a bridge are
/// cut without overlap. A polygon that crosses itself, has no area or holds a number that isn't
/// finite gives some n - 2 triangles.
///
/// ```
/// let arrow_head = [[0.0, 0.0, 0.0], [2.0, -1.0, 0.0], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
/// let mut triangles = Vec::new();
/// luxel_scene::triangulate(&arrow_head, &mut triangles);
/// assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
/// ```
pub fn triangulate(corners: &[[f64; 3]], triangles: &mut Vec<[u32; 3]>) {
    let count = corners.len();
    if count > 3
        && u32::try_from(count).is_ok()
        && let Some(axes) = axes_of_sight(corners)
        && !fan_is_valid(corners, axes)
    {
        let flat: Vec<_> = corners.iter().map(|corner| flattened(corner, axes)).collect();
        Clipping::new(&flat).run(triangles);
    } else {
        triangles.extend((1..count.max(2) as u32 - 1).map(|corner| [0, corner, corner + 1]));
    }
}

/// The polygon's normal, twice its area long: the sum of the cross products of neighbouring
/// corners, taken about the first one.
fn newell_normal(corners: &[[f64; 3]]) -> [f64; 3] {
    let [x, y, z] = corners[0];
    let mut normal = [0.0; 3];
    for pair in corners[1..].windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|corner| [corner[0] - x, corner[1] - y, corner[2] - z]);
        normal[0] += a[1] * b[2] - a[2] * b[1];
        normal[1] += a[2] * b[0] - a[0] * b[2];
        normal[2] += a[0] * b[1] - a[1] * b[0];
    }
    normal
}

/// The two axes that lie across and up when the polygon is seen along its normal's longest axis,
/// from the side from which it runs counter-clockwise; `None` if there is no such side.
fn axes_of_sight(corners: &[[f64; 3]]) -> Option<[usize; 2]> {
    let normal = newell_normal(corners);
    let [x, y, z] = normal.map(f64::abs);
    let axis = if z >= x && z >= y {
        2
    } else if y >= x {
        1
    } else {
        0
    };
    if !(x + y + z).is_finite() || normal[axis] == 0.0 {
        return None;
    }
    let [first, second] = [(axis + 1) % 3, (axis + 2) % 3];
    Some(if normal[axis] > 0.0 { [first, second] } else { [second, first] })
}

fn flattened(corner: &[f64; 3], [across, up]: [usize; 2]) -> Coord<f64> {
    Coord { x: corner[across], y: corner[up] }
}

/// Whether all triangles from corner 0 are counter-clockwise, which makes a polygon that doesn't
/// cross itself visible from corner 0 as a whole.
fn fan_is_valid(corners: &[[f64; 3]], axes: [usize; 2]) -> bool {
    let place = |corner: usize| flattened(&corners[corner], axes);
    (2..corners.len()).all(|corner| orient2d(place(0), place(corner - 1), place(corner)) > 0.0)
}

/// The requirements of an ear; later ones apply only if no better ear is left.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Demand {
    /// Counter-clockwise, and no corner in or on it.
    Clear,
    /// Counter-clockwise, and no corner in it; corners on its edges don't run into it.
    Touched,
    /// Without area: taking away a corner on a straight edge changes nothing.
    Flat,
    /// Counter-clockwise.
    Convex,
    /// Nothing.
    Any,
}

impl Demand {
    const fn next(self) -> Self {
        match self {
            Self::Clear => Self::Touched,
            Self::Touched => Self::Flat,
            Self::Flat => Self::Convex,
            Self::Convex | Self::Any => Self::Any,
        }
    }
}

/// A polygon of which ears are being cut off.
struct Clipping<'a> {
    flat: &'a [Coord<f64>],
    /// The corners before and after each corner that is left.
    previous: Vec<u32>,
    next: Vec<u32>,
    /// Whether a corner is left and not convex.
    blunt: Vec<bool>,
    /// The corners that weren't convex at the start, by x and then number.
    sorted: Vec<u32>,
    /// Corners to be looked at.
    candidates: Vec<u32>,
    is_candidate: Vec<bool>,
    /// The tests of corners that are left: see [`TESTS_PER_CORNER`].
    tests_left: usize,
    /// The examinations of ears that are left: see [`EARS_PER_CORNER`].
    ears_left: usize,
}

impl<'a> Clipping<'a> {
    fn new(flat: &'a [Coord<f64>]) -> Self {
        let count = flat.len() as u32;
        let mut clipping = Self {
            flat,
            previous: (0..count).map(|corner| (corner + count - 1) % count).collect(),
            next: (0..count).map(|corner| (corner + 1) % count).collect(),
            blunt: Vec::new(),
            sorted: Vec::new(),
            // The last one is looked at first: ears are then cut in the order of corners.
            candidates: (0..count).rev().collect(),
            is_candidate: vec![true; flat.len()],
            tests_left: flat.len().max(LEAST_CORNERS).saturating_mul(TESTS_PER_CORNER),
            ears_left: flat.len().max(LEAST_CORNERS).saturating_mul(EARS_PER_CORNER),
        };
        clipping.blunt = (0..count).map(|corner| clipping.turn(corner) <= 0.0).collect();
        clipping.sorted = (0..count).filter(|&corner| clipping.blunt[corner as usize]).collect();
        let x = |&corner: &u32| flat[corner as usize].x;
        clipping.sorted.sort_by(|a, b| x(a).total_cmp(&x(b)).then(a.cmp(b)));
        clipping
    }

    fn run(mut self, triangles: &mut Vec<[u32; 3]>) {
        let mut left = self.flat.len();
        let mut demand = Demand::Clear;
        let mut some_corner = 0;
        let mut cuts_since_compacted = 0;
        while left > 3 {
            let Some(corner) = self.candidates.pop() else {
                // Everything left was looked at in vain.
                demand = demand.next();
                if self.tests_left == 0 {
                    demand = demand.max(Demand::Convex);
                }
                self.look_at_all_again(some_corner, left);
                continue;
            };
            if !std::mem::replace(&mut self.is_candidate[corner as usize], false)
                || !self.is_ear(corner, demand)
            {
                continue;
            }
            let (before, after) = (self.previous[corner as usize], self.next[corner as usize]);
            triangles.push([before, corner, after]);
            self.cut(corner);
            left -= 1;
            some_corner = after;
            cuts_since_compacted += 1;
            if cuts_since_compacted > 64 && cuts_since_compacted * 4 > self.sorted.len() {
                self.sorted.retain(|&corner| self.blunt[corner as usize]);
                cuts_since_compacted = 0;
            }
            demand = self.first_demand();
        }
        let (before, after) =
            (self.previous[some_corner as usize], self.next[some_corner as usize]);
        triangles.push([before, some_corner, after]);
    }

    /// What an ear has to meet first, after another one was cut.
    fn first_demand(&self) -> Demand {
        match (self.ears_left, self.tests_left) {
            (0, _) => Demand::Any,
            (_, 0) => Demand::Convex,
            _ => Demand::Clear,
        }
    }

    /// Takes a corner out; its neighbours' ears may have changed, nobody else's have.
    fn cut(&mut self, corner: u32) {
        let (before, after) = (self.previous[corner as usize], self.next[corner as usize]);
        self.next[before as usize] = after;
        self.previous[after as usize] = before;
        self.blunt[corner as usize] = false;
        for neighbour in [before, after] {
            let index = neighbour as usize;
            // A corner never turns blunt again in a polygon that doesn't cross itself.
            self.blunt[index] = self.blunt[index] && self.turn(neighbour) <= 0.0;
            if !std::mem::replace(&mut self.is_candidate[index], true) {
                // Looked at last, for ears that don't all share a corner.
                self.candidates.push(neighbour);
            }
        }
    }

    fn look_at_all_again(&mut self, start: u32, left: usize) {
        let mut corner = start;
        for _ in 0..left {
            corner = self.previous[corner as usize];
            self.is_candidate[corner as usize] = true;
            self.candidates.push(corner);
        }
    }

    fn place(&self, corner: u32) -> Coord<f64> {
        self.flat[corner as usize]
    }

    /// Positive at convex corners, 0 on straight edges and spikes, negative at reflex corners.
    fn turn(&self, corner: u32) -> f64 {
        let (before, after) = (self.previous[corner as usize], self.next[corner as usize]);
        orient2d(self.place(before), self.place(corner), self.place(after))
    }

    fn is_ear(&mut self, corner: u32, demand: Demand) -> bool {
        self.ears_left = self.ears_left.saturating_sub(1);
        if self.ears_left == 0 {
            return true;
        }
        let turn = self.turn(corner);
        match demand {
            Demand::Any => true,
            Demand::Convex => turn > 0.0,
            Demand::Flat if turn == 0.0 => true,
            _ => turn > 0.0 && !self.is_blocked(corner, demand == Demand::Clear),
        }
    }

    /// Whether a corner blocks cutting off the ear at `tip`. `touching` counts those
    /// that lie on its edges, too.
    fn is_blocked(&mut self, tip: u32, touching: bool) -> bool {
        let ear = [self.previous[tip as usize], tip, self.next[tip as usize]];
        let places = ear.map(|corner| self.place(corner));
        let [a, b, c] = places;
        let (left, right) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
        let (low, high) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        let start = self.sorted.partition_point(|&corner| self.place(corner).x < left);
        for index in start..self.sorted.len() {
            let corner = self.sorted[index];
            let place = self.place(corner);
            if place.x > right || self.tests_left == 0 {
                return false;
            }
            self.tests_left -= 1;
            if place.y < low
                || place.y > high
                || !self.blunt[corner as usize]
                || ear.contains(&corner)
            {
                continue;
            }
            let sides = [orient2d(a, b, place), orient2d(b, c, place), orient2d(c, a, place)];
            if sides.iter().any(|&side| side < 0.0) {
                continue;
            }
            if sides.iter().all(|&side| side > 0.0) {
                return true;
            }
            let shared = places.iter().position(|&own| own == place);
            if touching && shared.is_none()
                || self.runs_into(corner, places, sides)
                || shared.is_some_and(|at| self.shuts_out(corner, places, at))
            {
                return true;
            }
        }
        false
    }

    /// Whether one of the two edges at a corner that lies on an ear's boundary runs into the ear:
    /// its other end is inside of all of the ear's edges that the corner lies on.
    fn runs_into(&self, corner: u32, [a, b, c]: [Coord<f64>; 3], sides: [f64; 3]) -> bool {
        let edges = [(a, b), (b, c), (c, a)];
        [self.previous[corner as usize], self.next[corner as usize]].into_iter().any(|end| {
            let end = self.place(end);
            edges
                .iter()
                .zip(sides)
                .all(|(&(from, to), side)| side != 0.0 || orient2d(from, to, end) > 0.0)
        })
    }

    /// Whether the polygon's outside at a reflex corner covers the whole of an ear that has a
    /// corner at the same place: so it is where the rest of a polygon goes forth and back.
    fn shuts_out(&self, corner: u32, ear: [Coord<f64>; 3], at: usize) -> bool {
        let apex = ear[at];
        // Directions in counter-clockwise order: outside, ear, outside.
        let rays = [
            self.place(self.previous[corner as usize]),
            ear[(at + 1) % 3],
            ear[(at + 2) % 3],
            self.place(self.next[corner as usize]),
        ];
        let turn = |from: usize, to: usize| orient2d(apex, rays[from], rays[to]);
        turn(0, 3) > 0.0
            && turn(0, 2) > 0.0
            && turn(1, 3) > 0.0
            && turn(0, 1) >= 0.0
            && turn(2, 3) >= 0.0
    }
}

#[cfg(test)]
mod tests;
