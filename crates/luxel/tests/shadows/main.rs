//! Shadows against rays through all triangles, in `f64`: at every pixel, in scenes of all kinds.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod explained;
mod ground;
mod oracle;

use luxel::formats::{Limits, open};
use luxel::lighting::LightKind;
use luxel::render::{Execution, ExplainedSurface, Renderer, View};
use luxel::scene::{
    AlphaMode, Camera, DMat4, DVec3, Lens, MaterialId, Mesh, MeshId, Node, NormalOptions, Part,
    Projection, Scene, SceneLight, SceneMaterial, Size, Viewpoint, demos, fit_view, primitives,
};
use luxel::view::{AmbientOcclusion, ShadingMode};
use luxel_testing::models;
use oracle::{reference, triangles};
use std::path::Path;

pub(crate) const SIZE: Size = Size { width: 48, height: 36 };

/// Compares V of every light at every pixel of a scene without holes and glass; how many were in shadow.
fn compare(name: &str, scene: &Scene, view: &View) -> (usize, usize) {
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    let all = triangles(scene);
    let extent = scene.bounds().radius();
    let margin = 1e-5 * extent;
    let pixels: Vec<_> =
        (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| [x, y])).collect();
    let (mut shadowed, mut lit, mut uncertain, mut raised) = (0, 0, 0, 0);
    for explained in renderer.explain_pixels(view, &pixels).unwrap() {
        let Some(surface) = explained.samples[0].seen[0].surface() else { continue };
        let eye = (view.camera.eye() - DVec3::from_array(surface.position)).length();
        for light in &surface.lights {
            let shadow = light.shadow.as_ref().unwrap();
            let visibility = light.terms.visibility.unwrap();
            let Some([origin, direction]) = shadow.ray.map(|ray| ray.map(DVec3::from_array)) else {
                let is_dark = visibility == 0.0 && shadow.terminator == 0.0;
                let is_unlit = light.terms.n_dot_l <= 0.0 && visibility == 1.0;
                assert!(is_dark || is_unlit, "{name}: it isn't asked");
                continue;
            };
            // 2^-17 of the largest coordinate, and the rounding of the place that the ledger shows, which is
            // about the eye in f32; where the terminator's cure acts, no more than the triangle's extent.
            let place = DVec3::from_array(surface.position);
            let bound = 8e-6 * 2.0 * extent + 1e-6 * eye + shadow.raised;
            assert!((origin - place).length() <= bound, "{name}: {origin} is far from {place}");
            if shadow.raised > 0.0 {
                let own = all.iter().find(|facet| facet.is(surface.object, surface.triangle));
                let [a, b, c] = own.unwrap().corners;
                let longest = (b - a).length().max((c - a).length()).max((c - b).length());
                assert!(shadow.raised <= longest, "{name}: {} above its triangle", shadow.raised);
                let facing = (b - a).cross(c - a).normalize();
                let facing =
                    facing * facing.dot(DVec3::from_array(surface.view.map(f64::from))).signum();
                let normal = DVec3::from_array(surface.normal.map(f64::from));
                assert!(
                    2.0 * facing.dot(direction) <= normal.dot(direction) + 1e-3,
                    "{name}: the terminator is elsewhere"
                );
                raised += 1;
            }
            let end = match light.light.kind {
                LightKind::Directional => f64::INFINITY,
                _ => (DVec3::from_array(light.position) - origin).length(),
            };
            let (mut clear, mut near) = (false, false);
            for facet in &all {
                let Some((t, inside)) = facet.meeting(origin, direction) else { continue };
                let own = facet.is(surface.object, surface.triangle);
                clear |= !own && t > margin && t < end - margin && inside > margin;
                near |= !own && t > -margin && t < end + margin && inside > -margin;
            }
            if clear {
                assert_eq!(visibility, 0.0, "{name}: light leaks to {:?}", explained.pixel);
                assert!(!shadow.blocked_by.is_empty(), "{name}: nothing is named");
                shadowed += 1;
            } else if near {
                uncertain += 1;
            } else {
                let expected = shadow.terminator;
                assert_eq!(visibility, expected, "{name}: acne at {:?}", explained.pixel);
                lit += 1;
            }
        }
    }
    assert!(uncertain * 20 <= shadowed + lit, "{name}: {uncertain} of {shadowed} + {lit}");
    assert!(raised * 5 <= shadowed + lit, "{name}: {raised} origins are moved");
    (shadowed, lit)
}

