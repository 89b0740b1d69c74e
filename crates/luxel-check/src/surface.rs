//! A mesh as a surface: triangles over places, and their adjacency by edges.
//!
//! A *place* is a position, or several with equal coordinates, as in
//! [`Topology`](luxel_scene::Topology): files split positions where attributes change, and a seam
//! of texture coordinates isn't a gap.

use luxel_parallel::{fill, gather, sort_u128};
use luxel_scene::{DVec3, Mesh, weld};

/// Triangles per task.
pub(crate) const RUN: usize = 1 << 12;

/// A mesh as a surface.
pub(crate) struct Surface<'m> {
    pub(crate) mesh: &'m Mesh,
    /// The places of each triangle's corners.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The diagonal of the triangles' bounds.
    pub(crate) extent: f64,
}

/// An edge of a triangle: from corner k to corner k + 1 of triangle t, numbered 3 t + k.
pub(crate) type HalfEdge = u32;

/// A sort key of a half-edge: its lower place, its higher place, zero, and the half-edge, 32 bits each.
pub(crate) type EdgeKey = u128;

/// The half-edge of a key.
#[inline]
pub(crate) const fn half_edge_of(key: EdgeKey) -> HalfEdge {
    key as u32
}

/// The half-edges of a surface, sorted by their places.
pub(crate) struct Edges {
    sorted: Vec<EdgeKey>,
}

impl<'m> Surface<'m> {
    pub(crate) fn of(mesh: &'m Mesh) -> Self {
        let places = weld(&mesh.positions);
        // Half-edges have 32-bit indices.
        let most = mesh.triangles.len().min((u32::MAX / 3) as usize);
        let mut triangles = vec![[0; 3]; most];
        fill(&mut triangles, RUN, &|start, run| {
            for (triangle, corners) in run.iter_mut().zip(&mesh.triangles[start..]) {
                *triangle = corners.map(|corner| places[corner as usize]);
            }
        });
        let bounds = mesh.bounds(&luxel_scene::DMat4::IDENTITY);
        let extent = if bounds.is_empty() { 0.0 } else { 2.0 * bounds.radius() };
        Self { mesh, triangles, extent }
    }

    /// A place relative to the mesh's origin, exact in f64.
    #[inline]
    pub(crate) fn at(&self, place: u32) -> DVec3 {
        let [x, y, z] = self.mesh.positions[place as usize];
        DVec3::new(f64::from(x), f64::from(y), f64::from(z))
    }

    /// The corners of a triangle.
    #[inline]
    pub(crate) fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|place| self.at(place))
    }

    /// Twice the area along the normal.
    #[inline]
    pub(crate) fn area_vector(&self, triangle: u32) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(c - a)
    }

    /// The places at the ends of a half-edge, in its direction.
    #[inline]
    pub(crate) fn ends(&self, half_edge: HalfEdge) -> [u32; 2] {
        let corners = self.triangles[(half_edge / 3) as usize];
        let k = (half_edge % 3) as usize;
        [corners[k], corners[(k + 1) % 3]]
    }

    /// The place opposite a half-edge in its triangle.
    #[inline]
    pub(crate) fn apex(&self, half_edge: HalfEdge) -> u32 {
        self.triangles[(half_edge / 3) as usize][(half_edge as usize % 3 + 2) % 3]
    }
}

impl Edges {
    /// The half-edges of all triangles that aren't excluded.
    pub(crate) fn of(surface: &Surface<'_>, is_excluded: &[bool]) -> Self {
        let mut sorted = gather(surface.triangles.len(), RUN, &|run, sides| {
            for triangle in run.filter(|&triangle| !is_excluded[triangle]) {
                for half_edge in 3 * triangle as u32..3 * triangle as u32 + 3 {
                    let [a, b] = surface.ends(half_edge);
                    if a != b {
                        let places = u128::from(a.min(b)) << 96 | u128::from(a.max(b)) << 64;
                        sides.push(places | u128::from(half_edge));
                    }
                }
            }
        });
        sort_u128(&mut sorted);
        Self { sorted }
    }

    /// The edges, each as its half-edges.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &[EdgeKey]> {
        self.sorted.chunk_by(|one, other| one >> 64 == other >> 64)
    }

    /// The half-edges without a neighbour, in order of their places.
    pub(crate) fn boundary(&self) -> Vec<HalfEdge> {
        self.iter().filter(|edge| edge.len() == 1).map(|edge| half_edge_of(edge[0])).collect()
    }
}
