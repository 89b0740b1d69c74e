//! Picks agree with frames at every pixel, in scenes of all kinds.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel::formats::{Limits, open};
use luxel::pick::{Element, PhysicalPosition, PickView, Picker, Region, VisibleIds};
use luxel::render::{Cull, Execution, Layer, LayerValues, Renderer};
use luxel::scene::{
    Camera, DMat4, DVec3, Lens, Lines, MaterialId, Mesh, MeshId, Node, NormalOptions, NormalSource,
    Part, Points, Projection, Scene, SceneMaterial, Sides, Size, Viewpoint, demos, fit_view,
};
use luxel_testing::models;

const SIZE: Size = Size { width: 230, height: 170 };

fn fitted(scene: &Scene, azimuth: f64, lens: Lens) -> Camera {
    let viewpoint = Viewpoint { up: scene.up, azimuth_radians: azimuth, elevation_radians: 0.35 };
    fit_view(scene, &viewpoint, lens, SIZE)
}

const PERSPECTIVE: Lens = Lens::Perspective { fov_y_radians: 0.8 };

/// Compares picks with layers at every pixel; how many pixels saw something.
fn compare(scene: &Scene, camera: Camera, size: Size, cull: Cull) -> usize {
    let mut view = luxel::default_view(scene, size);
    (view.camera, view.samples, view.cull) = (camera, 1, cull);
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    let layers = [
        Layer::Object,
        Layer::Triangle,
        Layer::Barycentric,
        Layer::Position,
        Layer::Normal,
        Layer::Uv,
        Layer::Depth,
        Layer::Z,
    ];
    let values = renderer.layers(&view, &layers).unwrap();
    let ids = |at: usize| match &values[at] {
        LayerValues::U32(values) => values.as_slice(),
        LayerValues::F32(_) => panic!("ids"),
    };
    let floats = |at: usize| match &values[at] {
        LayerValues::F32(values) => values.as_slice(),
        LayerValues::U32(_) => panic!("floats"),
    };
    let picker = Picker::new(scene.clone()).unwrap();
    let picks = PickView::new(&picker, camera, size, cull).unwrap();
    // What is drawn of a part alone is what the frame shows there.
    let shown = VisibleIds::new(size, ids(0).to_vec(), ids(1).to_vec()).unwrap();
    assert_eq!(picks.visible_ids(), shown);
    let (w, h) = (f64::from(size.width), f64::from(size.height));
    for [x, y, width, height] in [
        [0.0, 0.0, w, h],
        [w * 0.4, h * 0.3, 5.0, 5.0],
        [w * 0.5 + 0.25, h * 0.5 - 0.25, 0.5, 1.0],
        [60.5, 62.25, 71.0, 9.5],
        [-9.0, h - 20.0, w, 40.0],
    ] {
        let region = Region::rectangle(x, y, width, height).unwrap();
        assert_eq!(picks.visible_in(&region), shown.in_region(&region), "{x} {y} {width} {height}");
    }
    let mut seen = 0;
    for y in 0..size.height {
        for x in 0..size.width {
            let at = (y * size.width + x) as usize;
            let hit = picks.at(PhysicalPosition::centre_of(x, y));
            let Some(hit) = hit else {
                assert_eq!(ids(0)[at], u32::MAX, "({x}, {y}) shows something that isn't picked");
                continue;
            };
            seen += 1;
            assert_eq!(hit.object as u32, ids(0)[at], "({x}, {y}): {hit:?}");
            let triangle = match hit.element {
                Element::Triangle(triangle) => triangle,
                Element::Point(_) | Element::Line(_) => u32::MAX,
            };
            assert_eq!(triangle, ids(1)[at], "({x}, {y}): {hit:?}");
            if triangle != u32::MAX {
                assert_eq!(hit.barycentric, floats(2)[3 * at..3 * at + 3], "({x}, {y})");
            }
            let position = hit.position.to_array().map(|x| x as f32);
            assert_eq!(position, floats(3)[3 * at..3 * at + 3], "({x}, {y})");
            assert_eq!(hit.normal, floats(4)[3 * at..3 * at + 3], "({x}, {y})");
            assert_eq!(hit.uv.unwrap_or_default(), floats(5)[2 * at..2 * at + 2], "({x}, {y})");
            assert_eq!(hit.depth as f32, floats(6)[at], "({x}, {y})");
            assert_eq!(hit.z, floats(7)[at], "({x}, {y})");
            let all = picks.through(PhysicalPosition::centre_of(x, y));
            assert_eq!(all[0], hit, "({x}, {y})");
        }
    }
    seen
}

#[test]
fn every_pixel_of_the_demos_is_picked_as_drawn() {
    for (name, _) in demos::names() {
        if name == "blob" {
            continue;
        }
        // Sheets and panels are narrow from the side.
        let least = if name.starts_with("lab-") { 1000 } else { 3000 };
        let mut scene = demos::demo(name).unwrap();
        scene.compute_normals(&NormalOptions::default());
        for cull in [Cull::Auto, Cull::Back] {
            let seen = compare(&scene, fitted(&scene, 0.5, PERSPECTIVE), SIZE, cull);
            assert!(seen > least, "{name}: {seen}");
        }
        let parallel = fitted(&scene, 2.5, Lens::Orthographic { height: 0.0 });
        assert!(compare(&scene, parallel, SIZE, Cull::Auto) > least, "{name}");
        let off_centre = Lens::Intrinsics { fx: 300.0, fy: 280.0, cx: 40.0, cy: 140.0 };
        let mut camera = fitted(&scene, -1.0, off_centre);
        camera.projection.far = f64::INFINITY;
        assert!(compare(&scene, camera, SIZE, Cull::None) > least, "{name}");
    }
}

