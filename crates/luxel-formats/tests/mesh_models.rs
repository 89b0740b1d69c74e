//! Public models, against counts and bounds that other programs tell.
//!
//! `LUXEL_TEST_MODELS` names the folder, which has the truth in `expected.json`.

use luxel_formats::{Limits, Loaded, Warning, open};
use luxel_testing::models::folder;
use serde_json::Value;

fn load(name: &str) -> Option<Loaded> {
    folder().map(|folder| open(&folder.join(name), &Limits::default()).expect("a sound file"))
}

fn names(loaded: &Loaded) -> Vec<&str> {
    loaded.scene.nodes.iter().map(|node| node.name.as_str()).collect()
}

#[test]
fn counts_and_bounds_are_those_of_other_programs() {
    let Some(folder) = folder() else { return };
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let expected: Value = serde_json::from_str(&text).unwrap();
    let mut checked = 0;
    for (name, model) in expected["models"].as_object().unwrap() {
        let extension = name.rsplit('.').next().unwrap().to_ascii_lowercase();
        if !["obj", "stl", "ply"].contains(&extension.as_str()) {
            continue;
        }
        let loaded = open(&folder.join(name), &Limits::default()).unwrap();
        let triangles = model["triangles_by_peer"]["assimp"].as_u64().unwrap();
        assert_eq!(loaded.scene.triangle_count(), triangles, "{name}");
        let bounds = loaded.scene.bounds();
        // trimesh misreads negative indices; assimp prints six digits.
        let truth = &model["assimp"];
        let size = (bounds.max - bounds.min).max_element();
        for (own, key) in [(bounds.min, "bbox_min"), (bounds.max, "bbox_max")] {
            for axis in 0..3 {
                let other = truth[key][axis].as_f64().unwrap();
                assert!((own[axis] - other).abs() <= size * 2e-5, "{name} {key} {own} {other}");
            }
        }
        // Scanners write confidences, which nothing is made of.
        let is_known = |one: &Warning| one.message.starts_with("properties that are not used");
        assert!(loaded.warnings.iter().all(is_known), "{name}: {:?}", loaded.warnings);
        checked += 1;
    }
    assert!(checked >= 12);
}

#[test]
fn objects_of_a_cornell_box_have_their_names_and_materials() {
    let Some(loaded) = load("cornell_box/cornell_box.obj") else { return };
    let walls = ["floor", "ceiling", "back_wall", "green_wall", "red_wall"];
    let blocks = ["short_block", "tall_block"];
    let all = names(&loaded);
    for name in walls.into_iter().chain(blocks) {
        assert!(all.contains(&name), "{name} {all:?}");
    }
    assert_eq!(all.len(), 7, "the light and the front wall have no faces: {all:?}");
    let material = |index: usize| {
        let part = loaded.scene.meshes[index].parts[0];
        loaded.scene.materials[part.material.index()].clone()
    };
    let red = all.iter().position(|name| *name == "red_wall").unwrap();
    assert_eq!(material(red).constants.diffuse, [1.0, 0.0, 0.0]);
    assert_eq!(material(red).constants.ambient, Some([0.0; 3]));
}

#[test]
fn a_texture_with_a_space_in_its_name_is_found() {
    let Some(loaded) = load("fuze/fuze.obj") else { return };
    let image = &loaded.scene.textures[0].image;
    assert_eq!(image.name, "fuze uv.jpg");
    assert!(image.levels[0].width > 2);
    let material = &loaded.scene.materials[0];
    assert_eq!(material.name, "a-super-duper-material");
    assert_eq!(material.opacity, 1.0);
}

#[test]
fn solids_of_a_text_file_are_objects() {
    let Some(loaded) = load("two_objects_ascii.stl") else { return };
    assert_eq!(names(&loaded), ["CubeExportedFromCAD", "TranslatedCubeExportedFromCAD"]);
    assert!(loaded.scene.meshes.iter().all(|mesh| mesh.positions.len() == 8));
}

#[test]
fn attributes_of_public_ply_files_are_read() {
    let Some(monkey) = load("suzanne.ply") else { return };
    let mesh = &monkey.scene.meshes[0];
    assert_eq!(mesh.normals.len(), mesh.positions.len());
    assert_eq!(mesh.uvs[0].len(), mesh.positions.len());
    assert_eq!(mesh.polygons.as_ref().and_then(|polygons| polygons.last()), Some(&499));
    let gear = load("cycloidal.ply").unwrap();
    // All vertices are white; the faces have seven colours.
    let mut colors = gear.scene.meshes[0].colors.clone();
    colors.sort_by(|a, b| a.partial_cmp(b).unwrap());
    colors.dedup();
    assert_eq!(colors.len(), 7);
}
