use super::*;
use crate::Mesh;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::PI;

fn shapes() -> Vec<(&'static str, Mesh)> {
    vec![
        ("plane", plane(DVec2::new(2.0, 3.0), 4, 5)),
        ("cuboid", cuboid(DVec3::new(1.0, 2.0, 3.0))),
        ("sphere", sphere(1.5, 24, 12)),
        ("odd sphere", sphere(1.5, 7, 5)),
        ("coarsest sphere", sphere(1.0, 0, 0)),
        ("icosphere", icosphere(1.5, 6)),
        ("icosahedron", icosphere(1.0, 0)),
        ("cylinder", cylinder(1.0, 2.0, 17)),
        ("cone", cone(1.0, 2.0, 17, 3)),
        ("torus", torus(2.0, 0.5, 24, 12)),
    ]
}

/// How many triangles meet at each edge, as an ordered pair of positions.
fn directed_edges(mesh: &Mesh) -> BTreeMap<[u32; 2], u32> {
    let mut edges = BTreeMap::new();
    for [a, b, c] in &mesh.triangles {
        for edge in [[*a, *b], [*b, *c], [*c, *a]] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    edges
}

fn corners(mesh: &Mesh, triangle: usize) -> [DVec3; 3] {
    mesh.triangles[triangle].map(|index| mesh.position(index))
}

fn volume(mesh: &Mesh) -> f64 {
    let of = |triangle| {
        let [a, b, c] = corners(mesh, triangle);
        a.dot(b.cross(c)) / 6.0
    };
    (0..mesh.triangles.len()).map(of).sum()
}

#[test]
fn every_shape_but_the_plane_is_closed_and_every_edge_runs_both_ways() {
    for (name, mesh) in shapes() {
        let edges = directed_edges(&mesh);
        assert!(edges.values().all(|&count| count == 1), "{name}: an edge runs twice one way");
        let open = edges.keys().filter(|[a, b]| !edges.contains_key(&[*b, *a])).count();
        assert_eq!(open, if name == "plane" { 2 * (4 + 5) } else { 0 }, "{name}");
    }
}

#[test]
fn normals_are_units_and_agree_with_the_triangles() {
    for (name, mesh) in shapes() {
        for (triangle, attributes) in mesh.attribute_corners().iter().enumerate() {
            let [a, b, c] = corners(&mesh, triangle);
            let face = (b - a).cross(c - a);
            assert!(face.length() > 1e-9, "{name}: triangle {triangle} is degenerate");
            for &vertex in attributes {
                let normal = DVec3::from_array(mesh.normals[vertex as usize].map(f64::from));
                assert!((normal.length() - 1.0).abs() < 1e-6, "{name}");
                assert!(normal.dot(face.normalize()) > 0.3, "{name}: triangle {triangle}");
            }
        }
    }
}

#[test]
fn volumes_approach_the_formulas() {
    let close = |mesh: &Mesh, exact: f64| {
        let error = volume(mesh) / exact - 1.0;
        assert!(error.abs() < 2e-3, "{error}");
    };
    close(&cuboid(DVec3::new(1.0, 2.0, 3.0)), 6.0);
    close(&sphere(2.0, 200, 100), 4.0 / 3.0 * PI * 8.0);
    close(&icosphere(2.0, 40), 4.0 / 3.0 * PI * 8.0);
    close(&cylinder(2.0, 3.0, 200), PI * 4.0 * 3.0);
    close(&cone(2.0, 3.0, 200, 4), PI * 4.0);
    close(&torus(2.0, 0.5, 200, 100), 2.0 * PI * PI * 2.0 * 0.25);
}

#[test]
fn triangle_counts_follow_from_the_resolutions() {
    assert_eq!(sphere(1.0, 24, 12).triangles.len(), 24 * 2 * (12 - 1));
    assert_eq!(icosphere(1.0, 7).triangles.len(), 20 * 7 * 7);
    assert_eq!(icosphere(1.0, 7).positions.len(), 10 * 7 * 7 + 2);
    assert_eq!(torus(2.0, 0.5, 24, 12).triangles.len(), 24 * 12 * 2);
    assert_eq!(cylinder(1.0, 1.0, 24).triangles.len(), 4 * 24);
    assert_eq!(cone(1.0, 1.0, 24, 1).triangles.len(), 2 * 24);
    assert_eq!(cuboid(DVec3::ONE).positions.len(), 8);
}

/// Seen from its front, a texture must not be mirrored: turning from u to v is turning the same
/// way as the triangle's corners on a page whose y runs down.
#[test]
fn textures_are_not_mirrored_and_no_triangle_spans_the_seam() {
    for (name, mesh) in shapes() {
        for attributes in mesh.attribute_corners() {
            let [a, b, c] = attributes
                .map(|vertex| DVec2::from_array(mesh.uvs[0][vertex as usize].map(f64::from)));
            assert!((b - a).perp_dot(c - a) < 1e-7, "{name}: mirrored at {a} {b} {c}");
            let widest = (b - a).abs().max((c - b).abs()).max((a - c).abs()).x;
            let flat = ["plane", "cuboid"].contains(&name);
            assert!(flat || widest <= 0.5 + 1e-6, "{name}: {a} {b} {c}");
        }
    }
}

/// Euler's V - E + F: 2 for a ball, 0 for a ring. A seam or pole that isn't welded changes it.
#[test]
fn closed_shapes_have_their_euler_characteristic_at_every_resolution() {
    let of = |mesh: &Mesh| {
        let edges = directed_edges(mesh).len() / 2;
        mesh.positions.len() as i64 - edges as i64 + mesh.triangles.len() as i64
    };
    for columns in 3..24 {
        for rows in [2, 3, 5, 8] {
            assert_eq!(of(&sphere(0.7, columns, rows)), 2, "{columns} x {rows}");
            assert_eq!(of(&cone(0.7, 1.1, columns, rows)), 2, "{columns} x {rows}");
            assert_eq!(of(&torus(0.9, 0.3, columns, rows.max(3))), 0, "{columns} x {rows}");
        }
        assert_eq!(of(&cylinder(0.7, 1.1, columns)), 2, "{columns}");
        assert_eq!(of(&icosphere(0.7, columns)), 2, "{columns}");
    }
}

#[test]
fn absurd_resolutions_are_limited() {
    assert_eq!(cylinder(1.0, 1.0, u32::MAX).triangles.len(), 4 * FINEST as usize);
    assert_eq!(plane(DVec2::ONE, 0, 0).triangles.len(), 2);
}
