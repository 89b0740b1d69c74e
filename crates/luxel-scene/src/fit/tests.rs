use super::*;
use crate::{Lines, MaterialId, Mesh, MeshId, Node, primitives};
use glam::DVec4;
use proptest::prelude::*;

const SIZE: Size = Size { width: 1280, height: 720 };
const LENS: Lens = Lens::Perspective { fov_y_radians: std::f64::consts::FRAC_PI_4 };

fn scene_of(mesh: Mesh, world_from_mesh: DMat4) -> Scene {
    let node = Node::root("it", Some(MeshId(0))).at(None, world_from_mesh);
    Scene { nodes: vec![node], meshes: vec![mesh].into(), ..Scene::default() }
}

fn viewpoint(azimuth: f64, elevation: f64) -> Viewpoint {
    Viewpoint {
        up: DVec3::Y,
        azimuth_radians: azimuth.to_radians(),
        elevation_radians: elevation.to_radians(),
    }
}

/// The window of -1..1 that the points of a scene fill: left, bottom, right, top.
fn filled(scene: &Scene, camera: &Camera, size: Size) -> [f64; 4] {
    let clip_from_world = camera.projection.clip_from_view(size) * camera.view_from_world;
    let mut window = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    for object in scene.objects() {
        let mesh = &scene.meshes[object.mesh.index()];
        for &index in mesh.triangles.as_flattened() {
            let world = object.world_from_mesh.matrix().transform_point3(mesh.position(index));
            let clip: DVec4 = clip_from_world * world.extend(1.0);
            assert!(clip.w > 0.0 && clip.z.abs() <= clip.w, "clipped: {clip}");
            let [x, y] = [clip.x / clip.w, clip.y / clip.w];
            window = [window[0].min(x), window[1].min(y), window[2].max(x), window[3].max(y)];
        }
    }
    window
}

fn assert_fitted(scene: &Scene, camera: &Camera, size: Size) {
    let [left, bottom, right, top] = filled(scene, camera, size);
    assert!((left + right).abs() < 1e-6 && (bottom + top).abs() < 1e-6, "not in the middle");
    let most = (right - left).max(top - bottom);
    assert!((most - 2.0 * FILLED).abs() < 1e-6, "{most}");
}

#[test]
fn the_frame_turns_with_the_axis_that_is_up() {
    let frame = |up: DVec3| Viewpoint { up, azimuth_radians: 0.0, elevation_radians: 0.0 }.axes();
    for (up, right, front) in [
        (DVec3::Y, DVec3::X, DVec3::Z),
        (DVec3::Z, DVec3::X, DVec3::NEG_Y),
        (DVec3::X, DVec3::NEG_Y, DVec3::Z),
        (DVec3::NEG_Y, DVec3::NEG_X, DVec3::Z),
        (DVec3::Z * 7.0, DVec3::X, DVec3::NEG_Y),
    ] {
        let [found_right, found_up, back] = frame(up);
        assert!(found_right.abs_diff_eq(right, 1e-12), "{up}: {found_right}");
        assert!(found_up.abs_diff_eq(up.normalize(), 1e-12), "{up}: {found_up}");
        assert!(back.abs_diff_eq(front, 1e-12), "{up}: {back}");
    }
    let [_, _, back] = viewpoint(90.0, 0.0).axes();
    assert!(back.abs_diff_eq(DVec3::X, 1e-12), "azimuth goes to the right: {back}");
    let [right, up, back] = viewpoint(0.0, 90.0).axes();
    assert!(right.abs_diff_eq(DVec3::X, 1e-12) && up.abs_diff_eq(DVec3::NEG_Z, 1e-12));
    assert!(back.abs_diff_eq(DVec3::Y, 1e-12), "elevation goes up: {back}");
}

#[test]
fn the_distance_to_a_sphere_follows_from_its_tangent_cone() {
    let scene =
        scene_of(primitives::icosphere(2.0, 48), DMat4::from_translation(DVec3::splat(5.0)));
    let camera = fit_view(&scene, &viewpoint(30.0, 20.0), LENS, SIZE);
    let half_angle = libm::atan(FILLED * libm::tan(std::f64::consts::FRAC_PI_8));
    let distance = camera.eye().distance(DVec3::splat(5.0));
    assert!((distance - 2.0 / libm::sin(half_angle)).abs() < 0.01, "{distance}");
    assert_fitted(&scene, &camera, SIZE);
}

#[test]
fn the_front_of_a_cube_fills_the_window() {
    let scene = scene_of(primitives::cuboid(DVec3::splat(2.0)), DMat4::IDENTITY);
    let camera = fit_view(&scene, &viewpoint(0.0, 0.0), LENS, SIZE);
    let expected = 1.0 + 1.0 / (FILLED * libm::tan(std::f64::consts::FRAC_PI_8));
    assert!(camera.eye().abs_diff_eq(DVec3::new(0.0, 0.0, expected), 1e-9));
    let camera = fit_view(&scene, &viewpoint(0.0, 0.0), Lens::Orthographic { height: 0.0 }, SIZE);
    assert_eq!(camera.projection.lens, Lens::Orthographic { height: 2.5 });
    assert_fitted(&scene, &camera, SIZE);
}

