use super::*;
use crate::Bounds;
use std::collections::{BTreeMap, BTreeSet};

/// Positions at the end of which no triangle goes on, as closed walks along the open edges.
fn open_loops(mesh: &Mesh) -> Vec<usize> {
    let mut edges = BTreeSet::new();
    for [a, b, c] in &mesh.triangles {
        for edge in [[*a, *b], [*b, *c], [*c, *a]] {
            assert!(edges.insert(edge), "an edge runs twice in one direction");
        }
    }
    let open = edges.iter().filter(|[a, b]| !edges.contains(&[*b, *a])).map(|[a, b]| (*a, *b));
    let mut next: BTreeMap<u32, u32> = open.collect();
    let mut loops = Vec::new();
    while let Some((start, mut at)) = next.pop_first() {
        let mut length = 1;
        while at != start {
            at = next.remove(&at).expect("an open edge goes on");
            length += 1;
        }
        loops.push(length);
    }
    loops
}

fn part(name: &str) -> Mesh {
    parts(16).into_iter().find(|(part, _)| *part == name).unwrap().1
}

fn corners(mesh: &Mesh, triangle: usize) -> [DVec3; 3] {
    mesh.triangles[triangle].map(|index| mesh.position(index))
}

#[test]
fn parts_are_closed_but_for_the_openings_newell_left() {
    // The rim towards the lid; the lid's edge; both ends of the handle and of the spout.
    assert_eq!(open_loops(&part("body")), [64]);
    assert_eq!(open_loops(&part("lid")), [64]);
    assert_eq!(open_loops(&part("handle")), [32, 32]);
    assert_eq!(open_loops(&part("spout")), [32, 32]);
}

#[test]
fn thirty_two_patches_give_their_triangles_less_those_at_poles() {
    for steps in [1, 2, 10, 16] {
        let count: usize = parts(steps).iter().map(|(_, mesh)| mesh.triangles.len()).sum();
        let steps = steps as usize;
        assert_eq!(count, 32 * 2 * steps * steps - 8 * steps);
    }
}

#[test]
fn the_bounds_are_those_of_the_known_teapot() {
    let mut bounds = Bounds::EMPTY;
    for (_, mesh) in parts(16) {
        bounds = bounds.union(&mesh.bounds(&DMat4::IDENTITY));
    }
    assert!(bounds.min.abs_diff_eq(DVec3::new(-3.0, 0.0, -2.0), 1e-6), "{bounds:?}");
    // The lip's highest x lies between control points.
    assert!(bounds.max.abs_diff_eq(DVec3::new(3.434, 3.15, 2.0), 2e-3), "{bounds:?}");
}

#[test]
fn a_quarter_turn_maps_body_and_lid_onto_themselves_bit_by_bit() {
    for name in ["body", "lid"] {
        let bits = |position: [f32; 3]| position.map(|value| (value + 0.0).to_bits());
        let mesh = part(name);
        let places: BTreeSet<_> = mesh.positions.iter().copied().map(bits).collect();
        assert_eq!(places.len(), mesh.positions.len(), "{name}: a position is there twice");
        for [x, y, z] in mesh.positions {
            assert!(places.contains(&bits([z, y, -x])), "{name}: ({x}, {y}, {z})");
        }
    }
}

#[test]
fn handle_and_spout_are_their_own_mirror_images() {
    for name in ["handle", "spout"] {
        let bits = |position: [f32; 3]| position.map(|value| (value + 0.0).to_bits());
        let mesh = part(name);
        let places: BTreeSet<_> = mesh.positions.iter().copied().map(bits).collect();
        for [x, y, z] in mesh.positions {
            assert!(places.contains(&bits([x, y, -z])), "{name}: ({x}, {y}, {z})");
        }
    }
}

