//! Open seams of a surface: corners in the middle of edges, and gaps between edges.

use crate::kd_tree::{KdTree, MAX_RESULTS};
use crate::surface::{HalfEdge, Surface};
use luxel_parallel::{gather, sort_u64};
use luxel_scene::DVec3;

/// The largest distance of a corner from an edge that contains it, as a fraction of the edge's length: a
/// quarter of a pixel on an edge of a thousand pixels.
const BESIDE: f64 = 2.5e-4;

/// Rounding to f32, as a fraction of the mesh's extent.
const ROUNDING: f64 = 5e-7;

/// The largest width of an unintended gap, as a fraction of its shorter edge.
const GAP: f64 = 0.01;

/// Edges per task.
const RUN: usize = 1 << 8;

/// Open seams that should be closed.
#[derive(Default)]
pub(crate) struct Gaps {
    /// Corners in the middle of a neighbour's edge: place and edge.
    pub(crate) t_junctions: Vec<(u32, HalfEdge)>,
    /// Edges along a gap, each with its opposite.
    pub(crate) cracks: Vec<(HalfEdge, HalfEdge)>,
}

/// The boundary of a surface.
struct Boundary<'s, 'm> {
    surface: &'s Surface<'m>,
    half_edges: &'s [HalfEdge],
    /// Keys of both ends of each half-edge, sorted.
    at_places: Vec<u64>,
    nearby: KdTree,
}

/// Examines the boundary edges.
pub(crate) fn find(surface: &Surface<'_>, half_edges: &[HalfEdge]) -> Gaps {
    if half_edges.len() < 2 {
        return Gaps::default();
    }
    let mut at_places = Vec::with_capacity(2 * half_edges.len());
    for &half_edge in half_edges {
        at_places.extend(surface.ends(half_edge).map(|place| key(place, half_edge)));
    }
    sort_u64(&mut at_places);
    let mut places: Vec<u32> = at_places.iter().map(|key| (key >> 32) as u32).collect();
    places.dedup();
    let nearby = KdTree::new(places.into_iter().map(|at| (surface.at(at), at)).collect());
    let boundary = Boundary { surface, half_edges, at_places, nearby };
    Gaps { t_junctions: boundary.t_junctions(), cracks: boundary.cracks() }
}

/// A sort key: the place in the upper bits, the half-edge in the lower.
fn key(place: u32, half_edge: HalfEdge) -> u64 {
    u64::from(place) << 32 | u64::from(half_edge)
}

impl Boundary<'_, '_> {
    /// The half-edges that start or end at a place; a limited number of them.
    fn at(&self, place: u32) -> impl Iterator<Item = HalfEdge> {
        let first = self.at_places.partition_point(|other| *other < key(place, 0));
        let run = self.at_places[first..].iter();
        run.take_while(move |other| (*other >> 32) as u32 == place)
            .map(|key| *key as HalfEdge)
            .take(MAX_RESULTS)
    }

    /// The other end of a half-edge.
    fn beyond(&self, half_edge: HalfEdge, place: u32) -> u32 {
        let [from, to] = self.surface.ends(half_edge);
        if from == place { to } else { from }
    }

    fn t_junctions(&self) -> Vec<(u32, HalfEdge)> {
        let of_edge = |half_edge: HalfEdge, found: &mut Vec<u32>, junctions: &mut Vec<u64>| {
            let ends = self.surface.ends(half_edge);
            let [from, to] = ends.map(|place| self.surface.at(place));
            let reach = BESIDE * from.distance(to) + ROUNDING * self.surface.extent;
            self.nearby.along(from, to, reach, found);
            let is_on = |place: u32| ends.contains(&place) || found.binary_search(&place).is_ok();
            let is_inside = |place: u32| {
                let at = self.surface.at(place);
                at.distance(from) > 2.0 * reach && at.distance(to) > 2.0 * reach
            };
            // The neighbour's edge continues along this one; otherwise the two only touch.
            let goes_along = |place: u32| {
                self.at(place).any(|other| other != half_edge && is_on(self.beyond(other, place)))
            };
            let corners = found.iter().copied();
            let corners = corners.filter(|&place| !ends.contains(&place) && is_inside(place));
            let corners = corners.filter(|&place| goes_along(place));
            junctions.extend(corners.map(|place| key(place, half_edge)));
        };
        let mut junctions = gather(self.half_edges.len(), RUN, &|run, junctions| {
            let mut found = Vec::new();
            for &half_edge in &self.half_edges[run] {
                of_edge(half_edge, &mut found, junctions);
            }
        });
        sort_u64(&mut junctions);
        junctions.dedup_by_key(|key| *key >> 32);
        junctions.into_iter().map(|key| ((key >> 32) as u32, key as HalfEdge)).collect()
    }

    /// Whether the surface itself lies between two boundary edges: the first one's triangle, thin as it is,
    /// reaches no farther than the other edge, on that edge's side.
    ///
    /// A strip has two boundary edges close to each other, as a gap has, but no gap.
    fn bounds_strip(&self, half_edge: HalfEdge, other: HalfEdge) -> bool {
        /// The width of the strip may be rounded.
        const TOLERANCE: f64 = 1.01;
        let [from, to] = self.surface.ends(half_edge).map(|place| self.surface.at(place));
        let Some(axis) = (to - from).try_normalize() else { return false };
        let from_edge = |place: DVec3| (place - from).reject_from_normalized(axis);
        let apex = from_edge(self.surface.at(self.surface.apex(half_edge)));
        let ends = self.surface.ends(other).map(|place| from_edge(self.surface.at(place)));
        ends.into_iter().any(|end| apex.dot(end) > 0.0 && apex.length() <= TOLERANCE * end.length())
    }

    fn cracks(&self) -> Vec<(HalfEdge, HalfEdge)> {
        let of_edge = |half_edge: HalfEdge, found: &mut Vec<u32>| {
            let [from, to] = self.surface.ends(half_edge);
            let [at_from, at_to] = [from, to].map(|place| self.surface.at(place));
            let length = at_from.distance(at_to);
            let reach = GAP * length;
            self.nearby.along(at_from, at_from, reach, found);
            let is_beyond_gap = |other: &HalfEdge| {
                let [other_from, other_to] = self.surface.ends(*other);
                let is_narrow = |[one, two]: [DVec3; 2]| {
                    let other_length =
                        self.surface.at(other_from).distance(self.surface.at(other_to));
                    one.distance(two) <= GAP * length.min(other_length)
                };
                // The opposite edge runs the other way, or the same way if it is flipped.
                let ends = [self.surface.at(other_from), self.surface.at(other_to)];
                let across = is_narrow([at_from, ends[1]]) && is_narrow([at_to, ends[0]]);
                let along = is_narrow([at_from, ends[0]]) && is_narrow([at_to, ends[1]]);
                *other != half_edge
                    && (across || along)
                    && !self.bounds_strip(half_edge, *other)
                    && !self.bounds_strip(*other, half_edge)
            };
            let near = found.iter().flat_map(|&place| self.at(place));
            let partner = near.filter(is_beyond_gap).min();
            // Reported once, from the lower half-edge.
            partner.filter(|&partner| half_edge < partner).map(|partner| (half_edge, partner))
        };
        gather(self.half_edges.len(), RUN, &|run, cracks| {
            let mut found = Vec::new();
            cracks.extend(
                self.half_edges[run].iter().filter_map(|&half_edge| of_edge(half_edge, &mut found)),
            );
        })
    }
}