/// A sun and a lamp.
fn lights(scene: &Scene) -> Vec<SceneLight> {
    let bounds = scene.bounds();
    let (right, up) =
        (bounds.radius() * scene.up.any_orthonormal_vector(), bounds.radius() * scene.up);
    let lamp = bounds.centre() + 0.9 * up + 1.3 * right;
    vec![
        SceneLight::directional(0.4 * right - 0.8 * up, [0.8; 3]).named("sun"),
        SceneLight::point(lamp, [0.6; 3]).named("lamp"),
    ]
}

pub(crate) fn view(scene: &Scene, azimuth: f64) -> View {
    let viewpoint = Viewpoint { up: scene.up, azimuth_radians: azimuth, elevation_radians: 0.35 };
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    View::new(SIZE, fit_view(scene, &viewpoint, lens, SIZE))
        .with_samples(1)
        .with_lights(lights(scene))
        .with_shadows(true)
}

/// Nothing shines through a scene's surfaces.
pub(crate) fn solid(mut scene: Scene) -> Scene {
    for material in &mut scene.materials {
        material.alpha_mode = AlphaMode::Opaque;
    }
    scene
}

#[test]
fn demos_are_in_shadow_where_f64_rays_meet_a_triangle() {
    let (mut shadowed, mut lit) = (0, 0);
    for name in ["teapot", "spheres", "cornell", "plane", "welcome", "lab-corrugated"] {
        let scene = demos::demo(name).unwrap();
        let found = compare(name, &scene, &view(&scene, 0.6));
        shadowed += found.0;
        lit += found.1;
    }
    assert!(shadowed > 100 && lit > 2500, "{shadowed} {lit}");
}

/// Public models.
const MODELS: [&str; 10] = [
    "CesiumMilkTruck.glb",
    "DepthOfFieldExample.glb",
    "Fox.glb",
    "busted.STL",
    "featuretype.STL",
    "octagonal_pocket.stl",
    "suzanne.ply",
    "cakeBirthday.glb",
    "spot/spot.obj",
    "fuze/fuze.obj",
];

fn model(folder: &Path, path: &str) -> Scene {
    let mut scene = solid(open(&folder.join(path), &Limits::default()).unwrap().scene);
    scene.compute_normals(&NormalOptions::default());
    scene
}

#[test]
fn models_are_in_shadow_where_f64_rays_meet_a_triangle() {
    let Some(folder) = models::folder() else { return };
    let (mut shadowed, mut lit) = (0, 0);
    for path in MODELS {
        let scene = model(&folder, path);
        let found = compare(path, &scene, &view(&scene, 0.6));
        shadowed += found.0;
        lit += found.1;
    }
    assert!(shadowed > 350 && lit > 4000, "{shadowed} {lit}");
}

/// A mesh, scaled in its file or by its node, and far away.
pub(crate) fn closed(mut mesh: Mesh, scale: f64, offset: DVec3, in_file: bool) -> Scene {
    mesh.parts =
        vec![Part { first: 0, count: mesh.triangles.len() as u32, material: MaterialId(0) }];
    let mut node = Node::root("closed".to_owned(), Some(MeshId(0)));
    if in_file {
        mesh.origin = offset;
        for place in mesh.positions.as_flattened_mut() {
            *place *= scale as f32;
        }
    } else {
        node.parent_from_node =
            (DMat4::from_translation(offset) * DMat4::from_scale(DVec3::splat(scale))).into();
    }
    let mut scene = Scene::default();
    scene.meshes.push(mesh);
    scene.materials.push(SceneMaterial::default());
    scene.nodes.push(node);
    scene
}

/// Scales and offsets, by the file and by the node.
fn placements() -> Vec<(f64, DVec3, bool)> {
    let offset = DVec3::new(1e6, -1e6, 1e6);
    let mut all = Vec::new();
    for in_file in [true, false] {
        for scale in [1e-6, 1.0, 1e6] {
            all.push((scale, DVec3::ZERO, in_file));
        }
        all.extend([(1.0, offset, in_file), (1e6, offset, in_file)]);
    }
    all
}

/// Convex, closed: nothing on it is in the way of its own light.
fn convex() -> [Mesh; 4] {
    [
        primitives::sphere(1.0, 48, 24),
        primitives::icosphere(1.0, 3),
        primitives::cuboid(DVec3::new(1.0, 2.0, 0.01)),
        primitives::cylinder(0.02, 3.0, 60),
    ]
}

