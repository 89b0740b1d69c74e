//! Real models against the results of other programs.
//!
//! The folder is named by `LUXEL_TEST_MODELS`; its `expected.json` holds the counts and bounds that
//! trimesh, gltf-transform and the Khronos validator agree on.

use luxel_formats::{Limits, Loaded, open};
use luxel_scene::Lens;
use luxel_testing::models::folder;
use serde_json::Value;

const MODELS: [&str; 7] = [
    "CesiumMilkTruck.glb",
    "DepthOfFieldExample.glb",
    "FlightHelmet/FlightHelmet.gltf",
    "Fox.glb",
    "VertexColorTest/VertexColorTest.gltf",
    "cakeBirthday.glb",
    "sphere_lights/sphere_lights.gltf",
];

fn load(model: &str) -> Option<Loaded> {
    let path = folder()?.join(model);
    Some(open(&path, &Limits::default()).unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn triangles_and_bounds_are_those_that_others_find() {
    let Some(folder) = folder() else { return };
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let expected: Value = serde_json::from_str(&text).unwrap();
    for model in MODELS {
        let Some(loaded) = load(model) else { return };
        let expected = &expected["models"][model];
        let scene = &loaded.scene;
        let others = &expected["gltf_transform"];
        assert_eq!(
            scene.triangle_count(),
            others["scene_triangles_with_instancing"].as_u64().unwrap(),
            "{model}"
        );
        assert_eq!(
            scene.objects().len() as u64,
            expected["file"]["mesh_nodes_in_scene"].as_u64().unwrap(),
            "{model}"
        );
        let bounds = scene.bounds();
        let size = 2.0 * bounds.radius();
        for (corner, ours) in [("bbox_min", bounds.min), ("bbox_max", bounds.max)] {
            for axis in 0..3 {
                let theirs = others[corner][axis].as_f64().unwrap();
                let off = (ours[axis] - theirs).abs();
                assert!(off < 1e-5 * size, "{model} {corner}[{axis}]: {} not {theirs}", ours[axis]);
            }
        }
    }
}

#[test]
fn no_model_is_warned_of() {
    for model in MODELS {
        let Some(loaded) = load(model) else { return };
        assert!(loaded.warnings.is_empty(), "{model}: {:?}", loaded.warnings);
    }
}

#[test]
fn names_and_paths_are_the_files() {
    let Some(cake) = load("cakeBirthday.glb") else { return };
    let paths: Vec<_> = cake.scene.objects().iter().map(|o| cake.scene.path(o.node)).collect();
    assert_eq!(paths, vec![vec!["cakeBirthday", "slice"]; 6]);
    let Some(truck) = load("CesiumMilkTruck.glb") else { return };
    let names: Vec<_> = truck.scene.nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["Cesium_Milk_Truck", "node_3", "Wheels", "node_1", "Wheels"]);
}

#[test]
fn a_mesh_of_two_nodes_is_kept_once() {
    let Some(truck) = load("CesiumMilkTruck.glb") else { return };
    let objects = truck.scene.objects();
    assert_eq!(truck.scene.meshes.len(), 2);
    assert_eq!(objects[1].mesh, objects[2].mesh);
}

#[test]
fn primitives_that_share_accessors_share_vertices() {
    let Some(cake) = load("cakeBirthday.glb") else { return };
    for mesh in &cake.scene.meshes {
        assert_eq!(mesh.parts.len(), 7);
        assert_eq!(mesh.positions.len(), 348);
    }
}

#[test]
fn lights_have_names_places_and_units() {
    let Some(spheres) = load("sphere_lights/sphere_lights.gltf") else { return };
    let names: Vec<_> = spheres.scene.lights.iter().map(|light| light.name.as_str()).collect();
    assert_eq!(names, ["Blue Lightsaber", "Arc Reactor", "light_3", "The Star of Earendil"]);
    let arc = &spheres.scene.lights[1].light;
    assert!((f64::from(arc.diffuse[0]) - 0.9 / std::f64::consts::PI).abs() < 1e-7);
}

#[test]
fn textures_are_decoded_and_shared() {
    let Some(helmet) = load("FlightHelmet/FlightHelmet.gltf") else { return };
    let scene = &helmet.scene;
    assert_eq!(scene.materials.len(), 6);
    assert!(scene.textures.len() >= 15);
    assert!(scene.textures.iter().all(|texture| texture.image.levels[0].width > 1));
    assert!(scene.cameras.iter().all(|camera| matches!(camera.lens, Lens::Perspective { .. })));
}
