//! Texture coordinates of vertices: generated ones, then the texture matrix (OpenGL 1.5, sections 2.10.4 and 2.10.2).

use super::matrix_rows::MatrixRows;
use crate::enums as gl;
use crate::limits::TEXTURE_UNITS;
use crate::state::Attributes;
use crate::state::matrices::Matrices;
use glam::DMat4;
use luxel_math::{Lanes, Vec3};

/// How one coordinate comes to be.
#[derive(Clone, Copy, Debug)]
enum Source {
    Given,
    ObjectLinear([f32; 4]),
    EyeLinear([f32; 4]),
    Sphere,
    Normal,
    Reflection,
}

/// What makes the coordinates of one unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct CoordinateSetup {
    pub(super) unit: usize,
    sources: [Source; 4],
    /// `None` for the identity.
    matrix: Option<MatrixRows>,
}

/// What coordinates are generated from.
#[derive(Clone, Copy, Debug)]
pub(super) struct VertexPlace<N> {
    pub(super) object: [N; 4],
    pub(super) eye: [N; 4],
    /// In eye coordinates, as long as the state makes it.
    pub(super) normal: Vec3<N>,
}

impl CoordinateSetup {
    pub(super) fn new(state: &Attributes, matrices: &Matrices, unit: usize) -> Self {
        let generation = &state.texture.units[unit].generation.0;
        let sources = std::array::from_fn(|axis| {
            if !state.enables.generates(unit, axis) {
                return Source::Given;
            }
            let generator = &generation[axis];
            match generator.mode {
                gl::OBJECT_LINEAR => Source::ObjectLinear(generator.object_plane),
                gl::EYE_LINEAR => Source::EyeLinear(generator.eye_plane),
                gl::SPHERE_MAP => Source::Sphere,
                gl::NORMAL_MAP => Source::Normal,
                _ => Source::Reflection,
            }
        });
        let matrix = &matrices.texture[unit].top;
        let matrix = (*matrix != DMat4::IDENTITY).then(|| MatrixRows::new(matrix));
        Self { unit, sources, matrix }
    }

    /// Those of the units whose coordinates are needed.
    pub(super) fn of_units(state: &Attributes, matrices: &Matrices, units: u32) -> Vec<Self> {
        (0..TEXTURE_UNITS)
            .filter(|unit| units >> unit & 1 == 1)
            .map(|unit| Self::new(state, matrices, unit))
            .collect()
    }

    /// Whether eye coordinates are needed.
    pub(super) fn needs_eye(&self) -> bool {
        let needs = |source: &Source| !matches!(source, Source::Given | Source::ObjectLinear(_));
        self.sources.iter().any(needs)
    }

    /// Whether normals are needed.
    pub(super) fn needs_normal(&self) -> bool {
        let needs = |source: &Source| {
            matches!(source, Source::Sphere | Source::Normal | Source::Reflection)
        };
        self.sources.iter().any(needs)
    }

    /// The unit's coordinates of sixteen vertices.
    #[inline(always)]
    pub(super) fn coordinates<N: Lanes>(&self, place: &VertexPlace<N>, given: [N; 4]) -> [N; 4] {
        let mut coordinates = given;
        for (axis, source) in self.sources.iter().enumerate() {
            coordinates[axis] = match source {
                Source::Given => continue,
                Source::ObjectLinear(plane) => product(plane, place.object),
                Source::EyeLinear(plane) => product(plane, place.eye),
                Source::Sphere => sphere(place, axis),
                Source::Normal => component(place.normal, axis),
                Source::Reflection => component(reflection(place), axis),
            };
        }
        match &self.matrix {
            Some(matrix) => matrix.times(coordinates),
            None => coordinates,
        }
    }
}

/// p . x
#[inline(always)]
fn product<N: Lanes>([a, b, c, d]: &[f32; 4], [x, y, z, w]: [N; 4]) -> N {
    x * x.constant(*a) + y * x.constant(*b) + z * x.constant(*c) + w * x.constant(*d)
}

/// x, y or z; 0 for q, which these modes don't have.
#[inline(always)]
fn component<N: Lanes>(vector: Vec3<N>, axis: usize) -> N {
    match axis {
        0 => vector.x,
        1 => vector.y,
        2 => vector.z,
        _ => vector.x.zero(),
    }
}

/// r = u - 2 n (n . u), u being the direction from the eye to the vertex.
#[inline(always)]
fn reflection<N: Lanes>(place: &VertexPlace<N>) -> Vec3<N> {
    let [x, y, z, _] = place.eye;
    let u = Vec3::new(x, y, z).normalized_or_zero();
    let n = place.normal;
    u - n * (n.dot(u) * x.constant(2.0))
}

/// r_x / m + 1/2 or r_y / m + 1/2, with m = 2 |(r_x, r_y, r_z + 1)|.
#[inline(always)]
fn sphere<N: Lanes>(place: &VertexPlace<N>, axis: usize) -> N {
    let r = reflection(place);
    let half = r.x.constant(0.5);
    let m = r.x.constant(2.0) * Vec3::new(r.x, r.y, r.z + r.z.one()).length();
    let at = component(r, axis) / m + half;
    // Straight ahead there is no direction.
    half.select(m.equal(m.zero()), at)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setup(source: Source) -> CoordinateSetup {
        let given = Source::Given;
        CoordinateSetup { unit: 0, sources: [source, source, given, given], matrix: None }
    }

    const PLACE: VertexPlace<f32> = VertexPlace {
        object: [1.0, 2.0, 3.0, 1.0],
        eye: [0.0, 0.0, -5.0, 1.0],
        normal: Vec3::new(0.0, 0.6, 0.8),
    };

    #[test]
    fn section_2_10_4_planes_give_the_distances_of_object_or_eye_coordinates() {
        let plane = [1.0, 10.0, 100.0, 1000.0];
        let given = [7.0, 8.0, 9.0, 1.0];
        let object = setup(Source::ObjectLinear(plane)).coordinates(&PLACE, given);
        assert_eq!(object, [1321.0, 1321.0, 9.0, 1.0]);
        let eye = setup(Source::EyeLinear(plane)).coordinates(&PLACE, given);
        assert_eq!(eye[0], 500.0);
    }

    #[test]
    fn section_2_10_4_reflections_and_the_sphere_map_of_them() {
        // u = (0, 0, -1), n . u = -0.8, r = u + 1.6 n.
        let [x, y, ..] = setup(Source::Reflection).coordinates(&PLACE, [0.0; 4]);
        assert_eq!(x, 0.0);
        assert!((y - 0.96).abs() < 1e-6, "{y}");
        let z = -1.0 + 1.6 * 0.8_f32;
        let m = 2.0 * (0.96_f32 * 0.96 + (z + 1.0) * (z + 1.0)).sqrt();
        let [s, t, ..] = setup(Source::Sphere).coordinates(&PLACE, [0.0; 4]);
        assert_eq!(s, 0.5);
        assert!((t - (0.96 / m + 0.5)).abs() < 1e-6, "{t}");
        let normal = setup(Source::Normal).coordinates(&PLACE, [0.0; 4]);
        assert_eq!(normal[1], 0.6);
    }
}
