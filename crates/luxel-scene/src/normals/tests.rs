use super::*;
use glam::DVec3;
use proptest::prelude::*;

const SOURCES: [NormalSource; 4] =
    [NormalSource::Mean, NormalSource::Area, NormalSource::Angle, NormalSource::AreaAngle];

fn options(source: NormalSource, degrees: f64) -> NormalOptions {
    NormalOptions { source, crease_radians: degrees.to_radians() }
}

/// A cube from -1 to 1, each side two triangles of one polygon.
fn cube() -> Mesh {
    let positions = (0..8_u8)
        .map(|corner| [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { -1.0_f32 } else { 1.0 }));
    let sides: [[u32; 4]; 6] =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    Mesh {
        positions: positions.collect(),
        triangles: sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        polygons: Some((0..12).map(|triangle| triangle / 2).collect()),
        ..Mesh::default()
    }
}

/// The normal at corner k of a triangle.
fn normal_at(mesh: &Mesh, triangle: usize, corner: usize) -> DVec3 {
    let vertex = mesh.attribute_corners()[triangle][corner];
    DVec3::from_array(mesh.normals[vertex as usize].map(f64::from))
}

fn position_at(mesh: &Mesh, triangle: usize, corner: usize) -> DVec3 {
    mesh.position(mesh.triangles[triangle][corner])
}

fn face_normal(mesh: &Mesh, triangle: usize) -> DVec3 {
    let [a, b, c] = [0, 1, 2].map(|corner| position_at(mesh, triangle, corner));
    (b - a).cross(c - a).normalize()
}

fn corners(mesh: &Mesh) -> impl Iterator<Item = (usize, usize)> {
    let triangles = mesh.triangles.len();
    (0..triangles).flat_map(|triangle| (0..3).map(move |corner| (triangle, corner)))
}

fn assert_faceted(mesh: &Mesh) {
    for (triangle, corner) in corners(mesh) {
        let difference = normal_at(mesh, triangle, corner) - face_normal(mesh, triangle);
        assert!(difference.length() < 1e-6, "corner {corner} of {triangle}");
    }
}

fn assert_radial(mesh: &Mesh, tolerance: f64) {
    for (triangle, corner) in corners(mesh) {
        let radial = position_at(mesh, triangle, corner).normalize();
        let difference = (normal_at(mesh, triangle, corner) - radial).length();
        assert!(difference < tolerance, "corner {corner} of {triangle}: {difference}");
    }
}

/// Every triangle with separate positions and attributes, as in an STL file.
fn torn_apart(mesh: &Mesh) -> Mesh {
    let corner = |&position: &u32| mesh.positions[position as usize];
    let positions: Vec<_> = mesh.triangles.as_flattened().iter().map(corner).collect();
    let triangles = (0..mesh.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]);
    Mesh { positions, triangles: triangles.collect(), ..mesh.clone() }
}

#[test]
fn a_cube_has_edges_below_and_none_above_the_right_angle() {
    for source in SOURCES {
        let mut sharp = cube();
        sharp.uvs[0] = (0..8).map(|vertex| [vertex as f32, 0.0]).collect();
        sharp.compute_normals(&options(source, 30.0));
        assert_faceted(&sharp);
        assert_eq!(sharp.normals.len(), 24);
        assert_eq!(sharp.positions.len(), 8);
        assert_eq!(sharp.uvs[0].len(), 24);
        for (triangle, corner) in corners(&sharp) {
            let vertex = sharp.attribute_corners()[triangle][corner];
            let position = sharp.triangles[triangle][corner];
            assert_eq!(sharp.uvs[0][vertex as usize], [position as f32, 0.0]);
        }
        for degrees in [95.0, 180.0] {
            let mut smooth = cube();
            smooth.compute_normals(&options(source, degrees));
            assert_eq!(smooth.attribute_corners, None);
            // Quads count once: the diagonals leave no trace.
            assert_radial(&smooth, 1e-6);
        }
    }
}