#[test]
fn every_pixel_is_picked_as_drawn_from_inside_with_planes_that_clip() {
    for name in ["teapot", "cornell", "spheres"] {
        let scene = demos::demo(name).unwrap();
        let bounds = scene.bounds();
        let eye = bounds.centre() + DVec3::new(0.05, 0.02, 0.03) * bounds.radius();
        let mut least = usize::MAX;
        for target in [DVec3::X, DVec3::new(-0.3, 0.2, -1.0), DVec3::NEG_Y] {
            let view_from_world = Camera::look_at(eye, eye + target, DVec3::Y);
            let radius = bounds.radius();
            for (near, far) in [(0.001 * radius, 3.0 * radius), (0.3 * radius, 0.6 * radius)] {
                let lens = Lens::Perspective { fov_y_radians: 1.4 };
                let projection = Projection { lens, near, far };
                let camera = Camera { view_from_world, projection };
                let seen = compare(&scene, camera, SIZE, Cull::Auto);
                assert!(seen > 200, "{name}, {target}, {near}: {seen}");
                least = least.min(seen);
            }
        }
        // Walls that fill a view may lie between the second planes; not in every direction.
        let all = (SIZE.width * SIZE.height) as usize;
        assert!(least < all, "{name}: no plane opens the scene");
    }
}

/// A plane, a box of large and tiny triangles, points and lines, nodes that stretch, flatten and
/// mirror, far from the origin.
fn awkward() -> Scene {
    let mut scene = demos::demo("spheres").unwrap();
    let far = DMat4::from_translation(DVec3::new(4.0e5, -7.0e5, 2.0e4));
    let mut mesh = Mesh {
        positions: vec![
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [-1.0, 1.0, 0.5],
            [0.0, 0.0, 1.5],
            [900.0, 3.0, -1.0],
            [0.3, 0.3, 0.3],
        ],
        triangles: vec![
            [0, 1, 2],
            [0, 2, 3],
            [0, 1, 4],
            [1, 5, 4],
            [2, 3, 4],
            [0, 0, 1],
            [6, 6, 6],
        ],
        ..Mesh::default()
    };
    let material = MaterialId(scene.materials.len() as u32);
    scene.materials.push(SceneMaterial { sides: Sides::Front, ..SceneMaterial::default() });
    mesh.parts = vec![
        Part { first: 0, count: 3, material },
        Part { first: 3, count: 4, material: MaterialId(0) },
    ];
    mesh.points = vec![Points { indices: vec![0, 1, 4, 6], material }];
    mesh.lines = vec![Lines { segments: vec![[0, 4], [4, 5], [2, 3]], material }];
    let id = MeshId(scene.meshes.len() as u32);
    scene.meshes.push(mesh);
    for (number, transform) in [
        DMat4::IDENTITY,
        DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0)),
        DMat4::from_translation(DVec3::Y * 2.0) * DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0)),
        DMat4::from_translation(DVec3::NEG_Y) * DMat4::from_scale(DVec3::new(2.0, 1e-6, 0.5)),
        DMat4::from_rotation_x(0.7) * DMat4::from_scale(DVec3::splat(0.01)),
    ]
    .into_iter()
    .enumerate()
    {
        let mut node = Node::root(format!("node {number}"), Some(id));
        node.parent_from_node = transform.into();
        scene.nodes.push(node);
    }
    for node in &mut scene.nodes {
        if node.parent.is_none() {
            node.parent_from_node = (far * node.parent_from_node.matrix()).into();
        }
    }
    scene
}

#[test]
fn every_pixel_of_an_awkward_scene_is_picked_as_drawn() {
    let scene = awkward();
    let middle = DVec3::new(4.0e5, -7.0e5, 2.0e4);
    for (eye, near, far) in [
        (DVec3::new(3.0, 2.0, 6.0), 0.1, 100.0),
        (DVec3::new(0.2, 0.1, 1.0), 0.01, 2000.0),
        (DVec3::new(0.0, 0.0, 5.0), 4.0, 5.5),
    ] {
        let view_from_world = Camera::look_at(middle + eye, middle, DVec3::Y);
        for lens in [PERSPECTIVE, Lens::Orthographic { height: 5.0 }] {
            let camera = Camera { view_from_world, projection: Projection { lens, near, far } };
            for cull in [Cull::Auto, Cull::None] {
                assert!(compare(&scene, camera, SIZE, cull) > 500);
            }
        }
    }
}

#[test]
fn every_pixel_of_public_models_is_picked_as_drawn() {
    let Some(folder) = models::folder() else { return };
    for name in [
        "bunny.ply",
        "CesiumMilkTruck.glb",
        "cakeBirthday.glb",
        "busted.STL",
        "teapot.obj",
        "FlightHelmet/FlightHelmet.gltf",
        "VertexColorTest/VertexColorTest.gltf",
        "cornell_box",
        "fuze",
        "spot",
    ] {
        let mut path = folder.join(name);
        if path.is_dir() {
            let files = std::fs::read_dir(&path).unwrap();
            let found = files.map(|file| file.unwrap().path()).find(|file| {
                file.extension().is_some_and(|ending| ending == "obj" || ending == "gltf")
            });
            let Some(model) = found else {
                models::skip(&format!("no model in {}", path.display()));
                continue;
            };
            path = model;
        }
        if !path.exists() {
            models::skip(&format!("no {}", path.display()));
            continue;
        }
        let mut scene = open(&path, &Limits::default()).unwrap().scene;
        let source = NormalSource::File;
        scene.compute_normals(&NormalOptions { source, ..NormalOptions::default() });
        scene.compute_tangents();
        let seen = compare(&scene, fitted(&scene, 0.5, PERSPECTIVE), SIZE, Cull::Auto);
        assert!(seen > 2000, "{name}: {seen}");
    }
}
