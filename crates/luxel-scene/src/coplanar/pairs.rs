//! Pairs of triangles of different objects that overlap in one plane.

use super::{Body, Candidate, Facet, is_same, meet};
use glam::{DVec2, DVec3};

/// Pairs among triangles whose planes are of one class, as keys: the later candidate's number in the upper
/// bits, the earlier one's in the lower.
pub(super) struct Pairs<'c> {
    /// With the candidates that they are, and their places, in the order of the scene.
    pub(super) triangles: &'c [(u32, &'c Candidate, Facet)],
    pub(super) bodies: &'c [Body<'c>],
    pub(super) found: &'c mut Vec<u64>,
}

/// So few are compared with one another.
const FEW: usize = 32;
/// Pairs of one triangle with earlier ones in one cell, at most: more don't lift it higher.
const MOST_PAIRS: usize = 32;

impl Pairs<'_> {
    /// Compares triangles, given by their places in ascending order.
    ///
    /// Many are divided in halves along a side of their box, again and again; what lies in both halves goes
    /// into both.
    pub(super) fn of(&mut self, places: &[u32]) {
        if places.len() > FEW
            && let Some(halves) = self.halves(places)
        {
            halves.iter().for_each(|half| self.of(half));
        } else {
            self.compare(places);
        }
    }

    /// Both halves along the longest side along which each has three quarters at most.
    fn halves(&self, places: &[u32]) -> Option<[Vec<u32>; 2]> {
        let bounds = |place: &u32| self.triangles[*place as usize].2.bounds();
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for place in places {
            let bounds = bounds(place);
            (low, high) = (low.min(bounds[0]), high.max(bounds[1]));
        }
        let sides = high - low;
        let mut axes = [0, 1, 2];
        axes.sort_by(|&a: &usize, &b| sides[b].total_cmp(&sides[a]));
        axes.into_iter().find_map(|axis| {
            let middle = |bounds: [DVec3; 2]| bounds[0][axis] + bounds[1][axis];
            let mut middles: Vec<f64> = places.iter().map(|at| middle(bounds(at))).collect();
            let half = middles.len() / 2;
            let (_, &mut divider, _) = middles.select_nth_unstable_by(half, f64::total_cmp);
            let divider = divider * 0.5;
            let below = places.iter().copied().filter(|at| bounds(at)[0][axis] <= divider);
            let above = places.iter().copied().filter(|at| bounds(at)[1][axis] >= divider);
            let halves: [Vec<u32>; 2] = [below.collect(), above.collect()];
            halves.iter().all(|half| half.len() * 4 <= places.len() * 3).then_some(halves)
        })
    }

    fn compare(&mut self, places: &[u32]) {
        for (at, &place) in places.iter().enumerate() {
            let (number, own, facet) = &self.triangles[place as usize];
            let mut pairs = 0;
            for &place in places[..at].iter().rev() {
                let (earlier, other, other_facet) = &self.triangles[place as usize];
                let is_repeated =
                    facet.corners == other_facet.corners && is_same([own, other], self.bodies);
                if is_repeated || other.object != own.object && overlap(other_facet, facet) {
                    self.found.push(u64::from(*number) << 32 | u64::from(*earlier));
                    pairs += 1;
                }
                // What lies before the one that it repeats has lifted that one as high.
                if is_repeated || pairs == MOST_PAIRS {
                    break;
                }
            }
        }
    }
}

impl Facet {
    /// Its box, with room for what rounding moved.
    fn bounds(&self) -> [DVec3; 2] {
        let [a, b, c] = self.corners;
        [a.min(b).min(c) - self.error, a.max(b).max(c) + self.error]
    }

    /// Whether another triangle lies in its plane, but for rounding.
    fn is_in_plane(&self, other: &Self) -> bool {
        let limit = 2.0 * (self.error + other.error);
        let is_near = |corner: &DVec3| self.normal.dot(*corner - self.corners[0]).abs() <= limit;
        other.corners.iter().all(is_near)
    }
}

/// Whether two triangles lie in one plane, and share more than an edge there.
fn overlap(a: &Facet, b: &Facet) -> bool {
    if !meet(&a.bounds(), &b.bounds()) {
        return false;
    }
    // A small one's plane is known less well than a large one's.
    if !a.is_in_plane(b) && !b.is_in_plane(a) {
        return false;
    }
    let [x, y, z] = a.normal.abs().to_array();
    let flat = |facet: &Facet| {
        facet.corners.map(|corner| {
            if x >= y && x >= z {
                DVec2::new(corner.y, corner.z)
            } else if y >= z {
                DVec2::new(corner.z, corner.x)
            } else {
                DVec2::new(corner.x, corner.y)
            }
        })
    };
    let (one, other) = (flat(a), flat(b));
    let limit = 2.0 * (a.error + b.error);
    !is_apart(&one, &other, limit) && !is_apart(&other, &one, limit)
}

/// Whether a side of a triangle has all of the other beyond it, or only so little on its own side.
fn is_apart(triangle: &[DVec2; 3], other: &[DVec2; 3], limit: f64) -> bool {
    (0..3).any(|at| {
        let [from, to, apex] = [0, 1, 2].map(|next| triangle[(at + next) % 3]);
        let inwards = (to - from).perp();
        let inwards = if inwards.dot(apex - from) < 0.0 { -inwards } else { inwards };
        let inwards = inwards.normalize_or_zero();
        other.iter().all(|corner| inwards.dot(*corner - from) <= limit)
    })
}
