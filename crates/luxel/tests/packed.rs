//! Scenes and views survive the way through bytes.

use luxel::formats::{Limits, open};
use luxel::lighting::{EnvironmentMap, EquirectangularImage};
use luxel::render::{Execution, Renderer, View};
use luxel::scene::{EnvironmentChoice, MeshId, Node, Scene, SceneMaterial, Size, Viewpoint, demos};
use luxel::{
    UnpackError, pack, pack_map, pack_view, pack_view_without_map, unpack, unpack_map, unpack_view,
    unpack_view_with_map,
};
use std::sync::Arc;

fn pixels(scene: Scene, view: &View) -> Vec<[u8; 4]> {
    let execution = Execution { threads: 1, ..Execution::default() };
    let renderer = Renderer::new(scene, &execution).expect("a renderer");
    renderer.rgba8(view).expect("a picture").pixels
}

fn check(name: &str, mut scene: Scene) {
    scene.compute_normals(&Default::default());
    scene.compute_tangents();
    let view = luxel::default_view(&scene, Size { width: 160, height: 90 });
    let again = unpack(&pack(&scene)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let same = unpack_view(&pack_view(&view)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let map = |scene: &Scene| scene.environment.as_ref().is_some_and(|one| one.map().is_some());
    // Maps are equal if they are one and the same.
    assert!(same == view || map(&scene), "the view of {name} changed");
    assert_eq!(again.meshes, scene.meshes, "the meshes of {name} changed");
    assert_eq!(again.materials, scene.materials, "the materials of {name} changed");
    assert_eq!(again.textures, scene.textures, "the textures of {name} changed");
    assert_eq!(again.nodes, scene.nodes, "the nodes of {name} changed");
    assert_eq!(again.lights, scene.lights, "the lights of {name} changed");
    assert!(pixels(again, &same) == pixels(scene, &view), "the picture of {name} changed");
}

#[test]
fn packed_demos_have_the_same_pictures() {
    for (name, _) in demos::names() {
        check(name, demos::demo(name).expect("a demo"));
    }
}

#[test]
fn packed_models_have_the_same_pictures() {
    let Some(folder) = luxel_testing::models::folder() else { return };
    for name in [
        "CesiumMilkTruck.glb",
        "Fox.glb",
        "FlightHelmet/FlightHelmet.gltf",
        "two_objects_ascii.stl",
    ] {
        let path = folder.join(name);
        check(name, open(&path, &Limits::default()).expect("a model").scene);
    }
}

#[test]
fn a_packed_mesh_keeps_a_corner_that_is_not_finite() {
    let mut scene = demos::demo("teapot").expect("a demo");
    scene.meshes[0].positions[0] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    scene.compute_normals(&Default::default());
    let view = luxel::default_view(&scene, Size { width: 160, height: 90 });
    let again = unpack(&pack(&scene)).expect("a scene");
    assert_eq!(
        again.meshes[0].positions[0].map(f32::to_bits),
        scene.meshes[0].positions[0].map(f32::to_bits)
    );
    assert!(pixels(again, &view) == pixels(scene, &view), "the picture changed");
}

#[test]
fn damaged_bytes_are_errors_and_never_panics() {
    let mesh = luxel::scene::primitives::cuboid(luxel::scene::DVec3::ONE);
    let nodes = vec![Node::root("box", Some(MeshId(0)))];
    let materials = vec![SceneMaterial::default()];
    let scene = Scene { meshes: vec![mesh].into(), nodes, materials, ..Scene::default() };
    let bytes = pack(&scene);
    assert!(unpack(&bytes).is_ok(), "the whole");
    assert!(matches!(unpack(b""), Err(UnpackError::Version)));
    assert!(matches!(unpack(&bytes[1..]), Err(UnpackError::Version)));
    for end in 0..bytes.len() {
        assert!(unpack(&bytes[..end]).is_err(), "cut off at {end}");
    }
    let view = View::new(
        Size { width: 8, height: 8 },
        luxel::default_view(&scene, Size { width: 8, height: 8 }).camera,
    );
    for at in 0..bytes.len() {
        for flip in [1, 0x80, 0xff] {
            let mut damaged = bytes.clone();
            damaged[at] ^= flip;
            if let Ok(scene) = unpack(&damaged) {
                // Sound enough to be drawn.
                pixels(scene, &view);
            }
        }
    }
}

/// A small map with light from one side.
fn sky() -> EnvironmentMap {
    let light = (0..128).map(|texel| [texel as f32 / 64.0, 0.5, 1.0]).collect();
    EnvironmentMap::new("sky.hdr", EquirectangularImage { width: 16, height: 8, light })
}

#[test]
fn a_map_goes_apart_from_the_views_that_have_it() {
    let scene = demos::demo("spheres").expect("a demo");
    let map = Arc::new(sky());
    let frame = Viewpoint::frame(scene.up);
    let view = luxel::default_view(&scene, Size { width: 120, height: 80 })
        .with_environment(EnvironmentChoice::of_map(Arc::clone(&map), frame, 30.0));
    let whole = unpack_view(&pack_view(&view)).expect("a view");
    let bytes = pack_view_without_map(&view);
    assert!(bytes.len() < 2000, "{} bytes", bytes.len());
    let again = Arc::new(unpack_map(&pack_map(&map)).expect("a map"));
    assert_eq!(again.name(), "sky.hdr");
    let same = unpack_view_with_map(&bytes, Some(&again)).expect("a view");
    let expected = pixels(scene.clone(), &view);
    assert!(pixels(scene.clone(), &whole) == expected, "the map was packed otherwise");
    assert!(pixels(scene.clone(), &same) == expected, "the map was put back otherwise");
    let without = view.clone().with_environment(EnvironmentChoice::default());
    assert!(pixels(scene, &without) != expected, "the map changes nothing");
    let error = unpack_view_with_map(&bytes, None).expect_err("there is no map");
    assert!(matches!(error, UnpackError::Dangling(_)), "{error}");
    let plain = pack_view_without_map(&without);
    assert_eq!(unpack_view_with_map(&plain, None).expect("a view"), without);
}

#[test]
fn damaged_maps_are_errors_and_never_panics() {
    let bytes = pack_map(&sky());
    for end in (0..bytes.len()).step_by(997) {
        assert!(unpack_map(&bytes[..end]).is_err(), "cut off at {end}");
    }
    let scene = demos::demo("lab-silhouette").expect("a demo");
    let view = luxel::default_view(&scene, Size { width: 8, height: 8 });
    let mut lacking = 0;
    // The name, how many squares there are, and the first one's side and count of texels.
    for at in 0..60 {
        for flip in [1, 0x40, 0x80, 0xff] {
            let mut damaged = bytes.clone();
            damaged[at] ^= flip;
            match unpack_map(&damaged) {
                Ok(map) => {
                    // Sound enough to be drawn.
                    let frame = Viewpoint::frame(scene.up);
                    let choice = EnvironmentChoice::of_map(Arc::new(map), frame, 0.0);
                    pixels(scene.clone(), &view.clone().with_environment(choice));
                }
                Err(UnpackError::Dangling(_)) => lacking += 1,
                Err(_) => {}
            }
        }
    }
    assert!(lacking > 0, "a square's side was never wrong");
}
