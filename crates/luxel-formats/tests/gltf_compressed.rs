//! Compressed geometry: one small height field, written plain, by the reference encoder of meshopt
//! and by the one of Draco (npm `@gltf-transform/core` 4 with `meshoptimizer` 1.3.0 and
//! `draco3dgltf`), has to come out the same.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_formats::{Format, Limits, read};
use luxel_scene::{DVec3, Scene};
use proptest::prelude::*;

const PLAIN: &[u8] = include_bytes!("grid/plain.glb");
const COMPRESSED: [(&str, &[u8]); 4] = [
    ("meshopt", include_bytes!("grid/meshopt.glb")),
    ("Draco, edgebreaker", include_bytes!("grid/draco-edgebreaker.glb")),
    ("Draco, edgebreaker with valences", include_bytes!("grid/draco-valence.glb")),
    ("Draco, sequential", include_bytes!("grid/draco-sequential.glb")),
];

/// A corner as the file's own space has it.
#[derive(Debug)]
struct Corner {
    position: DVec3,
    normal: [f32; 3],
    uv: [f32; 2],
    color: [f32; 4],
}

fn scene(bytes: &[u8]) -> Scene {
    let loaded = read(bytes, Format::Glb, "test", None, &Limits::default());
    let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
    assert!(loaded.warnings.is_empty(), "{:?}", loaded.warnings);
    loaded.scene
}

/// The triangles, each begun at its corner of the lowest position, in the order of positions: so
/// that neither the order of triangles nor that of corners counts, but winding does.
fn triangles(scene: &Scene) -> Vec<[Corner; 3]> {
    let object = &scene.objects()[0];
    let mesh = &scene.meshes[object.mesh.index()];
    let part = mesh.parts[0].material.index();
    let [a, b, c, d, e, f] = scene.materials[part]
        .base_color
        .as_ref()
        .map_or([1.0, 0.0, 0.0, 0.0, 1.0, 0.0], |usage| usage.transform);
    let corner = |index: u32| {
        let [u, v] = mesh.uvs[0][index as usize];
        Corner {
            position: object.world_from_mesh.matrix().transform_point3(mesh.position(index)),
            normal: mesh.normals[index as usize],
            uv: [a * u + b * v + c, d * u + e * v + f],
            color: mesh.colors[index as usize],
        }
    };
    let key = |corner: &Corner| {
        let cell = |value: f64| ((value + 2.0) * 10.0).round() as i64;
        (cell(corner.position.x), cell(corner.position.z))
    };
    let mut triangles: Vec<[Corner; 3]> = mesh
        .triangles
        .iter()
        .map(|corners| {
            let mut corners = corners.map(corner);
            let first = (0..3).min_by_key(|&index| key(&corners[index])).unwrap();
            corners.rotate_left(first);
            corners
        })
        .collect();
    triangles.sort_by_key(|corners| [0, 1, 2].map(|index| key(&corners[index])));
    triangles
}

#[test]
fn compressed_geometry_is_the_plain_one() {
    let plain = triangles(&scene(PLAIN));
    assert_eq!(plain.len(), 50);
    for (kind, bytes) in COMPRESSED {
        let compressed = triangles(&scene(bytes));
        assert_eq!(compressed.len(), plain.len(), "{kind}");
        for (ours, theirs) in compressed.iter().flatten().zip(plain.iter().flatten()) {
            let say = || format!("{kind}: {ours:?} is not {theirs:?}");
            assert!(ours.position.abs_diff_eq(theirs.position, 2e-3), "{}", say());
            let near =
                |a: &[f32], b: &[f32], by: f32| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= by);
            assert!(near(&ours.normal, &theirs.normal, 0.03), "{}", say());
            assert!(near(&ours.uv, &theirs.uv, 2e-3), "{}", say());
            assert!(near(&ours.color, &theirs.color, 0.005), "{}", say());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn changed_streams_never_panic(
        which in 0..COMPRESSED.len(),
        changes in proptest::collection::vec((any::<usize>(), any::<u8>()), 1..6),
    ) {
        let mut glb = COMPRESSED[which].1.to_vec();
        let text_length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
        let start = 20 + text_length + 8;
        for (at, value) in changes {
            let at = start + at % (glb.len() - start);
            glb[at] = value;
        }
        let limits = Limits { max_memory: 1 << 26, ..Limits::default() };
        let _ = read(&glb, Format::Glb, "test", None, &limits);
    }
}
