//! Long files: reading them block by block gives the same as reading their bytes.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_formats::{Error, ErrorKind, Format, Limits, Loaded, Progress, open, read};
use std::path::Path;

fn read_bytes(bytes: &[u8], format: Format, path: &Path) -> Result<Loaded, Error> {
    let stem = path.file_stem().unwrap().to_string_lossy();
    read(bytes, format, &stem, None, &Limits::default())
}

fn binary_stl(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        bytes.extend([0; 12]);
        bytes.extend(corners.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// A PLY of 260,000 vertices and as many faces of `corners` corners.
fn long_file(corners: u8, wrong_index: bool) -> Vec<u8> {
    const COUNT: u32 = 260_000;
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {COUNT}\nproperty float x\n\
         property float y\nproperty float z\nproperty float nx\nproperty float ny\n\
         property float nz\nelement face {COUNT}\nproperty list uchar int vertex_indices\n\
         end_header\n"
    )
    .into_bytes();
    for vertex in 0..COUNT {
        let position = [vertex % 512, vertex / 512, vertex % 7].map(|value| value as f32);
        for value in position.into_iter().chain([0.0, 0.0, 1.0]) {
            bytes.extend(value.to_le_bytes());
        }
    }
    for face in 0..COUNT {
        bytes.push(corners);
        for corner in 0..u32::from(corners) {
            let is_wrong = wrong_index && face == COUNT - 2 && corner == 1;
            let index = if is_wrong { COUNT } else { (face + corner * corner) % COUNT };
            bytes.extend(index.to_le_bytes());
        }
    }
    bytes
}

#[test]
fn an_stl_read_in_blocks_equals_one_read_from_memory() {
    // More than are read at a time, with corners that come again much later, and one that isn't
    // finite.
    let triangles: Vec<_> = (0..170_000_u32)
        .map(|number| {
            let [x, y] = [number % 251, number % 83].map(|part| part as f32);
            let z = if number == 99_999 { f32::NAN } else { 1.0 };
            [[x, y, 0.0], [y, x, -0.0], [x, y, z]]
        })
        .collect();
    let bytes = binary_stl(&triangles);
    let folder = std::env::temp_dir();
    let stream = |bytes: &[u8]| {
        let path = folder.join(format!("luxel-long-{}.stl", std::process::id()));
        std::fs::write(&path, bytes).unwrap();
        let loaded = open(&path, &Limits::default()).unwrap();
        std::fs::remove_file(&path).unwrap();
        loaded
    };
    let (stored, held) =
        (stream(&bytes), read_bytes(&bytes, Format::Stl, "stem".as_ref()).unwrap());
    assert_eq!(stored.warnings, held.warnings);
    assert_eq!(stored.warnings, ["1 face with a corner that is not finite was left out"]);
    let [stored, held] = [&stored.scene.meshes[0], &held.scene.meshes[0]];
    assert_eq!(stored.triangles, held.triangles);
    assert_eq!(stored.positions, held.positions);
    // Longer than declared: a warning, as from memory.
    assert_eq!(stream(&[bytes, b"more".to_vec()].concat()).warnings.len(), 2);
}

#[test]
fn a_ply_read_in_blocks_equals_one_read_from_memory() {
    let path = std::env::temp_dir().join(format!("luxel-long-{}.ply", std::process::id()));
    let whole = long_file(3, false);
    let cut = whole[..whole.len() - 1000].to_vec();
    for (what, bytes) in [
        ("triangles", whole),
        ("quadrangles, for which the file must be read whole", long_file(4, false)),
        ("an index out of range", long_file(3, true)),
        ("a file that ends too early", cut),
    ] {
        std::fs::write(&path, &bytes).unwrap();
        let progress = Progress::default();
        let limits = Limits { progress: Some(progress.clone()), ..Limits::default() };
        let stored = open(&path, &limits);
        let held = read_bytes(&bytes, Format::Ply, &path);
        match (stored, held) {
            (Ok(stored), Ok(held)) => {
                assert!(stored.scene.meshes == held.scene.meshes, "{what}");
                assert_eq!(stored.warnings, held.warnings, "{what}");
                let (read, all) = progress.bytes();
                assert_eq!(read, all, "{what}: the progress would never reach its end");
            }
            (stored, held) => {
                let stored = stored.unwrap_err().to_string();
                let held = held.unwrap_err().in_file(&path).to_string();
                assert!(stored == held, "{what}: `{stored}`, but `{held}`");
            }
        }
    }
    std::fs::remove_file(&path).unwrap();
}

#[test]
fn a_stopped_reader_fails() {
    let path = std::env::temp_dir().join(format!("luxel-left-{}.ply", std::process::id()));
    std::fs::write(&path, long_file(3, false)).unwrap();
    let progress = Progress::default();
    progress.stop();
    let limits = Limits { progress: Some(progress), ..Limits::default() };
    let error = open(&path, &limits).unwrap_err();
    assert!(matches!(error.kind, ErrorKind::Stopped), "{error}");
    std::fs::remove_file(&path).unwrap();
}