#[test]
fn a_given_height_is_kept_and_the_middle_is_the_silhouettes() {
    let mesh = primitives::cone(1.0, 3.0, 16, 2);
    let scene = scene_of(mesh, DMat4::from_translation(DVec3::new(9.0, 0.0, 0.0)));
    let lens = Lens::Orthographic { height: 20.0 };
    let camera = fit_view(&scene, &viewpoint(30.0, 60.0), lens, SIZE);
    assert_eq!(camera.projection.lens, lens);
    let [left, bottom, right, top] = filled(&scene, &camera, SIZE);
    assert!((left + right).abs() < 1e-9 && (bottom + top).abs() < 1e-9);
}

#[test]
fn off_centre_cameras_are_fitted_to_the_window_and_not_to_the_axis() {
    let scene = scene_of(primitives::torus(1.0, 0.3, 32, 16), DMat4::IDENTITY);
    let lens = Lens::Intrinsics { fx: 900.0, fy: 950.0, cx: 500.0, cy: 420.0 };
    let camera = fit_view(&scene, &viewpoint(30.0, 20.0), lens, SIZE);
    assert_fitted(&scene, &camera, SIZE);
}

#[test]
fn what_has_no_extent_or_is_not_there_still_gives_a_camera() {
    let point = |position: [f32; 3]| Mesh {
        positions: vec![position],
        triangles: vec![[0, 0, 0]],
        ..Mesh::default()
    };
    let line = Mesh {
        positions: vec![[0.0; 3], [0.0, 0.0, 5.0], [1e30; 3]],
        lines: vec![Lines { segments: vec![[0, 1]], material: MaterialId(0) }],
        ..Mesh::default()
    };
    let identity = DMat4::IDENTITY;
    let scenes = [
        Scene::default(),
        scene_of(Mesh::default(), identity),
        scene_of(point([0.0; 3]), identity),
        scene_of(point([1e20, -3e30, 7.0]), identity),
        scene_of(point([1e-40, 0.0, 0.0]), identity),
        scene_of(line, identity),
        scene_of(primitives::plane(glam::DVec2::ONE, 1, 1), identity),
        scene_of(primitives::cuboid(DVec3::ONE), DMat4::from_scale(DVec3::splat(f64::MAX))),
        scene_of(primitives::cuboid(DVec3::ONE), DMat4::from_scale(DVec3::ZERO)),
    ];
    for scene in scenes {
        for lens in [LENS, Lens::Orthographic { height: 0.0 }] {
            for elevation in [0.0, 90.0] {
                let camera = fit_view(&scene, &viewpoint(0.0, elevation), lens, SIZE);
                let Projection { near, far, .. } = camera.projection;
                assert!(camera.view_from_world.is_finite());
                assert!(near > 0.0 && near < far && far.is_finite(), "{near} {far}");
                assert!(near >= far / MOST_FAR_BY_NEAR);
            }
        }
    }
}

#[test]
fn planes_of_a_camera_inside_of_the_scene_begin_in_front_of_it() {
    let bounds = Bounds { min: DVec3::splat(-10.0), max: DVec3::splat(10.0) };
    let (near, far) = fit_planes(&bounds, &DMat4::IDENTITY);
    assert!(far > 10.0 && far < 10.1);
    assert_eq!(near, far / MOST_FAR_BY_NEAR);
    let behind = DMat4::from_translation(DVec3::new(0.0, 0.0, 50.0));
    let (near, far) = fit_planes(&bounds, &behind);
    assert!(0.0 < near && near < far);
}

proptest! {
    #[test]
    fn any_points_are_fitted_from_any_side(
        places in prop::collection::vec(prop::array::uniform3(-10.0_f32..10.0), 3..30),
        azimuth in -180.0_f64..180.0,
        elevation in -90.0_f64..90.0,
        up in prop::sample::select(&[DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_Z][..]),
        fov in 10.0_f64..120.0,
        width in 100_u32..1000,
        height in 100_u32..1000,
    ) {
        let triangles = (2..places.len() as u32).map(|at| [0, at - 1, at]).collect();
        let scene = scene_of(
            Mesh { positions: places, triangles, ..Mesh::default() },
            DMat4::from_translation(DVec3::new(1e5, 2.0, -3e4)),
        );
        let size = Size { width, height };
        let viewpoint = Viewpoint { up, ..viewpoint(azimuth, elevation) };
        let lens = Lens::Perspective { fov_y_radians: fov.to_radians() };
        let camera = fit_view(&scene, &viewpoint, lens, size);
        let [left, bottom, right, top] = filled(&scene, &camera, size);
        prop_assert!((left + right).abs() < 1e-4 && (bottom + top).abs() < 1e-4);
        let most = (right - left).max(top - bottom);
        prop_assert!(most < 2.0 * FILLED + 1e-4);
    }
}
