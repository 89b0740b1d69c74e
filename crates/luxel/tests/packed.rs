//! Scenes and views survive the way through bytes.

use luxel::formats::{Limits, open};
use luxel::render::{Execution, Renderer, View};
use luxel::scene::{MeshId, Node, Scene, SceneMaterial, Size, demos};
use luxel::{UnpackError, pack, pack_view, unpack, unpack_view};

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