#[test]
fn normals_are_units_and_look_to_the_front_of_their_triangles() {
    for (name, mesh) in parts(16) {
        for (triangle, attributes) in mesh.attribute_corners().iter().enumerate() {
            let [a, b, c] = corners(&mesh, triangle);
            let face = (b - a).cross(c - a);
            assert!(face.length() > 1e-9, "{name}: triangle {triangle} is degenerate");
            for &vertex in attributes {
                let normal = DVec3::from_array(mesh.normals[vertex as usize].map(f64::from));
                assert!((normal.length() - 1.0).abs() < 1e-6);
                let cosine = normal.dot(face.normalize());
                // The spout's lip is the tightest curve.
                assert!(cosine > 0.6, "{name}: triangle {triangle} at {a}: {cosine}");
            }
        }
    }
}

#[test]
fn the_belly_faces_outwards_the_knob_up_and_the_bottom_down() {
    let body = part("body");
    for (triangle, attributes) in body.attribute_corners().iter().enumerate() {
        let [a, ..] = corners(&body, triangle);
        let normal = DVec3::from_array(body.normals[attributes[0] as usize].map(f64::from));
        if (0.5..2.0).contains(&a.y) {
            assert!(normal.dot(a.with_y(0.0).normalize()) > 0.3, "{a}: {normal}");
        }
        if a.y == 0.0 {
            assert_eq!(normal, DVec3::NEG_Y);
        }
    }
    let lid = part("lid");
    let highest = |vertex: usize, [.., y, _]: [f32; 3]| (y == 3.15).then_some(lid.normals[vertex]);
    let tops: Vec<_> = lid
        .attribute_corners()
        .iter()
        .zip(&lid.triangles)
        .flat_map(|(attributes, corners)| std::iter::zip(*attributes, *corners))
        .filter_map(|(vertex, at)| highest(vertex as usize, lid.positions[at as usize]))
        .collect();
    assert!(!tops.is_empty() && tops.iter().all(|normal| *normal == [0.0, 1.0, 0.0]));
}

/// Normals of two patches that meet smoothly must meet too, or a seam shows.
#[test]
fn no_seam_shows_where_patches_meet() {
    for (name, mesh) in parts(8) {
        let mut normal_at = BTreeMap::new();
        let pairs = mesh.attribute_corners().iter().zip(&mesh.triangles);
        for (vertex, at) in pairs.flat_map(|(vertices, at)| std::iter::zip(*vertices, *at)) {
            let normal = DVec3::from_array(mesh.normals[vertex as usize].map(f64::from));
            let first = *normal_at.entry(at).or_insert(normal);
            // The knob's quarters meet at an angle of less than a degree: their levers are 0.45.
            assert!(first.dot(normal) > 0.999, "{name}: {first} and {normal}");
        }
    }
}

/// The file is another program's tessellation of the same patches, ten steps a side.
#[test]
fn the_tessellation_is_that_of_the_public_teapot_file() {
    let Some(folder) = luxel_testing::models::folder() else { return };
    let text = std::fs::read_to_string(folder.join("teapot.obj")).unwrap();
    let theirs: Vec<DVec3> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect::<Vec<_>>())
        .map(|place| DVec3::from_slice(&place))
        .collect();
    let faces = text.lines().filter(|line| line.starts_with("f ")).count();
    let parts = parts(10);
    assert_eq!(parts.iter().map(|(_, mesh)| mesh.triangles.len()).sum::<usize>(), faces);
    let ours: Vec<DVec3> = parts
        .iter()
        .flat_map(|(_, mesh)| (0..mesh.positions.len()).map(|at| mesh.position(at as u32)))
        .collect();
    let nearest = |place: DVec3, among: &[DVec3]| {
        among.iter().map(|other| other.distance(place)).fold(f64::INFINITY, f64::min)
    };
    for place in &theirs {
        assert!(nearest(*place, &ours) < 2e-6, "we lack {place}");
    }
    for place in &ours {
        assert!(nearest(*place, &theirs) < 2e-6, "the file lacks {place}");
    }
}