#[test]
fn triangles_of_their_own_count_each() {
    // Corner 0 belongs to two triangles of some sides of the cube and to one of others.
    let mut mesh = cube();
    mesh.polygons = None;
    mesh.compute_normals(&options(NormalSource::Mean, 180.0));
    let counted: DVec3 = (0..12)
        .filter(|&triangle| mesh.triangles[triangle].contains(&0))
        .map(|triangle| face_normal(&mesh, triangle))
        .sum();
    let triangle = mesh.triangles.iter().position(|triangle| triangle[0] == 0).unwrap();
    assert!((normal_at(&mesh, triangle, 0) - counted.normalize()).length() < 1e-6);
}

#[test]
fn positions_that_a_file_has_split_are_smoothed_as_one() {
    let mut whole = crate::primitives::sphere(1.0, 32, 16);
    for source in SOURCES {
        let mut torn = torn_apart(&whole);
        torn.attribute_corners = None;
        torn.normals.clear();
        torn.uvs = Default::default();
        torn.polygons = None;
        torn.compute_normals(&options(source, 40.0));
        assert_radial(&torn, 0.06);
        assert_eq!(torn.normals.len(), torn.positions.len());
    }
    whole.compute_normals(&options(NormalSource::AreaAngle, 40.0));
    assert_radial(&whole, 0.02);
}

#[test]
fn weights_are_what_they_are_called() {
    // A large triangle with a right angle on the ground and a small one with half a right angle
    // standing on it, both at the origin.
    let mesh = Mesh {
        positions: vec![
            [0.0; 3],
            [4.0, 0.0, 0.0],
            [0.0, 4.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 1.0],
        ],
        triangles: vec![[0, 1, 2], [0, 4, 3]],
        ..Mesh::default()
    };
    let ground = DVec3::Z;
    let wall = face_normal(&mesh, 1);
    for (source, large, small) in [
        (NormalSource::Mean, 1.0, 1.0),
        (NormalSource::Area, 8.0, 0.5),
        (NormalSource::Angle, 90.0, 45.0),
        (NormalSource::AreaAngle, 8.0 * 90.0, 0.5 * 45.0),
    ] {
        let mut weighted = mesh.clone();
        weighted.compute_normals(&options(source, 180.0));
        let expected = (ground * large + wall * small).normalize();
        let difference = (normal_at(&weighted, 0, 0) - expected).length();
        assert!(difference < 1e-6, "{source:?}: {difference}");
    }
}

#[test]
fn smoothing_groups_decide_alone_where_a_file_has_them() {
    // The sides of the cube: two that meet in group 1, two in group 2, two faceted.
    let mut mesh = cube();
    let groups = [1, 0, 1, 2, 0, 2];
    mesh.smoothing_groups = Some((0..12).map(|triangle| groups[triangle / 2]).collect());
    mesh.compute_normals(&options(NormalSource::AreaAngle, 0.0));
    for (triangle, corner) in corners(&mesh) {
        let position = mesh.triangles[triangle][corner];
        let group = groups[triangle / 2];
        let expected: DVec3 = (0..6)
            .filter(|&side| if group == 0 { side == triangle / 2 } else { groups[side] == group })
            .filter(|&side| {
                let [a, b] = [2 * side, 2 * side + 1];
                mesh.triangles[a].contains(&position) || mesh.triangles[b].contains(&position)
            })
            .map(|side| face_normal(&mesh, 2 * side))
            .sum();
        let difference = normal_at(&mesh, triangle, corner) - expected.normalize();
        assert!(difference.length() < 1e-6, "corner {corner} of {triangle}");
    }
}

#[test]
fn fans_that_share_only_a_point_are_apart_below_pi() {
    // Two tents, tip to tip.
    let mut mesh = Mesh { positions: vec![[0.0; 3]], ..Mesh::default() };
    for height in [1.0, -1.0] {
        let first = mesh.positions.len() as u32;
        let rim = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
        mesh.positions.extend(rim.map(|[x, y]| [x, y, height]));
        mesh.triangles.extend((0..4).map(|side| [0, first + (side + 1) % 4, first + side]));
    }
    mesh.compute_normals(&options(NormalSource::Mean, 170.0));
    assert_eq!(mesh.normals.len(), mesh.positions.len() + 1);
    let [above, below] = [0, 4].map(|triangle| normal_at(&mesh, triangle, 0));
    assert!((above - DVec3::NEG_Z).length() < 1e-6 || (above - DVec3::Z).length() < 1e-6);
    assert!((above - below).length() < 1e-6 || (above + below).length() < 1e-6);
}

