//! Models whose files are in memory.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_formats::{GivenFiles, Limits, open};
use std::path::Path;

const GLTF: &str = r#"{
    "asset": { "version": "2.0" },
    "buffers": [{ "uri": "a%20b.bin", "byteLength": 36 }],
    "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
    "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [0, 0, 0], "max": [1, 1, 0] }],
    "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
    "nodes": [{ "mesh": 0 }],
    "scenes": [{ "nodes": [0] }]
}"#;

fn corners() -> Vec<u8> {
    [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|x| x.to_le_bytes()).collect()
}

fn limits(files: &[(&str, Vec<u8>)]) -> Limits {
    let files = files.iter().map(|(path, bytes)| (*path, bytes.clone()));
    Limits { given: Some(GivenFiles::new(files)), ..Limits::default() }
}

#[test]
fn a_buffer_is_found_beside_its_document() {
    let files = [("model/part.gltf", GLTF.into()), ("model/a b.bin", corners())];
    let model = open(Path::new("model/part.gltf"), &limits(&files)).unwrap();
    assert_eq!(model.scene.triangle_count(), 1);
}

#[test]
fn what_is_not_given_is_not_read_from_a_disk() {
    // The test runs in the crate's folder, which has this file.
    assert!(Path::new("Cargo.toml").is_file());
    let document = GLTF.replace("a%20b.bin", "Cargo.toml");
    let error =
        open(Path::new("part.gltf"), &limits(&[("part.gltf", document.into())])).unwrap_err();
    assert!(error.to_string().contains("`Cargo.toml` can't be read"), "{error}");
    let error = open(Path::new("Cargo.obj"), &limits(&[])).unwrap_err();
    assert!(error.to_string().starts_with("Cargo.obj: "), "{error}");
}

#[test]
fn files_in_memory_count_against_the_limit() {
    let files = [("part.gltf", GLTF.into()), ("a b.bin", vec![0; 1 << 20])];
    let limits = Limits { max_memory: 100_000, ..limits(&files) };
    let error = open(Path::new("part.gltf"), &limits).unwrap_err();
    assert_eq!(error.hint(), Some(luxel_formats::Hint::RaiseMemoryLimit), "{error}");
}

#[test]
fn long_files_are_read_from_memory_too() {
    let count = 250_000_u32;
    let head = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {count}\nproperty float x\n\
         property float y\nproperty float z\nproperty double w\nproperty double v\n\
         property double u\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
    );
    let mut bytes = head.into_bytes();
    bytes.resize(bytes.len() + count as usize * 36, 0);
    let model = open(Path::new("cloud.ply"), &limits(&[("cloud.ply", bytes)])).unwrap();
    assert_eq!(model.scene.meshes.iter().map(|mesh| mesh.positions.len()).sum::<usize>(), 250_000);
}
