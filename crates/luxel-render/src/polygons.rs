//! The file's polygons, which shading modes of old took whole: their centroids, normals, outlines.

use glam::DVec3;
use luxel_scene::Mesh;
use std::ops::Range;

/// Most corners of a polygon that is taken whole. More would make every pixel of it slow.
const MOST_CORNERS: usize = 256;

/// Where each polygon of a mesh begins.
pub(crate) struct Polygons {
    /// The first triangle of each polygon; `None` where each triangle is one.
    starts: Option<Vec<u32>>,
    /// Twice the area along the normal, and the centroid, of each polygon of more than one
    /// triangle, in the mesh's own space.
    faces: Vec<Face>,
}

/// A polygon's plane, in the mesh's own space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Face {
    /// The sum of the triangles' cross products: twice the area, along the normal.
    pub(crate) area: DVec3,
    /// The centroid: that of the triangles, by their areas along the polygon's normal.
    pub(crate) centroid: DVec3,
}

impl Polygons {
    /// Each triangle by itself.
    pub(crate) const TRIANGLES: Self = Self { starts: None, faces: Vec::new() };

    pub(crate) fn new(mesh: &Mesh) -> Self {
        let Some(polygons) = &mesh.polygons else { return Self::TRIANGLES };
        let (mut starts, mut faces) = (Vec::new(), Vec::new());
        let mut first = 0;
        for run in polygons.chunk_by(|a, b| a == b) {
            starts.push(first as u32);
            faces.push(Face::of(mesh, first..first + run.len()));
            first += run.len();
        }
        Self { starts: Some(starts), faces }
    }

    /// Whether each triangle is a polygon by itself.
    pub(crate) fn are_triangles(&self) -> bool {
        self.starts.is_none()
    }

    /// The polygon of a triangle, by number.
    fn polygon(starts: &[u32], triangle: u32) -> usize {
        starts.partition_point(|&start| start <= triangle).saturating_sub(1)
    }

    /// The triangles of the polygon that a triangle is part of.
    pub(crate) fn run(&self, mesh: &Mesh, triangle: u32) -> Range<usize> {
        let Some(starts) = &self.starts else { return triangle as usize..triangle as usize + 1 };
        let polygon = Self::polygon(starts, triangle);
        let end = starts.get(polygon + 1).map_or(mesh.triangles.len(), |&next| next as usize);
        starts[polygon] as usize..end
    }

    /// The plane of the polygon that a triangle is part of.
    pub(crate) fn face(&self, mesh: &Mesh, triangle: u32) -> Face {
        match &self.starts {
            Some(starts) => self.faces[Self::polygon(starts, triangle)],
            None => {
                let corners = mesh.triangles[triangle as usize];
                Face::of_triangle(mesh, corners.map(|at| mesh.positions[at as usize]))
            }
        }
    }

    /// The corners around the polygon that a triangle is part of: position and attribute vertex of
    /// each. The triangle alone where the polygon is too large or no simple loop.
    pub(crate) fn outline(&self, mesh: &Mesh, triangle: u32) -> Vec<(u32, u32)> {
        let run = self.run(mesh, triangle);
        if run.len() > 1
            && run.len() + 2 <= MOST_CORNERS
            && let Some(outline) = outline(mesh, run)
        {
            return outline;
        }
        let (positions, attributes) =
            (mesh.triangles[triangle as usize], mesh.attribute_corners()[triangle as usize]);
        positions.into_iter().zip(attributes).collect()
    }
}

impl Face {
    fn of(mesh: &Mesh, run: Range<usize>) -> Self {
        let corners = |[a, b, c]: &[u32; 3]| [*a, *b, *c].map(|corner| mesh.position(corner));
        let triangles: Vec<_> = mesh.triangles[run].iter().map(corners).collect();
        Self::of_triangles(&triangles)
    }

    /// Of a triangle by itself, with its corners' positions about the mesh's origin.
    #[inline(always)]
    pub(crate) fn of_triangle(mesh: &Mesh, [a, b, c]: [[f32; 3]; 3]) -> Self {
        Self::of_triangles(&[[mesh.place(a), mesh.place(b), mesh.place(c)]])
    }

