//! Pictures lit by a map, and with the environment behind the model.

use crate::ledger::{occluded, reflections};
use crate::scenes::{self, execution, fitted, matte, scene};
use luxel_lighting::{Environment, EnvironmentMap, EquirectangularImage, Reflection, Tone};
use luxel_math::{SimdLevel, Vec3};
use luxel_render::{
    EnvironmentChoice, Interpolation, Layer, LayerValues, Renderer, Seen, Shading, ShadingMode,
    View, auto_exposure,
};
use luxel_scene::{DVec3, Scene, Size, Viewpoint, demos, primitives};
use std::sync::Arc;

/// A picture of 64x32 texels, each of whose channels has another pattern.
fn patterned(rotation_degrees: f64) -> EnvironmentChoice {
    let texel = |at: u32| {
        let (column, row) = (at % 64, at / 64);
        [
            (column % 7) as f32 * 0.2,
            (row % 5) as f32 * 0.3,
            if at.is_multiple_of(97) { 9.0 } else { 0.1 },
        ]
    };
    let light = (0..64 * 32).map(texel).collect();
    let image = EquirectangularImage { width: 64, height: 32, light };
    let map = Arc::new(EnvironmentMap::new("patterned", image));
    EnvironmentChoice::of_map(map, Viewpoint::frame(DVec3::Y), rotation_degrees)
}

fn constant(color: [f32; 3]) -> EnvironmentChoice {
    let image = EquirectangularImage { width: 16, height: 8, light: vec![color; 128] };
    let map = Arc::new(EnvironmentMap::new("constant", image));
    EnvironmentChoice::of_map(map, Viewpoint::frame(DVec3::Y), 0.0)
}

fn renderer(scene: &Scene) -> Renderer {
    Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap()
}

/// A ball of one model.
fn ball(reflection: Reflection) -> Scene {
    let mut material = matte([0.9, 0.5, 0.3]);
    material.constants.reflection = reflection;
    material.constants.roughness = 0.3;
    material.constants.metallic = 0.4;
    material.constants.k_s = 0.7;
    scene(vec![(primitives::sphere(1.0, 24, 12), material)])
}

fn all_around(scene: &Scene, round: usize) -> View {
    let modes = [
        ShadingMode::Phong,
        ShadingMode::Gouraud,
        ShadingMode::Flat,
        ShadingMode::Subdivided { tolerance: 2.0 },
    ];
    let shading = Shading { mode: modes[round % 4], ..Shading::default() };
    fitted(scene, Size { width: 90, height: 70 })
        .with_samples([1, 4, 16][round % 3])
        .with_environment(patterned(30.0))
        .with_environment_background(round.is_multiple_of(2))
        .with_exposure([0.0, -0.7][round / 2 % 2])
        .with_tone(Tone::ALL[round % Tone::ALL.len()])
        .with_shading(shading)
}

#[test]
fn pixels_under_a_map_are_as_they_are_explained_and_their_terms_add_up() {
    let mut diffuse_seen = 0;
    for (number, reflection) in reflections().into_iter().enumerate() {
        let scene = ball(reflection);
        let renderer = renderer(&scene);
        for round in 0..4 {
            let view = occluded(all_around(&scene, number + round), round == 3);
            let picture = renderer.rgba8(&view).unwrap();
            let pixels: Vec<_> = (0..90 * 70).step_by(151).map(|at| [at % 90, at / 90]).collect();
            for explained in renderer.explain_pixels(&view, &pixels).unwrap() {
                let [x, y] = explained.pixel;
                let drawn = picture.pixels[(y * 90 + x) as usize];
                assert_eq!(explained.rgba8, drawn, "model {number}, round {round}: {x}, {y}");
                for seen in explained.samples.iter().flat_map(|sample| &sample.seen) {
                    let Seen::Surface(surface) = seen else { continue };
                    let mut sum = [0.0; 3];
                    for channel in 0..3 {
                        sum[channel] = surface.emission[channel] + surface.scene_ambient[channel];
                        for light in &surface.lights {
                            sum[channel] += light.terms.ambient.lane(0)[channel]
                                + light.terms.diffuse.lane(0)[channel]
                                + light.terms.specular.lane(0)[channel];
                        }
                        sum[channel] += surface.environment[channel];
                        let error = (sum[channel] - surface.sum[channel]).abs();
                        assert!(error <= 1e-5 * sum[channel].max(1.0), "{sum:?} {:?}", surface.sum);
                    }
                    let diffuse = surface.environment_diffuse.unwrap_or_default();
                    diffuse_seen += usize::from(diffuse != [0.0; 3]);
                }
            }
        }
    }
    assert!(diffuse_seen > 400, "{diffuse_seen}");
}

#[test]
fn pictures_under_a_map_have_the_same_bytes_however_they_are_drawn() {
    let scene = demos::demo("spheres").unwrap();
    for round in 0..4 {
        let view = all_around(&scene, round).with_size(Size { width: 150, height: 90 });
        let of = |threads, simd| {
            let renderer = Renderer::new(scene.clone(), &execution(threads, simd)).unwrap();
            let linear = renderer.linear(&view).unwrap().pixels;
            let bits: Vec<u32> =
                linear.as_flattened().iter().map(|value| value.to_bits()).collect();
            (renderer.rgba8(&view).unwrap().pixels, bits)
        };
        let first = of(1, SimdLevel::Auto);
        for (simd, threads) in SimdLevel::available().into_iter().zip([3, 2, 1].into_iter().cycle())
        {
            assert!(first == of(threads, simd), "round {round}, {simd}, {threads} threads");
        }
    }
}

