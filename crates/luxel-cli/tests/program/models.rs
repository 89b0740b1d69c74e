//! Public models, against the results of other programs.

use crate::program::Folder;
use luxel_testing::models;
use serde_json::Value;
use std::path::Path;

/// Each model's path with its triangles and bounds, from independent programs.
fn expectations(folder: &Path) -> Vec<(String, u64, [Vec<f64>; 2])> {
    let text = std::fs::read(folder.join("expected.json")).unwrap();
    let expected: Value = serde_json::from_slice(&text).unwrap();
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
    };
    let of = |(name, entry): (&String, &Value)| {
        let by_peer = &entry["triangles_by_peer"];
        let triangles = ["file", "gltf_transform", "trimesh", "assimp"]
            .into_iter()
            .find_map(|peer| by_peer[peer].as_u64())
            .unwrap();
        // trimesh reads relative indices wrongly, assimp ignores the nodes of glTF files.
        let peers: &[&str] = if name.contains("gl") {
            &["gltf_transform", "trimesh"]
        } else {
            &["file", "assimp", "trimesh"]
        };
        let peer = peers.iter().find(|peer| entry[**peer]["bbox_min"].is_array()).unwrap();
        let bounds = ["bbox_min", "bbox_max"].map(|key| numbers(&entry[*peer][key]));
        (name.clone(), triangles, bounds)
    };
    expected["models"].as_object().unwrap().iter().map(of).collect()
}

#[test]
fn triangles_and_bounds_agree_with_other_programs() {
    let Some(models) = models::folder() else { return };
    let folder = Folder::new();
    for (name, triangles, bounds) in expectations(&models) {
        let path = models.join(&name);
        let run = folder.run(["info", "--json", "--quiet", path.to_str().unwrap()]);
        let info = run.json();
        assert_eq!(info["triangles"].as_u64(), Some(triangles), "{name}");
        let extent = (0..3).map(|axis| bounds[1][axis] - bounds[0][axis]).fold(0.0, f64::max);
        for (key, expected) in ["min", "max"].into_iter().zip(&bounds) {
            for axis in 0..3 {
                let value = info["bounds"][key][axis].as_f64().unwrap();
                let error = (value - expected[axis]).abs();
                assert!(error <= 1e-5 * extent.max(1.0), "{name}: {key} {axis}: {value}");
            }
        }
    }
}

#[test]
fn every_model_renders_a_nonempty_image() {
    let Some(models) = models::folder() else { return };
    let folder = Folder::new();
    for (name, ..) in expectations(&models) {
        let path = models.join(&name);
        let line = ["render", path.to_str().unwrap(), "-o", "a.ppm", "--size", "80x60", "--quiet"];
        folder.run(line).done();
        let bytes = folder.read("a.ppm");
        let pixels = &bytes[bytes.len() - 80 * 60 * 3..];
        let lit = pixels.chunks(3).filter(|pixel| pixel.iter().any(|&byte| byte > 8)).count();
        assert!(lit > 200, "{name}: {lit} pixels are lit");
    }
}
