//! Picks of many places at once, against picks of each alone.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_math::SimdLevel;
use luxel_pick::{Element, PickView, Picker, Quality};
use luxel_scene::{
    AlphaMode, Camera, DMat4, DVec3, Encoding, Filter, Image, Lens, Lines, MaterialId, Mesh,
    MeshId, Node, Part, Points, Projection, Sampler, Scene, SceneMaterial, Sides, Size, Texture,
    TextureId, TextureUse, primitives,
};
use luxel_visibility::Cull;
use proptest::prelude::*;
use std::sync::{Arc, LazyLock};

const SIZE: Size = Size { width: 320, height: 200 };

fn bumpy_sphere(frequency: u32) -> Mesh {
    let mut mesh = primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let bump = 1.0 + 0.1 * libm::sin(f64::from(position[0]) * 9.0) as f32;
        *position = position.map(|value| value * bump);
    }
    let count = mesh.triangles.len() as u32;
    // Half of it opaque, half of it with holes.
    mesh.parts = vec![
        Part { first: 0, count: count / 2, material: MaterialId(0) },
        Part { first: count / 2, count: count - count / 2, material: MaterialId(1) },
    ];
    // As many as there are attribute vertices.
    mesh.uvs[0] = mesh.normals.iter().map(|[x, y, z]| [x * 2.0 + z, y * 2.0]).collect();
    mesh.colors = mesh.normals.iter().map(|&[x, y, z]| [x.abs(), y.abs(), z.abs(), 1.0]).collect();
    mesh
}