#[test]
fn a_convex_surface_has_no_acne_at_any_scale_and_offset() {
    let mut asked = 0;
    for (scale, offset, in_file) in placements() {
        for mesh in convex() {
            let scene = closed(mesh, scale, offset, in_file);
            for azimuth in [0.6, 2.5] {
                let view = view(&scene, azimuth);
                let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
                for explained in renderer.explain_pixels(&view, &all_pixels()).unwrap() {
                    let Some(surface) = explained.samples[0].seen[0].surface() else { continue };
                    for light in surface.lights.iter().filter(|light| light.terms.n_dot_l > 0.0) {
                        let terminator = light.shadow.as_ref().unwrap().terminator;
                        let visibility = light.terms.visibility.unwrap();
                        assert_eq!(visibility, terminator, "{scale} {offset} {explained:?}");
                        asked += 1;
                    }
                }
            }
        }
    }
    assert!(asked > 10_000, "{asked}");
}

/// A ball as coarse as can be, with the normals of the true one, under a sun: light ends where its normals
/// turn away, not where its triangles do.
#[test]
fn light_on_a_coarse_ball_ends_where_normals_turn_away() {
    for mesh in [primitives::sphere(1.0, 8, 4), primitives::icosphere(1.0, 1)] {
        let scene = closed(mesh, 1.0, DVec3::ZERO, false);
        for (azimuth, mode) in
            [(0.6, ShadingMode::Phong), (2.5, ShadingMode::Phong), (0.6, ShadingMode::Gouraud)]
        {
            let mut view = view(&scene, azimuth);
            view.lights.truncate(1);
            view.shading.mode = mode;
            let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
            let with = renderer.linear(&view).unwrap().pixels;
            let without = renderer.linear(&view.with_shadows(false)).unwrap().pixels;
            let dark = with.iter().zip(&without).filter(|(with, without)| with != without).count();
            assert_eq!(dark, 0, "{mode:?}: pixels in the ball's own shadow");
        }
    }
}

#[test]
fn no_light_leaks_into_a_closed_surface_at_any_scale_and_offset() {
    let mut asked = 0;
    for (scale, offset, in_file) in placements() {
        for mesh in [
            primitives::sphere(1.0, 48, 24),
            primitives::cuboid(DVec3::new(1.0, 2.0, 3.0)),
            primitives::cuboid(DVec3::new(4.0, 0.3, 4.0)),
        ] {
            let scene = closed(mesh, scale, offset, in_file);
            let bounds = scene.bounds();
            let (eye, radius) = (bounds.centre(), bounds.radius());
            for (direction, up) in [(DVec3::X, DVec3::Y), (DVec3::new(0.5, -0.7, 0.6), DVec3::Y)] {
                let lens = Lens::Perspective { fov_y_radians: 1.6 };
                let projection = Projection { lens, near: radius * 1e-3, far: radius * 10.0 };
                let view_from_world = Camera::look_at(eye, eye + direction * radius, up);
                let view = View::new(SIZE, Camera { view_from_world, projection })
                    .with_samples(1)
                    .with_lights(
                        [DVec3::new(1.0, 0.2, 0.3), DVec3::new(-0.3, -1.0, 0.5)]
                            .map(|way| SceneLight::directional(way, [1.0; 3]))
                            .into_iter()
                            .chain([SceneLight::point(eye + 3.0 * radius * DVec3::ONE, [1.0; 3])])
                            .collect(),
                    )
                    .with_shadows(true);
                let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
                for explained in renderer.explain_pixels(&view, &all_pixels()).unwrap() {
                    let Some(surface) = explained.samples[0].seen[0].surface() else { continue };
                    for light in surface.lights.iter().filter(|light| light.terms.n_dot_l > 0.0) {
                        let visibility = light.terms.visibility.unwrap();
                        assert_eq!(visibility, 0.0, "{scale} {offset} {explained:?}");
                        asked += 1;
                    }
                }
            }
        }
    }
    assert!(asked > 10_000, "{asked}");
}

/// All pixels of a picture.
pub(crate) fn all_pixels() -> Vec<[u32; 2]> {
    (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| [x, y])).collect()
}

/// The surfaces of all pixels of a view, with their openness.
fn openness(
    scene: &Scene,
    view: &View,
    occlusion: AmbientOcclusion,
) -> Vec<(ExplainedSurface, f32)> {
    let view = view.clone().with_shadows(false).with_ambient_occlusion(Some(occlusion));
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    let explained = renderer.explain_pixels(&view, &all_pixels()).unwrap();
    let of = |explained: luxel::render::Explanation| {
        let surface = explained.samples[0].seen[0].surface()?.clone();
        let openness = surface.openness.unwrap();
        Some((surface, openness))
    };
    explained.into_iter().filter_map(of).collect()
}

