//! The contribution of each triangle to the normals at its corners.

use super::NormalSource;
use crate::Mesh;
use crate::angle::{arc_tangent_of_ratio, cross, dot};
use luxel_parallel::{each, map};

/// How many triangles one thread takes at a time.
const RUN: usize = 1 << 14;

/// A triangle as a part of its polygon.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Face {
    /// The polygon's unit normal; zero if it has none.
    pub(super) normal: [f32; 3],
    /// The weight at each corner.
    pub(super) weights: [f32; 3],
}

impl Face {
    /// Whether there is a normal.
    #[inline]
    pub(super) fn is_sound(&self) -> bool {
        self.normal != [0.0; 3]
    }

    /// Adds the weighted normal.
    #[inline]
    pub(super) fn add_to(&self, sum: &mut [f64; 3], weight: f32) {
        let ([x, y, z], weight) = (self.normal, f64::from(weight));
        sum[0] += weight * f64::from(x);
        sum[1] += weight * f64::from(y);
        sum[2] += weight * f64::from(z);
    }
}

/// All triangles of a mesh as faces.
pub(super) struct Faces {
    faces: Vec<Face>,
    /// Whether a polygon counts by its first corner at a place only: where weights are the
    /// polygon's as a whole. Angles are shared out among its triangles.
    pub(super) once_per_polygon: bool,
}

impl Faces {
    pub(super) fn of(mesh: &Mesh, source: NormalSource) -> Self {
        let scale = area_scale(mesh);
        let mut faces = vec![Face::default(); mesh.triangles.len()];
        let mut pieces = Vec::new();
        let mut rest = &mut faces[..];
        let mut first = 0;
        while !rest.is_empty() {
            let (piece, after) = rest.split_at_mut(piece_length(mesh, first, rest.len()));
            let length = piece.len();
            pieces.push((first, piece));
            rest = after;
            first += length;
        }
        each(pieces.into_iter(), &|(first, piece)| fill(mesh, source, scale, first, piece));
        let once_per_polygon =
            mesh.polygons.is_some() && matches!(source, NormalSource::Mean | NormalSource::Area);
        Self { faces, once_per_polygon }
    }

    #[inline]
    pub(super) fn at(&self, triangle: usize) -> &Face {
        &self.faces[triangle]
    }
}

/// Whether two triangles are parts of one polygon.
pub(super) fn same_polygon(mesh: &Mesh, a: usize, b: usize) -> bool {
    a == b || mesh.polygons.as_ref().is_some_and(|polygons| polygons[a] == polygons[b])
}

/// How many triangles from `first` on one thread takes: never a part of a polygon.
fn piece_length(mesh: &Mesh, first: usize, left: usize) -> usize {
    let mut length = RUN.min(left);
    while length < left && same_polygon(mesh, first + length - 1, first + length) {
        length += 1;
    }
    length
}

/// A power of two that brings areas of the size of the mesh to about 1, so that those of the
/// smallest triangles are still numbers in f32.
fn area_scale(mesh: &Mesh) -> f64 {
    let largest = map(mesh.positions.len(), RUN, &|run| {
        let values = mesh.positions[run].as_flattened().iter().map(|value| value.abs());
        values.filter(|value| value.is_finite()).fold(0.0, f32::max)
    });
    let largest = f64::from(largest.into_iter().fold(0.0, f32::max));
    let (_, exponent) = libm::frexp(largest);
    libm::ldexp(1.0, -2 * exponent)
}

fn fill(mesh: &Mesh, source: NormalSource, scale: f64, first: usize, faces: &mut [Face]) {
    let mut start = 0;
    while start < faces.len() {
        let mut end = start + 1;
        while end < faces.len() && same_polygon(mesh, first + start, first + end) {
            end += 1;
        }
        let mut sum = [0.0; 3];
        for triangle in first + start..first + end {
            let [x, y, z] = Shape::of(mesh, triangle).cross();
            sum = [sum[0] + x, sum[1] + y, sum[2] + z];
        }
        let length = dot(sum, sum).sqrt();
        if length > 0.0 && length.is_finite() {
            let [x, y, z] = sum;
            let normal = [(x / length) as f32, (y / length) as f32, (z / length) as f32];
            let area = length * 0.5 * scale;
            for (triangle, face) in (first + start..).zip(&mut faces[start..end]) {
                let angles = || Shape::of(mesh, triangle).angles();
                let [x, y, z] = match source {
                    NormalSource::Mean => [1.0; 3],
                    NormalSource::Area => [area; 3],
                    NormalSource::Angle => angles(),
                    NormalSource::File | NormalSource::AreaAngle => {
                        let [x, y, z] = angles();
                        [x * area, y * area, z * area]
                    }
                };
                let weights = [x as f32, y as f32, z as f32];
                *face = Face { normal, weights };
            }
        }
        start = end;
    }
}

/// The edges of a triangle: from its first corner to its second, to its third, and back.
struct Shape([[f64; 3]; 3]);

impl Shape {
    #[inline]
    fn of(mesh: &Mesh, triangle: usize) -> Self {
        let [a, b, c] = mesh.triangles[triangle];
        let place = |position: u32| {
            let [x, y, z] = mesh.positions[position as usize];
            [f64::from(x), f64::from(y), f64::from(z)]
        };
        let edge =
            |from: [f64; 3], to: [f64; 3]| [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        let (a, b, c) = (place(a), place(b), place(c));
        Self([edge(a, b), edge(b, c), edge(c, a)])
    }

    /// The normal, twice the area long.
    fn cross(&self) -> [f64; 3] {
        let [a, b, _] = self.0;
        cross(a, b)
    }

    /// The angles at the corners, by tan(t/2) = |a x b| / (|a| |b| + a.b); 0 without area. The
    /// third is the rest of a half turn.
    fn angles(&self) -> [f64; 3] {
        let [a, b, c] = self.0;
        let cross = cross(a, b);
        let double_area = dot(cross, cross).sqrt();
        if double_area.is_nan() || double_area <= 0.0 {
            return [0.0; 3];
        }
        let (length_a, length_b, length_c) = (dot(a, a).sqrt(), dot(b, b).sqrt(), dot(c, c).sqrt());
        let angle = |lengths: f64, cosine: f64| {
            2.0 * arc_tangent_of_ratio(double_area, (lengths - cosine).max(0.0))
        };
        let first = angle(length_c * length_a, dot(c, a));
        let second = angle(length_a * length_b, dot(a, b));
        [first, second, (std::f64::consts::PI - first - second).max(0.0)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_of_a_triangle_are_its_angles() {
        let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 3.0_f32.sqrt(), 0.0]];
        let mesh = Mesh { positions, triangles: vec![[0, 1, 2]], ..Mesh::default() };
        let degrees = Shape::of(&mesh, 0).angles().map(f64::to_degrees);
        for (found, expected) in degrees.into_iter().zip([90.0, 60.0, 30.0]) {
            assert!((found - expected).abs() < 1e-5, "{degrees:?}");
        }
    }
}