#[test]
fn a_crease_that_runs_out_does_not_split_its_end() {
    // A roof with a dent: the ridge is sharp on one side of the peak only, so around the peak all
    // faces are reached from each other without crossing it.
    let rim = [[2.0, 0.0, 0.0], [1.0, 1.0, 0.9], [-1.0, 1.0, 0.9], [-2.0, 0.0, 1.0]];
    let mut positions = vec![[0.0, 0.0, 1.0]];
    positions.extend(rim);
    positions.extend(rim[1..3].iter().rev().map(|&[x, y, z]| [x, -y, z]));
    let triangles = (1..7).map(|at| [0, at, at % 6 + 1]).collect();
    let mut mesh = Mesh { positions, triangles, ..Mesh::default() };
    let sharpest = (0..6)
        .map(|face| face_normal(&mesh, face).angle_between(face_normal(&mesh, (face + 1) % 6)))
        .fold(0.0, f64::max);
    let mut angles: Vec<f64> = (0..6)
        .map(|face| face_normal(&mesh, face).angle_between(face_normal(&mesh, (face + 1) % 6)))
        .collect();
    angles.sort_by(f64::total_cmp);
    assert!(angles[4] < sharpest - 0.05, "one edge must stand out: {angles:?}");
    let crease_radians = (angles[4] + sharpest) / 2.0;
    mesh.compute_normals(&NormalOptions { source: NormalSource::Area, crease_radians });
    let peak = normal_at(&mesh, 0, 0);
    assert!((1..6).all(|triangle| normal_at(&mesh, triangle, 0) == peak));
}

#[test]
fn faces_without_area_neither_count_nor_part_their_neighbours() {
    // A flat square, cut by a sliver along its diagonal.
    let mut mesh = Mesh {
        positions: vec![
            [0.0; 3],
            [2.0, 0.0, 0.0],
            [2.0, 2.0, 0.0],
            [0.0, 2.0, 0.0],
            [1.0, 1.0, 0.0],
        ],
        triangles: vec![[0, 1, 2], [0, 2, 4], [0, 4, 3], [4, 2, 3], [1, 1, 1]],
        ..Mesh::default()
    };
    mesh.compute_normals(&options(NormalSource::Mean, 10.0));
    assert_eq!(mesh.normals, vec![[0.0, 0.0, 1.0]; 5]);
}

#[test]
fn nothing_sound_gives_plus_z() {
    let mut mesh = Mesh {
        positions: vec![[1.0; 3], [f32::NAN; 3], [2.0; 3]],
        triangles: vec![[0, 1, 2], [0, 0, 0]],
        ..Mesh::default()
    };
    for source in SOURCES {
        for degrees in [0.0, 40.0, 180.0, f64::NAN] {
            mesh.compute_normals(&options(source, degrees));
            assert!(mesh.normals.iter().all(|&normal| normal == [0.0, 0.0, 1.0]));
        }
    }
}

#[test]
fn both_faces_of_a_sheet_have_a_direction() {
    let mut mesh = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        triangles: vec![[0, 1, 2], [0, 2, 1]],
        ..Mesh::default()
    };
    mesh.compute_normals(&options(NormalSource::AreaAngle, 180.0));
    assert!(mesh.normals.iter().all(|normal| normal[2].abs() == 1.0));
    mesh.compute_normals(&options(NormalSource::AreaAngle, 40.0));
    assert_faceted(&mesh);
}

#[test]
fn the_files_normals_stay_and_broken_ones_are_mended() {
    let mut mesh = cube();
    mesh.normals = vec![[0.0, 3.0, 4.0]; 8];
    mesh.normals[0] = [0.0; 3];
    mesh.normals[7] = [f32::NAN, 1.0, 0.0];
    mesh.compute_normals(&NormalOptions::default());
    assert_eq!(mesh.attribute_corners, None);
    assert_eq!(mesh.normals[1], [0.0, 0.6, 0.8]);
    for vertex in [0, 7] {
        let normal = DVec3::from_array(mesh.normals[vertex].map(f64::from));
        assert!((normal - mesh.position(vertex as u32).normalize()).length() < 1e-6);
    }
}