#[test]
fn a_convex_surface_is_open_outside_and_closed_inside() {
    let whole = AmbientOcclusion { radius: Some(f64::INFINITY), rays: 4 };
    for (scale, offset, in_file) in placements() {
        for mesh in [primitives::sphere(1.0, 48, 24), primitives::cuboid(DVec3::new(1.0, 2.0, 3.0))]
        {
            let scene = closed(mesh, scale, offset, in_file);
            let outside = openness(&scene, &view(&scene, 0.6), whole);
            assert!(outside.len() > 150);
            assert!(outside.iter().all(|(.., open)| *open == 1.0), "{scale} {offset}");
            let (eye, radius) = (scene.bounds().centre(), scene.bounds().radius());
            let lens = Lens::Perspective { fov_y_radians: 1.6 };
            let projection = Projection { lens, near: radius * 1e-3, far: radius * 10.0 };
            let view_from_world = Camera::look_at(eye, eye + DVec3::X * radius, DVec3::Y);
            let within = View::new(SIZE, Camera { view_from_world, projection }).with_samples(1);
            let inside = openness(&scene, &within, whole);
            assert_eq!(inside.len(), all_pixels().len());
            assert!(inside.iter().all(|(.., open)| *open == 0.0), "{scale} {offset}");
        }
    }
}

#[test]
fn openness_is_that_of_f64_rays_within_the_error_of_sampling() {
    for name in ["teapot", "plane"] {
        check_openness(name, &demos::demo(name).unwrap(), 24);
    }
}

#[test]
fn openness_of_models_is_that_of_f64_rays_within_the_error_of_sampling() {
    let Some(folder) = models::folder() else { return };
    for path in MODELS {
        check_openness(path, &model(&folder, path), 12);
    }
}

/// Compares the openness of some places of a scene with rays to all triangles.
fn check_openness(name: &str, scene: &Scene, places: usize) {
    // The root of the mean square error by the number of rays, as the docs state it.
    let bounds = [(16, 0.06), (64, 0.03), (256, 0.02)];
    let view = view(scene, 0.6);
    let all = triangles(scene);
    let margin = 1e-5 * scene.bounds().radius();
    let whole = |rays| AmbientOcclusion { radius: Some(f64::INFINITY), rays };
    let seen = openness(scene, &view, whole(1));
    let step = seen.len() / places;
    let expected: Vec<f64> = seen
        .iter()
        .step_by(step)
        .map(|(surface, _)| {
            let own = all.iter().find(|facet| facet.is(surface.object, surface.triangle));
            let [a, b, c] = own.unwrap().corners;
            let [normal, eye] =
                [surface.normal, surface.view].map(|way| DVec3::from_array(way.map(f64::from)));
            let facing = (b - a).cross(c - a).normalize();
            let facing = facing * facing.dot(eye).signum();
            reference(&all, DVec3::from_array(surface.position), [normal, facing], margin)
        })
        .collect();
    for (rays, bound) in bounds {
        let found = openness(scene, &view, whole(rays));
        let squares = found.iter().step_by(step).zip(&expected).map(|((.., open), expected)| {
            let off = f64::from(*open) - expected;
            off * off
        });
        let error = (squares.sum::<f64>() / expected.len() as f64).sqrt();
        assert!(error < bound, "{name}, {rays} rays: {error}");
    }
}

#[test]
fn a_soft_shadow_is_between_the_hard_ones_and_grows_with_the_light() {
    // A ball over a floor: how many samples are partly lit.
    let scene = demos::demo("plane").unwrap();
    let mut last = 0;
    for radius in [0.0, 0.2, 0.8] {
        let mut view = view(&scene, 0.6);
        view.lights.remove(0);
        view.lights[0].light.radius = radius * scene.bounds().radius() as f32;
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let mut partly = 0;
        for explained in renderer.explain_pixels(&view, &all_pixels()).unwrap() {
            let Some(surface) = explained.samples[0].seen[0].surface() else { continue };
            let light = &surface.lights[0];
            let shadow = light.shadow.as_ref().unwrap();
            let visibility = light.terms.visibility.unwrap();
            let is_partial = visibility > 0.0 && visibility < shadow.terminator;
            partly += u32::from(is_partial);
            // The shares of the objects add up to what is kept away, but for what lies below the horizon.
            let shares: f32 = shadow.blocked_by.iter().map(|by| by.share).sum();
            assert!(shares <= 1.0 + 1e-5);
            if shadow.terminator == 1.0 && light.terms.n_dot_l > 0.8 {
                assert!((1.0 - visibility - shares).abs() < 1e-5, "{explained:?}");
            }
        }
        assert!(if radius == 0.0 { partly == 0 } else { partly > last }, "{radius}: {partly}");
        last = partly;
    }
}
