use super::*;
use crate::{NormalOptions, NormalSource, primitives};
use bevy_mikktspace::{Geometry, Ops, TangentSpace, generate_tangents};
use proptest::prelude::*;

/// The program that normal maps are made for, as the measure.
struct Reference<'a> {
    mesh: &'a Mesh,
    tangents: Vec<Option<[f32; 4]>>,
}

struct Exact;

impl Ops for Exact {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }

    fn acos(x: f32) -> f32 {
        libm::acos(f64::from(x)) as f32
    }
}

impl Geometry<Exact> for Reference<'_> {
    fn num_faces(&self) -> usize {
        self.mesh.triangles.len()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.positions[self.mesh.triangles[face][corner] as usize]
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.normals[self.mesh.attribute_corners()[face][corner] as usize]
    }

    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        self.mesh.uvs[0][self.mesh.attribute_corners()[face][corner] as usize]
    }

    fn set_tangent(&mut self, tangent: Option<TangentSpace>, face: usize, corner: usize) {
        self.tangents[face * 3 + corner] = tangent.map(|tangent| tangent.tangent_encoded());
    }
}

/// Compares with the reference: at corners where that has an answer, at most `exceptions` of them
/// left out.
fn assert_like_reference(mesh: &Mesh, tolerance: f32, exceptions: usize) {
    let mut reference = Reference { mesh, tangents: vec![None; mesh.triangles.len() * 3] };
    generate_tangents(&mut reference).unwrap();
    let mut computed = mesh.clone();
    computed.compute_tangents(0);
    assert_eq!(computed.tangents.len(), computed.normals.len());
    let mut different = 0;
    for (corner, expected) in reference.tangents.iter().enumerate() {
        let vertex = computed.attribute_corners().as_flattened()[corner] as usize;
        let [x, y, z, w] = computed.tangents[vertex];
        let Some([ex, ey, ez, ew]) = *expected else { continue };
        let off = (x - ex).abs().max((y - ey).abs()).max((z - ez).abs());
        // The reference's v grows upwards.
        different += usize::from(off > tolerance || w != -ew);
    }
    assert!(different <= exceptions, "{different} corners differ");
}

#[test]
fn tangents_are_those_that_normal_maps_are_made_for() {
    for mesh in [
        primitives::sphere(1.0, 24, 12),
        primitives::torus(1.0, 0.4, 20, 14),
        primitives::cuboid(glam::DVec3::new(1.0, 2.0, 3.0)),
        primitives::plane(glam::DVec2::ONE, 3, 4),
    ] {
        assert_like_reference(&mesh, 1e-4, 0);
    }
}

#[test]
fn a_flat_picture_has_its_own_axes() {
    let mut mesh = primitives::plane(glam::DVec2::ONE, 2, 2);
    mesh.compute_tangents(0);
    for (triangle, corners) in mesh.attribute_corners().iter().enumerate() {
        let [a, b, c] = [0, 1, 2].map(|corner| {
            let vertex = corners[corner] as usize;
            (mesh.position(mesh.triangles[triangle][corner]), mesh.uvs[0][vertex])
        });
        let [x, y, z, w] = mesh.tangents[corners[0] as usize].map(f64::from);
        let tangent = glam::DVec3::new(x, y, z);
        let normal = glam::DVec3::from_array(mesh.normals[corners[0] as usize].map(f64::from));
        let bitangent = normal.cross(tangent) * w;
        for (place, uv) in [b, c] {
            let [du, dv] = [uv[0] - a.1[0], uv[1] - a.1[1]].map(f64::from);
            // Green is up, v is down.
            assert!(((place - a.0).dot(tangent) - du).abs() < 1e-6);
            assert!(((place - a.0).dot(bitangent) + dv).abs() < 1e-6);
        }
    }
}

#[test]
fn where_mirrored_halves_meet_vertices_are_split() {
    // Two squares side by side, the second with the first one's picture mirrored.
    let mut mesh = Mesh {
        positions: (0..6_u8).map(|at| [f32::from(at % 3), f32::from(at / 3), 0.0]).collect(),
        triangles: vec![[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]],
        normals: vec![[0.0, 0.0, 1.0]; 6],
        ..Mesh::default()
    };
    mesh.uvs[0] =
        (0..6_u8).map(|at| [1.0 - (f32::from(at % 3) - 1.0).abs(), f32::from(at / 3)]).collect();
    mesh.compute_tangents(0);
    assert_eq!((mesh.tangents.len(), mesh.normals.len(), mesh.uvs[0].len()), (8, 8, 8));
    for (triangle, corners) in mesh.attribute_corners().iter().enumerate() {
        let expected = if triangle < 2 { [1.0, 0.0, 0.0, -1.0] } else { [-1.0, 0.0, 0.0, 1.0] };
        assert!(corners.iter().all(|&vertex| mesh.tangents[vertex as usize] == expected));
    }
}

#[test]
fn nothing_is_done_without_normals_or_coordinates() {
    let whole = primitives::plane(glam::DVec2::ONE, 1, 1);
    let mut without_normals = whole.clone();
    without_normals.normals.clear();
    let mut too_few = whole.clone();
    too_few.uvs[0].pop();
    for (mut mesh, uv_set) in [(without_normals, 0), (too_few, 0), (whole, 1), (Mesh::default(), 7)]
    {
        mesh.compute_tangents(uv_set);
        assert!(mesh.tangents.is_empty());
    }
}

#[test]
fn a_vertex_of_very_many_triangles_ends_soon() {
    let mut mesh = primitives::cone(1.0, 1.0, 200_000, 1);
    let start = std::time::Instant::now();
    mesh.compute_tangents(0);
    assert!(start.elapsed().as_secs() < 10);
}

proptest! {
    #[test]
    fn any_picture_gives_perpendicular_units(
        coordinates in prop::collection::vec(prop::array::uniform3(-2_i8..3), 3..9),
        uvs in prop::collection::vec(prop::array::uniform2(-1_i8..2), 9),
        numbers in prop::collection::vec(prop::array::uniform3(0_usize..9), 1..20),
        odd in any::<bool>(),
    ) {
        let count = coordinates.len();
        let mut mesh = Mesh {
            positions: coordinates.iter().map(|place| place.map(f32::from)).collect(),
            triangles: numbers.iter().map(|t| t.map(|at| (at % count) as u32)).collect(),
            ..Mesh::default()
        };
        mesh.uvs[0] = uvs[..count].iter().map(|uv| uv.map(f32::from)).collect();
        if odd {
            mesh.uvs[0][0] = [f32::NAN, f32::INFINITY];
        }
        let options = NormalOptions { source: NormalSource::AreaAngle, crease_radians: 0.7 };
        mesh.compute_normals(&options);
        mesh.compute_tangents(0);
        for &vertex in mesh.attribute_corners().as_flattened() {
            let [x, y, z, w] = mesh.tangents[vertex as usize];
            let [nx, ny, nz] = mesh.normals[vertex as usize];
            prop_assert!((x * x + y * y + z * z - 1.0).abs() < 1e-5);
            prop_assert!((x * nx + y * ny + z * nz).abs() < 1e-5);
            prop_assert!(w == 1.0 || w == -1.0);
        }
    }
}