#[test]
fn mirrors_see_a_picture_of_one_colour_as_that_colour_all_around() {
    let color = [0.5, 0.25, 0.125];
    for (reflection, metallic) in [(Reflection::Mirror, 0.0), (Reflection::Microfacet, 1.0)] {
        let mut scene = ball(reflection);
        scene.materials[0].constants.metallic = metallic;
        let renderer = renderer(&scene);
        let view = fitted(&scene, Size { width: 60, height: 60 }).with_environment_background(true);
        let of =
            |environment| renderer.linear(&view.clone().with_environment(environment)).unwrap();
        let flat = of(EnvironmentChoice::Always(Environment::Constant(color)));
        let map = of(constant(color));
        for (a, b) in map.pixels.as_flattened().iter().zip(flat.pixels.as_flattened()) {
            assert!((a - b).abs() <= 1e-4 * b.max(1.0), "{a} {b}");
        }
        // What a mirror shows of the studio is formula, with and without its being the background.
        let studio = Environment::Studio { up: [0.0, 1.0, 0.0] };
        let behind = of(EnvironmentChoice::Always(studio));
        assert!(behind.pixels[0][1] != behind.pixels[59 * 60][1], "the studio is a gradient");
    }
}

#[test]
fn a_white_matt_surface_under_uniform_light_has_that_light_and_openness_weakens_it() {
    let mut scene = ball(Reflection::Lambert);
    scene.materials[0].constants.diffuse = [1.0; 3];
    let light = [0.5, 0.25, 2.0];
    let renderer = renderer(&scene);
    let view = fitted(&scene, Size { width: 40, height: 40 })
        .with_environment(constant(light))
        .with_lights(Vec::new())
        .with_ambient([0.0; 3]);
    let centre = renderer.linear(&view).unwrap().pixels[20 * 40 + 20];
    for channel in 0..3 {
        assert!((centre[channel] / light[channel] - 1.0).abs() < 1e-4, "{centre:?}");
    }
    // The environment's term is that light times openness.
    let occluded = occluded(view.clone(), true).with_lights(Vec::new());
    let layers = renderer.layers(&occluded, &[Layer::Openness, Layer::Environment]).unwrap();
    let [openness, environment] = &layers[..] else { panic!("two layers") };
    let (LayerValues::F32(openness), LayerValues::F32(environment)) = (openness, environment)
    else {
        panic!("of floats")
    };
    for (pixel, openness) in openness.iter().enumerate() {
        let term = environment[pixel * 3];
        if term > 0.0 {
            assert!((term - 0.5 * openness).abs() < 1e-3, "{pixel}: {term}, {openness}");
        }
    }
}

#[test]
fn the_background_is_the_environment_along_each_pixels_ray() {
    let scene = ball(Reflection::Unlit);
    let size = Size { width: 60, height: 40 };
    let choice = patterned(100.0);
    let environment = choice.surroundings(DVec3::Y);
    let view = fitted(&scene, size)
        .with_samples(1)
        .with_environment(choice)
        .with_environment_background(true);
    let picture = renderer(&scene).linear(&view).unwrap();
    let world_from_view = view.camera.view_from_world.inverse();
    let luxel_scene::Lens::Perspective { fov_y_radians } = view.camera.projection.lens else {
        panic!("a perspective")
    };
    let half = libm::tan(fov_y_radians / 2.0);
    for [x, y] in [[0_u32, 0], [59, 0], [3, 37], [58, 39]] {
        let across = ((f64::from(x) + 0.5) / 60.0 * 2.0 - 1.0) * half * 1.5;
        let up = (1.0 - (f64::from(y) + 0.5) / 40.0 * 2.0) * half;
        let ray = world_from_view.transform_vector3(DVec3::new(across, up, -1.0)).normalize();
        let [dx, dy, dz] = ray.as_vec3().to_array();
        let expected = environment.radiance(Vec3::new(dx, dy, dz), 0.0).lane(0);
        let found = picture.pixels[(y * 60 + x) as usize];
        for channel in 0..3 {
            assert!(
                (found[channel] - expected[channel]).abs() < 1e-3,
                "{x} {y}: {found:?} {expected:?}"
            );
        }
        assert_eq!(found[3], 1.0);
    }
    // Parallel rays see one direction.
    let parallel = scenes::view(32).with_environment(patterned(0.0));
    let parallel = parallel.with_environment_background(true).with_samples(1);
    let pixels = renderer(&scene).rgba8(&parallel).unwrap().pixels;
    assert!(pixels[0] == pixels[pixels.len() - 1] && pixels[0][3] == 255);
    // Without an environment the background stays.
    let none = parallel.with_environment(EnvironmentChoice::Always(Environment::None));
    assert_eq!(renderer(&scene).rgba8(&none).unwrap().pixels[0], [0; 4]);
}

#[test]
fn the_mean_of_a_map_sets_the_exposure() {
    let scene = ball(Reflection::Lambert);
    let view = fitted(&scene, Size { width: 40, height: 40 }).with_environment(constant([64.0; 3]));
    let ev = auto_exposure(&scene, &view).ev;
    assert!((ev + 6.0).abs() < 0.05, "{ev}");
}

#[test]
fn scan_lines_and_other_interpolations_show_the_map_as_explained() {
    let scene = ball(Reflection::BlinnPhong);
    let renderer = renderer(&scene);
    for interpolation in [Interpolation::Scanline, Interpolation::Screen] {
        let shading = Shading { interpolation, ..Shading::default() };
        let view = all_around(&scene, 0).with_shading(shading);
        let picture = renderer.rgba8(&view).unwrap();
        for at in (0..90 * 70).step_by(131) {
            let explained = renderer.explain_pixels(&view, &[[at % 90, at / 90]]).unwrap();
            assert_eq!(explained[0].rgba8, picture.pixels[at as usize]);
        }
    }
}