/// Spheres, mirrored, stretched, flattened and twice in one place, points and lines, and a floor
/// that reaches behind the eye.
fn scene(origin: DVec3, frequency: u32) -> Scene {
    let mut sphere = bumpy_sphere(frequency);
    sphere.origin = origin;
    let mut floor = Mesh {
        origin,
        positions: vec![[-40.0, -1.5, 30.0], [40.0, -1.5, 30.0], [0.0, -1.5, -60.0]],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    floor.parts = vec![Part { first: 0, count: 1, material: MaterialId(2) }];
    let mut strokes = Mesh { origin, ..Mesh::default() };
    strokes.positions =
        (0..60_u8).map(|at| [f32::from(at % 8) - 4.0, f32::from(at / 8) - 3.0, 1.2]).collect();
    strokes.points = vec![Points { indices: (0..30).collect(), material: MaterialId(0) }];
    let segments = (30..59).map(|at| [at, at + 1]).collect();
    strokes.lines = vec![Lines { segments, material: MaterialId(2) }];
    let holes = SceneMaterial {
        alpha_mode: AlphaMode::Mask { cutoff: 0.5 },
        base_color: Some(TextureUse::new(TextureId(0)).into()),
        ..SceneMaterial::default()
    };
    let front = SceneMaterial { sides: Sides::Front, ..SceneMaterial::default() };
    let texels = vec![[255; 4], [255, 255, 255, 0], [255; 4], [255; 4]];
    let image = Arc::new(Image::new("holes", Encoding::Srgb, 2, 2, texels));
    let sampler = Sampler { magnify: Filter::Nearest, ..Sampler::default() };
    let mut scene = Scene {
        meshes: vec![sphere, floor, strokes].into(),
        materials: vec![SceneMaterial::default(), holes, front],
        textures: vec![Texture { image, sampler }],
        ..Scene::default()
    };
    let about = |of: DMat4| DMat4::from_translation(origin) * of * DMat4::from_translation(-origin);
    let mut node = |mesh: u32, place: [f64; 3], scale: [f64; 3]| {
        let of = DMat4::from_translation(DVec3::from_array(place))
            * DMat4::from_rotation_x(place[0])
            * DMat4::from_scale(DVec3::from_array(scale));
        let name = scene.nodes.len().to_string();
        let parent_from_node = about(of);
        scene.nodes.push(Node::root(name, Some(MeshId(mesh))).at(None, parent_from_node));
    };
    node(0, [-1.2, 0.0, 0.0], [1.0; 3]);
    node(0, [-1.2, 0.0, 0.0], [1.0; 3]);
    node(0, [1.4, 0.2, -1.0], [-0.5, 1.3, 0.8]);
    node(0, [0.3, 1.1, -0.5], [1.0, 1e-6, 1.0]);
    node(0, [0.0, -0.5, 1.5], [0.2, 0.2, 0.2]);
    node(1, [0.0; 3], [1.0; 3]);
    node(2, [0.0; 3], [1.0; 3]);
    scene
}

/// The same scene about the world's origin and far from it, for several instruction sets.
static PICKERS: LazyLock<Vec<(DVec3, Picker)>> = LazyLock::new(|| {
    let far = DVec3::new(4e6, -3e6, 1e6);
    let mut pickers = Vec::new();
    for (origin, frequency, quality) in [
        (DVec3::ZERO, 20, Quality::Thorough),
        (far, 20, Quality::Thorough),
        (DVec3::ZERO, 3, Quality::Fast),
        (DVec3::ZERO, 60, Quality::InOrder),
    ] {
        let picker = Picker::with(scene(origin, frequency), quality, SimdLevel::Auto).unwrap();
        pickers.push((origin, picker));
    }
    pickers
});

fn camera(origin: DVec3, eye: [f64; 3], lens: usize) -> Camera {
    let (lens, near, far) = [
        (Lens::Perspective { fov_y_radians: 0.9 }, 0.5, 50.0),
        (Lens::Perspective { fov_y_radians: 2.2 }, 0.01, f64::INFINITY),
        (Lens::Orthographic { height: 4.0 }, 1.0, 9.0),
        (Lens::Intrinsics { fx: 250.0, fy: 260.0, cx: 100.0, cy: 150.0 }, 0.1, 5.5),
    ][lens];
    let eye = origin + DVec3::from_array(eye);
    let up = DVec3::new(0.1, 1.0, 0.2);
    let view_from_world = Camera::look_at(eye, origin + DVec3::new(0.1, 0.0, 0.2), up);
    Camera { view_from_world, projection: Projection { lens, near, far } }
}

/// Places in the window and around it, some crowded, some twice, some without a number.
fn places() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let scattered = prop::collection::vec([-20.0..340.0, -20.0..220.0], 0..150);
    let crowded =
        ([0.0..320.0, 0.0..200.0], 0.01..20.0, 0..150_usize).prop_map(|(at, step, count)| {
            let places = (0..count).map(|number| {
                [at[0] + step * (number % 12) as f64, at[1] + step * (number / 12) as f64]
            });
            places.collect::<Vec<[f64; 2]>>()
        });
    (scattered, crowded, any::<u64>()).prop_map(|(mut places, crowded, order)| {
        places.extend(crowded);
        if let Some(&first) = places.first() {
            places.extend([[f64::NAN, 3.0], [5.0, f64::INFINITY], first, first]);
        }
        // Mixed, so that neighbours don't follow each other.
        let count = places.len().max(1);
        places.rotate_left(order as usize % count);
        let stride =
            (0..count).map(|at| places.get(at * 7919 % count).copied().unwrap_or_default());
        stride.collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]
    #[test]
    fn answers_are_those_of_each_place_alone(
        scene in 0..4_usize,
        eye in [-3.0..3.0, -1.4..3.0, 0.3..6.0],
        lens in 0..4_usize,
        cull in prop::sample::select(vec![Cull::Auto, Cull::None]),
        places in places(),
    ) {
        let (origin, picker) = &PICKERS[scene];
        let view = PickView::new(picker, camera(*origin, eye, lens), SIZE, cull).unwrap();
        let many = view.at_many(&places);
        let owners = view.owner_at_many(&places);
        prop_assert_eq!(many.len(), places.len());
        for ((&place, many), owner) in places.iter().zip(many).zip(owners) {
            // Debug output tells values with different bits apart, but for NaN.
            prop_assert_eq!(format!("{:?}", view.at(place)), format!("{many:?}"), "{:?}", place);
            prop_assert_eq!(view.owner_at(place), owner, "{:?}", place);
        }
    }
}

#[test]
fn all_kinds_of_surfaces_are_found_whatever_the_threads() {
    let (origin, picker) = &PICKERS[0];
    let view =
        PickView::new(picker, camera(*origin, [0.5, 0.8, 5.0], 0), SIZE, Cull::Auto).unwrap();
    let along = |at: u64, stride: u64, end: u64| (at * stride % (end * 256)) as f64 / 256.0;
    let places: Vec<[f64; 2]> =
        (0..70_000).map(|at| [along(at, 7919, 320), along(at, 104_729, 200)]).collect();
    let many = view.at_many(&places);
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert!(many == pool.install(|| view.at_many(&places)));
    }
    let count = |is: &dyn Fn(usize, Element) -> bool| {
        many.iter().flatten().filter(|hit| is(hit.object, hit.element)).count()
    };
    for object in [0, 2, 3, 4, 5] {
        assert!(count(&|of, _| of == object) > 100, "object {object}");
    }
    // The second sphere lies where the first one is, which comes first.
    assert_eq!(count(&|object, _| object == 1), 0);
    assert!(count(&|_, element| matches!(element, Element::Point(_))) > 10);
    assert!(count(&|_, element| matches!(element, Element::Line(_))) > 100);
    assert!(many.iter().any(Option::is_none));
}

#[test]
fn no_place_and_one_place() {
    let (origin, picker) = &PICKERS[0];
    let view =
        PickView::new(picker, camera(*origin, [0.5, 0.8, 5.0], 0), SIZE, Cull::Auto).unwrap();
    assert!(view.at_many::<[f64; 2]>(&[]).is_empty());
    let place = [160.5, 100.5];
    assert_eq!(view.at_many(&[place]), [view.at(place)]);
    assert!(view.at(place).is_some());
    assert_eq!(view.at_many(&[[f64::NAN; 2]]), [None]);
}

#[test]
fn a_scene_without_objects_answers_nothing() {
    let picker = Picker::new(Scene::default()).unwrap();
    let view =
        PickView::new(&picker, camera(DVec3::ZERO, [0.5, 0.8, 5.0], 0), SIZE, Cull::Auto).unwrap();
    assert_eq!(view.at_many(&[[3.0, 4.0]; 9]), vec![None; 9]);
}
