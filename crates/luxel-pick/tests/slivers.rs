//! Slivers against the simple truth: every triangle cut, one side after the other, by hand.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_pick::{Inclusion, PhysicalPosition, PickView, Picker, Region, SnapTo, SnappedTo};
use luxel_scene::{
    Camera, DMat4, DVec3, DVec4, Lens, MaterialId, Mesh, MeshId, Node, Part, Projection, Scene,
    SceneMaterial, Size, primitives,
};
use luxel_visibility::Cull;
use proptest::prelude::*;

const SIZE: Size = Size { width: 320, height: 200 };

/// Two bumpy spheres and a large triangle, one sphere twice, mirrored and stretched.
fn scene() -> Scene {
    let mut sphere = primitives::icosphere(1.0, 20);
    for position in &mut sphere.positions {
        let bump = 1.0 + 0.1 * libm::sin(f64::from(position[0]) * 9.0) as f32;
        *position = position.map(|value| value * bump);
    }
    let mut large = Mesh {
        positions: vec![[-40.0, -1.5, 30.0], [40.0, -1.5, 30.0], [0.0, -1.5, -60.0]],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    large.parts = vec![Part { first: 0, count: 1, material: MaterialId(0) }];
    let mut scene = Scene {
        meshes: vec![sphere, large].into(),
        materials: vec![SceneMaterial::default()],
        ..Scene::default()
    };
    let mut node = |name: &str, mesh: u32, parent_from_node: DMat4| {
        scene.nodes.push(Node::root(name, Some(MeshId(mesh))).at(None, parent_from_node));
    };
    node("a", 0, DMat4::from_translation(DVec3::new(-1.2, 0.0, 0.0)));
    node(
        "b",
        0,
        DMat4::from_translation(DVec3::new(1.4, 0.2, -1.0))
            * DMat4::from_scale(DVec3::new(-0.5, 1.3, 0.8)),
    );
    node("floor", 1, DMat4::IDENTITY);
    scene
}

fn cameras() -> [Camera; 4] {
    let view_from_world =
        Camera::look_at(DVec3::new(0.5, 0.8, 5.0), DVec3::new(0.0, 0.0, 0.0), DVec3::Y);
    let of =
        |lens, near, far| Camera { view_from_world, projection: Projection { lens, near, far } };
    [
        of(Lens::Perspective { fov_y_radians: 0.9 }, 0.5, 50.0),
        of(Lens::Perspective { fov_y_radians: 0.9 }, 4.5, f64::INFINITY),
        of(Lens::Orthographic { height: 4.0 }, 1.0, 6.0),
        of(Lens::Intrinsics { fx: 250.0, fy: 260.0, cx: 100.0, cy: 150.0 }, 0.1, 5.5),
    ]
}

/// A polygon's corners on the side of a plane where plane . corner >= 0.
fn cut(polygon: &[DVec4], plane: DVec4) -> Vec<DVec4> {
    let mut kept = Vec::new();
    for (at, &here) in polygon.iter().enumerate() {
        let next = polygon[(at + 1) % polygon.len()];
        let (a, b) = (plane.dot(here), plane.dot(next));
        if a >= 0.0 {
            kept.push(here);
        }
        if (a >= 0.0) != (b >= 0.0) {
            kept.push(here.lerp(next, a / (a - b)));
        }
    }
    kept
}

/// Least and greatest depth of each triangle of each object inside of the rectangle.
fn by_hand(
    scene: &Scene,
    camera: &Camera,
    [x, y, width, height]: [f64; 4],
) -> Vec<Vec<Option<[f64; 2]>>> {
    let (w, h) = (f64::from(SIZE.width), f64::from(SIZE.height));
    let [left, right] = [x, x + width].map(|x| 2.0 * x / w - 1.0);
    let [top, bottom] = [y, y + height].map(|y| 1.0 - 2.0 * y / h);
    let planes = [
        DVec4::new(1.0, 0.0, 0.0, -left),
        DVec4::new(-1.0, 0.0, 0.0, right),
        DVec4::new(0.0, 1.0, 0.0, -bottom),
        DVec4::new(0.0, -1.0, 0.0, top),
        DVec4::new(0.0, 0.0, 1.0, 1.0),
        DVec4::new(0.0, 0.0, -1.0, 1.0),
    ];
    let of_object = |object: luxel_scene::Object| {
        let mesh = &scene.meshes[object.mesh.index()];
        let clip_from_mesh = camera.projection.clip_from_view(SIZE)
            * camera.view_from_world
            * object.world_from_mesh.matrix();
        let of_triangle = |triangle: &[u32; 3]| {
            let corners = triangle.map(|vertex| clip_from_mesh * mesh.position(vertex).extend(1.0));
            let inside = planes.iter().fold(corners.to_vec(), |polygon, &plane| {
                if polygon.is_empty() { polygon } else { cut(&polygon, plane) }
            });
            let depths = inside.iter().map(|corner| (corner.z / corner.w + 1.0) * 0.5);
            depths.fold(None, |range: Option<[f64; 2]>, z| {
                let [low, high] = range.unwrap_or([z, z]);
                Some([low.min(z), high.max(z)])
            })
        };
        mesh.triangles.iter().map(of_triangle).collect()
    };
    scene.objects().into_iter().map(of_object).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]
    #[test]
    fn what_is_in_a_rectangle_is_what_cutting_every_triangle_leaves(
        camera in 0..4_usize,
        at in [-20.0..320.0, -20.0..200.0],
        size in prop::sample::select(vec![[5.0, 5.0], [0.01, 0.01], [60.0, 20.0], [500.0, 400.0]]),
    ) {
        let scene = scene();
        let picker = Picker::new(scene.clone()).unwrap();
        let camera = cameras()[camera];
        let view = PickView::new(&picker, camera, SIZE, Cull::Auto).unwrap();
        let rectangle = [at[0], at[1], size[0], size[1]];
        let expected = by_hand(&scene, &camera, rectangle);
        let hits = view.rectangle(at[0], at[1], size[0], size[1]).unwrap();
        let region = Region::rectangle(at[0], at[1], size[0], size[1]).unwrap();
        for (object, triangles) in expected.iter().enumerate() {
            let inside: Vec<(u32, [f64; 2])> = (0..)
                .zip(triangles)
                .filter_map(|(number, range)| range.map(|range| (number, range)))
                .collect();
            let hit = hits.iter().find(|hit| hit.object == object);
            prop_assert_eq!(hit.map_or(0, |hit| hit.triangles), inside.len() as u64);
            let told = view.triangles_in(object, &region);
            prop_assert_eq!(told.len(), inside.len());
            for (told, expected) in told.iter().zip(&inside) {
                prop_assert_eq!(told.0, expected.0);
                prop_assert!((told.1[0] - expected.1[0]).abs() < 1e-9, "{:?} {:?}", told, expected);
                prop_assert!((told.1[1] - expected.1[1]).abs() < 1e-9, "{:?} {:?}", told, expected);
            }
            if let Some(hit) = hit {
                let low = inside.iter().map(|(_, range)| range[0]).fold(f64::INFINITY, f64::min);
                let high = inside.iter().map(|(_, range)| range[1]).fold(0.0, f64::max);
                prop_assert!((hit.z_min - low).abs() < 1e-9 && (hit.z_max - high).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn a_lasso_of_a_rectangle_s_corners_equals_the_rectangle() {
    let scene = scene();
    let picker = Picker::new(scene.clone()).unwrap();
    for camera in cameras() {
        let view = PickView::new(&picker, camera, SIZE, Cull::Auto).unwrap();
        for [x, y, w, h] in [[100.0, 60.0, 30.0, 40.0], [0.0, 0.0, 320.0, 200.0]] {
            // A corner on a side cuts it into two pieces.
            let corners = [[x, y], [x + w, y], [x + w, y + h * 0.4], [x + w, y + h], [x, y + h]];
            let lasso = Region::polygon(&corners).unwrap();
            let rectangle = Region::rectangle(x, y, w, h).unwrap();
            for inclusion in [Inclusion::Touching, Inclusion::Enclosed] {
                let (a, b) = (view.sliver(&lasso, inclusion), view.sliver(&rectangle, inclusion));
                assert_eq!(a.len(), b.len(), "{inclusion:?}");
                for (a, b) in a.iter().zip(&b) {
                    assert_eq!((a.object, a.triangles), (b.object, b.triangles));
                    assert!((a.z_min - b.z_min).abs() < 1e-9 && (a.z_max - b.z_max).abs() < 1e-9);
                }
            }
            assert_eq!(view.visible_in(&lasso), view.visible_in(&rectangle));
        }
    }
}

#[test]
fn enclosed_objects_lie_inside_as_a_whole() {
    let scene = scene();
    let picker = Picker::new(scene.clone()).unwrap();
    let view = PickView::new(&picker, cameras()[0], SIZE, Cull::Auto).unwrap();
    let window = Region::rectangle(0.0, 0.0, 320.0, 200.0).unwrap();
    let objects = |region: &Region, inclusion| -> Vec<usize> {
        view.sliver(region, inclusion).iter().map(|hit| hit.object).collect()
    };
    assert_eq!(objects(&window, Inclusion::Touching), [0, 1, 2]);
    // The floor reaches behind the eye.
    assert_eq!(objects(&window, Inclusion::Enclosed), [0, 1]);
    let left = Region::rectangle(0.0, 0.0, 175.0, 200.0).unwrap();
    assert_eq!(objects(&left, Inclusion::Enclosed), [0]);
    let around =
        [[0.0, 0.0], [180.0, 0.0], [180.0, 90.0], [175.0, 100.0], [180.0, 200.0], [0.0, 200.0]];
    assert_eq!(objects(&Region::polygon(&around).unwrap(), Inclusion::Enclosed), [0]);
    let cutting = [[0.0, 0.0], [180.0, 0.0], [90.0, 100.0], [180.0, 200.0], [0.0, 200.0]];
    assert_eq!(objects(&Region::polygon(&cutting).unwrap(), Inclusion::Enclosed), []);
}

#[test]
fn pixels_of_what_is_visible_add_up_to_the_frame() {
    let scene = scene();
    let picker = Picker::new(scene.clone()).unwrap();
    let view = PickView::new(&picker, cameras()[0], SIZE, Cull::Auto).unwrap();
    let ids = view.visible_ids();
    let window = Region::rectangle(0.0, 0.0, 320.0, 200.0).unwrap();
    let seen = view.visible_in(&window);
    assert_eq!(seen, ids.in_region(&window));
    let mut count = 0;
    for y in 0..200 {
        for x in 0..320 {
            let hit = view.at(PhysicalPosition::centre_of(x, y));
            assert_eq!(hit.map(|hit| hit.object), ids.at(x, y).map(|(object, _)| object));
            count += u64::from(ids.at(x, y).is_some());
        }
    }
    assert_eq!(seen.iter().map(|hit| hit.pixels).sum::<u64>(), count);
    assert_eq!(ids.at(320, 0), None);
}

#[test]
fn a_cursor_snaps_to_the_nearest_vertex_and_edge_that_are_seen() {
    let scene = scene();
    let picker = Picker::new(scene.clone()).unwrap();
    let view = PickView::new(&picker, cameras()[0], SIZE, Cull::Auto).unwrap();
    let objects = scene.objects();
    for (x, y) in [(100.3, 90.2), (210.0, 100.0), (90.0, 120.7)] {
        let snapped = view.snap([x, y], SnapTo::Vertex, 12.0).unwrap();
        let SnappedTo::Vertex(vertex) = snapped.to else { panic!("{snapped:?}") };
        // No vertex of a triangle that is seen nearby is nearer.
        let mut least = f64::INFINITY;
        for dy in -12..=12 {
            for dx in -12..=12 {
                let (px, py) = (x + f64::from(dx), y + f64::from(dy));
                let Some(hit) = view.at([px, py]) else { continue };
                let luxel_pick::Element::Triangle(triangle) = hit.element else { continue };
                let object = &objects[hit.object];
                let mesh = &scene.meshes[object.mesh.index()];
                for corner in mesh.triangles[triangle as usize] {
                    let place =
                        object.world_from_mesh.matrix().transform_point3(mesh.position(corner));
                    let Some([wx, wy]) = view.window_of(place) else { continue };
                    least = least.min(((wx - x) * (wx - x) + (wy - y) * (wy - y)).sqrt());
                }
            }
        }
        assert!(vertex.pixels <= least + 1e-9, "{} {least}", vertex.pixels);
        let SnappedTo::Edge(edge) = view.snap([x, y], SnapTo::Edge, 12.0).unwrap().to else {
            panic!("an edge");
        };
        assert!(edge.pixels <= vertex.pixels + 1e-9);
        let back = view.window_of(edge.position).unwrap();
        assert!((back[0] - edge.window[0]).abs() < 1e-6 && (back[1] - edge.window[1]).abs() < 1e-6);
    }
    assert_eq!(view.snap([2.0, 2.0], SnapTo::Vertex, 5.0), None);
    let SnappedTo::Face { pixels, .. } = view.snap([100.3, 90.2], SnapTo::Face, 5.0).unwrap().to
    else {
        panic!("a face");
    };
    assert_eq!(pixels, 0.0);
}