    #[inline(always)]
    fn of_triangles(triangles: &[[DVec3; 3]]) -> Self {
        let cross = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
        let area = triangles.iter().fold(DVec3::ZERO, |sum, corners| sum + cross(*corners));
        let (mut weighted, mut whole) = (DVec3::ZERO, 0.0);
        let (mut plain, mut count) = (DVec3::ZERO, 0.0);
        for &[a, b, c] in triangles {
            let middle = (a + b + c) / 3.0;
            let weight = cross([a, b, c]).dot(area);
            weighted += middle * weight;
            whole += weight;
            plain += middle;
            count += 1.0;
        }
        let centroid = weighted / whole;
        Self { area, centroid: if centroid.is_finite() { centroid } else { plain / count } }
    }
}

/// The loop around some triangles: the edges that only one of them has, one after another.
fn outline(mesh: &Mesh, run: Range<usize>) -> Option<Vec<(u32, u32)>> {
    let corners = run.len() + 2;
    let mut edges: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * run.len());
    for triangle in run {
        let positions = mesh.triangles[triangle];
        let attributes = mesh.attribute_corners()[triangle];
        for at in 0..3 {
            edges.push(([positions[at], positions[(at + 1) % 3]], attributes[at]));
        }
    }
    edges.sort_unstable();
    let has = |edge: [u32; 2]| edges.binary_search_by(|(other, _)| other.cmp(&edge)).is_ok();
    let outer: Vec<_> = edges.iter().filter(|([from, to], _)| !has([*to, *from])).collect();
    let first = outer.first()?;
    let mut around = Vec::with_capacity(corners);
    let mut edge = *first;
    for _ in 0..corners {
        let ([from, to], attribute) = *edge;
        around.push((from, attribute));
        let next = outer.partition_point(|([start, _], _)| *start < to);
        edge = outer.get(next).filter(|([start, _], _)| *start == to)?;
    }
    // Each corner once, and back at the first.
    let closed = edge.0 == first.0 && outer.len() == corners;
    closed.then_some(around)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(positions: &[[f32; 3]], triangles: Vec<[u32; 3]>) -> Mesh {
        let polygons = Some(vec![0; triangles.len()]);
        Mesh { positions: positions.to_vec(), triangles, polygons, ..Mesh::default() }
    }

    const TRAPEZOID: [[f32; 3]; 4] =
        [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [3.0, 2.0, 0.0], [1.0, 2.0, 0.0]];

    #[test]
    fn the_centroid_is_that_of_the_area_and_not_of_the_corners() {
        let mesh = mesh(&TRAPEZOID, vec![[0, 1, 2], [0, 2, 3]]);
        let face = Polygons::new(&mesh).face(&mesh, 1);
        // (h / 3) (a + 2 b) / (a + b) above the longer side.
        let expected = DVec3::new(2.0, 2.0 / 3.0 * (4.0 + 2.0 * 2.0) / 6.0, 0.0);
        assert!(face.centroid.abs_diff_eq(expected, 1e-12), "{}", face.centroid);
        assert_eq!(face.area, DVec3::new(0.0, 0.0, 12.0));
    }

    #[test]
    fn a_quad_s_outline_has_four_corners_in_order() {
        let mesh = mesh(&TRAPEZOID, vec![[0, 1, 2], [0, 2, 3]]);
        let polygons = Polygons::new(&mesh);
        for triangle in 0..2 {
            let corners: Vec<_> =
                polygons.outline(&mesh, triangle).into_iter().map(|(at, _)| at).collect();
            assert_eq!(corners, [0, 1, 2, 3]);
        }
    }

    #[test]
    fn triangles_that_are_no_loop_are_taken_one_by_one() {
        let mut positions = TRAPEZOID.to_vec();
        positions.extend([[9.0; 3], [8.0; 3]]);
        let apart = mesh(&positions, vec![[0, 1, 2], [3, 4, 5]]);
        let outline = Polygons::new(&apart).outline(&apart, 1);
        assert_eq!(outline, [(3, 3), (4, 4), (5, 5)]);
    }
}
