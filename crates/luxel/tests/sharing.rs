//! Renderers and pickers share a scene, if it is sound, and let go of it.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel::pick::{PickError, PickView, Picker, RaysError, SceneRays};
use luxel::prelude::*;
use luxel::render::{Cull, RenderError};
use luxel::scene::{MaterialId, Mesh, MeshId, Node, Part, SceneMaterial};
use std::sync::Arc;

const SIZE: Size = Size { width: 16, height: 9 };

fn execution() -> Execution {
    Execution { threads: 1, ..Execution::default() }
}

/// A renderer and a picker that outlive the function that made them, with the scene they show.
struct Kept {
    scene: Arc<Scene>,
    renderer: Renderer,
    picker: Picker,
}

/// One triangle in the middle, among positions that make a leak show.
fn triangle() -> Scene {
    let mut positions = vec![[0.0; 3]; 4096];
    positions[..3].copy_from_slice(&[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]]);
    let mesh = Mesh {
        positions,
        triangles: vec![[0, 1, 2]],
        parts: vec![Part { first: 0, count: 1, material: MaterialId(0) }],
        ..Mesh::default()
    };
    Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial::default()],
        nodes: vec![Node::root("triangle", Some(MeshId(0)))],
        ..Scene::default()
    }
}

impl Kept {
    fn new() -> Self {
        let scene = Arc::new(triangle());
        Self {
            renderer: Renderer::new(Arc::clone(&scene), &execution()).unwrap(),
            picker: Picker::new(Arc::clone(&scene)).unwrap(),
            scene,
        }
    }

    /// What is in the middle of the window, by the picture's alpha and by a pick.
    fn middle(&self) -> (u8, Option<usize>) {
        let view = default_view(&self.scene, SIZE);
        let picture = self.renderer.rgba8(&view).unwrap();
        let picks = PickView::new(&self.picker, view.camera, SIZE, Cull::Auto).unwrap();
        (picture.pixels[4 * 16 + 8][3], picks.at([8.5, 4.5]).map(|hit| hit.object))
    }
}

#[test]
fn a_program_can_keep_a_scene_beside_its_renderer_and_picker() {
    let kept = Kept::new();
    assert_eq!(kept.middle(), (255, Some(0)));
    assert_eq!(Arc::strong_count(&kept.scene), 3);
    let Kept { scene, renderer, picker } = kept;
    drop((renderer, picker));
    assert_eq!(Arc::strong_count(&scene), 1, "a renderer or a picker leaks its scene");
}

#[test]
fn a_scene_that_refers_to_what_is_not_there_is_refused_before_it_is_drawn_or_traced() {
    let mut scene = triangle();
    scene.meshes[0].uvs[0] = vec![[0.0; 2]; 3];
    let message = "mesh 0: 3 texture coordinates for 4096 attribute vertices";
    let refused = Renderer::new(scene.clone(), &execution()).err().unwrap();
    assert!(matches!(refused, RenderError::Unsound(_)) && refused.to_string() == message);
    let refused = Picker::new(scene.clone()).err().unwrap();
    assert!(matches!(refused, PickError::Rays(_)) && refused.to_string() == message);
    let refused = SceneRays::new(scene).err().unwrap();
    assert!(matches!(refused, RaysError::Unsound(_)) && refused.to_string() == message);
}

/// Pages of the process in memory.
#[cfg(target_os = "linux")]
fn resident_pages() -> u64 {
    let statm = std::fs::read_to_string("/proc/self/statm").unwrap();
    statm.split(' ').nth(1).unwrap().parse().unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn ten_thousand_scenes_made_and_dropped_leave_no_memory_behind() {
    let make = |count: u32| {
        for _ in 0..count {
            assert_eq!(Kept::new().middle(), (255, Some(0)));
        }
        resident_pages()
    };
    let early = make(1_000);
    let late = make(9_000);
    // Two percent, and 2 MiB for what the allocator keeps: a leak of every scene would be 400 MiB.
    let most = early + early / 50 + 512;
    assert!(late <= most, "{early} pages after 1000 scenes, {late} after 10000");
}