#[test]
fn tiny_and_huge_meshes_are_treated_like_others() {
    for scale in [1e-18_f32, 1e18] {
        let mut mesh = cube();
        mesh.positions.iter_mut().flatten().for_each(|value| *value *= scale);
        mesh.compute_normals(&options(NormalSource::AreaAngle, 180.0));
        assert_radial(&mesh, 1e-6);
    }
}

#[test]
fn attributes_shared_by_many_positions_are_split_where_needed() {
    // One texture coordinate for the whole cube, as an OBJ file may have it.
    let mut mesh = cube();
    mesh.attribute_corners = Some(vec![[0; 3]; 12]);
    mesh.uvs[0] = vec![[0.25, 0.75]];
    mesh.compute_normals(&options(NormalSource::AreaAngle, 180.0));
    assert_radial(&mesh, 1e-6);
    assert_eq!(mesh.uvs[0], vec![[0.25, 0.75]; 8]);
}

#[test]
fn everything_at_one_edge_or_one_vertex_ends_soon() {
    let count = 200_000;
    let angle = |at: u32| f64::from(at) * 0.1;
    let mut positions = vec![[0.0; 3], [0.0, 0.0, 1.0]];
    positions
        .extend((0..count).map(|at| {
            [libm::cos(angle(at)) as f32, libm::sin(angle(at)) as f32, at as f32 * 1e-5]
        }));
    let book = (0..count).map(|at| [0, 1, at + 2]).collect();
    let cone = (0..count - 1).map(|at| [0, at + 2, at + 3]).collect();
    for triangles in [book, cone] {
        let mut mesh = Mesh { positions: positions.clone(), triangles, ..Mesh::default() };
        let start = std::time::Instant::now();
        mesh.compute_normals(&NormalOptions::default());
        assert!(start.elapsed().as_secs() < 10);
    }
}

#[test]
fn threads_change_no_bit() {
    let mut mesh = torn_apart(&crate::primitives::sphere(1.0, 200, 120));
    mesh.attribute_corners = None;
    mesh.normals.clear();
    mesh.uvs = Default::default();
    mesh.polygons = None;
    let with = |threads: usize| {
        let mut mesh = mesh.clone();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| mesh.compute_normals(&options(NormalSource::AreaAngle, 2.5)));
        mesh
    };
    let one = with(1);
    assert_eq!(one, with(2));
    assert_eq!(one, with(7));
}

proptest! {
    #[test]
    fn any_mesh_gets_unit_normals_at_every_corner(
        coordinates in prop::collection::vec(prop::array::uniform3(-2_i8..3), 1..12),
        numbers in prop::collection::vec(prop::array::uniform3(0_usize..12), 1..40),
        groups in prop::option::of(prop::collection::vec(0_u32..3, 40)),
        in_polygons in any::<bool>(),
        source in prop::sample::select(&SOURCES[..]),
        degrees in 0.0_f64..200.0,
    ) {
        let count = coordinates.len();
        let triangles: Vec<_> =
            numbers.iter().map(|triangle| triangle.map(|at| (at % count) as u32)).collect();
        let before = triangles.clone();
        let polygons = (0..triangles.len() as u32).map(|triangle| triangle / 3).collect();
        let mut mesh = Mesh {
            positions: coordinates.iter().map(|place| place.map(f32::from)).collect(),
            smoothing_groups: groups.map(|groups| groups[..triangles.len()].to_vec()),
            polygons: in_polygons.then_some(polygons),
            triangles,
            ..Mesh::default()
        };
        mesh.compute_normals(&options(source, degrees));
        prop_assert_eq!(&mesh.triangles, &before);
        prop_assert_eq!(mesh.positions.len(), count);
        for normal in &mesh.normals {
            let length = DVec3::from_array(normal.map(f64::from)).length();
            prop_assert!((length - 1.0).abs() < 1e-6);
        }
        prop_assert!(
            mesh.attribute_corners().iter().flatten().all(|&at| (at as usize) < mesh.normals.len())
        );
    }
}
