//! The same bytes from every number of threads and every instruction set.

use crate::ledger::{many_lights, occluded};
use crate::scenes::{bytes, execution, glass, matte, scene, view};
use luxel_lighting::Tone;
use luxel_math::SimdLevel;
use luxel_render::{
    Background, Edges, Execution, Interpolation, Layer, Picture, Renderer, Shading, ShadingMode,
    TILE_SIDE, View,
};
use luxel_scene::{
    Camera, DVec2, DVec3, Lens, NormalOptions, Projection, Scene, Size, demos, primitives,
};
use std::sync::{Arc, mpsc};
use std::time::Duration;

fn perspective(scene: &Scene, size: Size) -> View {
    let bounds = scene.bounds();
    let eye = bounds.centre() + DVec3::new(0.4, 0.3, 1.0).normalize() * bounds.radius() * 2.2;
    let projection = Projection {
        lens: Lens::Perspective { fov_y_radians: 0.8 },
        near: bounds.radius() * 0.1,
        far: bounds.radius() * 10.0,
    };
    let view_from_world = Camera::look_at(eye, bounds.centre(), DVec3::Y);
    view(1).with_size(size).with_camera(Camera { view_from_world, projection }).with_samples(4)
}

fn check(name: &str, scene: &Scene, view: &View) {
    let of = |threads, simd| {
        let renderer = Renderer::new(scene.clone(), &execution(threads, simd)).unwrap();
        let layers = renderer.layers(view, &Layer::ALL).unwrap();
        (renderer.rgba8(view).unwrap().pixels, renderer.linear(view).unwrap().pixels, layers)
    };
    let bits = |pixels: &[[f32; 4]]| -> Vec<u32> {
        pixels.as_flattened().iter().map(|value| value.to_bits()).collect()
    };
    let (bytes, linear, layers) = of(1, SimdLevel::Auto);
    assert!(bytes.iter().any(|pixel| *pixel != bytes[0]), "{name}: something is drawn");
    let ways = SimdLevel::available().into_iter().zip([7, 2, 1].into_iter().cycle());
    for (simd, threads) in ways.chain([(SimdLevel::Auto, 2), (SimdLevel::Auto, 7)]) {
        let (other_bytes, other_linear, other_layers) = of(threads, simd);
        assert!(bytes == other_bytes, "{name}: bytes differ at {simd}, {threads} threads");
        assert!(bits(&linear) == bits(&other_linear), "{name}: {simd}, {threads} threads");
        assert!(layers == other_layers, "{name}: layers differ at {simd}, {threads} threads");
    }
}

#[test]
fn demos_have_the_same_bytes_however_they_are_run() {
    for (name, _) in demos::names() {
        let scene = demos::demo(name).unwrap();
        check(name, &scene, &perspective(&scene, Size { width: 150, height: 90 }));
    }
}

#[test]
fn every_shading_mode_has_the_same_bytes_however_it_is_run() {
    let scene = demos::demo("plane").unwrap();
    for (mode, interpolation) in [
        (ShadingMode::Flat, Interpolation::Screen),
        (ShadingMode::Gouraud, Interpolation::Perspective),
        (ShadingMode::Gouraud, Interpolation::Scanline),
        (ShadingMode::Subdivided { tolerance: 2.0 }, Interpolation::Perspective),
    ] {
        let mut view = perspective(&scene, Size { width: 150, height: 90 });
        view.shading = Shading { mode, interpolation, ..Shading::default() };
        check(&format!("{mode:?}"), &scene, &view);
    }
}

#[test]
fn glass_and_wires_have_the_same_bytes_however_they_are_run() {
    let scene = glass();
    let mut view = perspective(&scene, Size { width: 130, height: 70 });
    check("glass", &scene, &view);
    view.edges = Some(Edges::OVER_FACES);
    check("edges", &scene, &view);
    view.edges = Some(Edges::WIREFRAME);
    check("wires", &scene, &view);
}

/// What the tests beside it draw, in few pixels: unoptimised code, as that of one value at a time is when it is
/// tested, draws these within seconds.
#[test]
fn small_pictures_have_the_same_bytes_however_they_are_run() {
    let size = Size { width: 33, height: 21 };
    let scene = demos::demo("plane").unwrap();
    for mode in ShadingMode::ALL {
        let shading = Shading { mode, ..Shading::default() };
        let view = perspective(&scene, size).with_samples(1).with_shading(shading);
        check(&format!("{mode:?}"), &scene, &view);
    }
    let scene = glass();
    let view = perspective(&scene, size).with_lights(many_lights(&scene)).with_exposure(0.7);
    check("shadows", &scene, &occluded(view.clone(), true).with_shadows(true).with_ground(true));
    check("tone", &scene, &view.clone().with_tone(Tone::ALL[1]));
    check("edges", &scene, &view.with_edges(Some(Edges::OVER_FACES)));
}

#[test]
fn exposed_pictures_have_the_same_bytes_however_they_are_run() {
    for scene in [glass(), demos::demo("spheres").unwrap()] {
        let view = perspective(&scene, Size { width: 130, height: 70 }).with_exposure(0.7);
        for tone in Tone::ALL {
            check(tone.name(), &scene, &view.clone().with_tone(tone));
        }
    }
}

#[test]
fn shadows_have_the_same_bytes_however_they_are_run() {
    let size = Size { width: 110, height: 70 };
    let demo = |name: &str| (name.to_owned(), demos::demo(name).unwrap());
    for (name, scene) in [demo("cornell"), demo("welcome"), ("glass".to_owned(), glass())] {
        let view = perspective(&scene, size).with_lights(many_lights(&scene));
        check(&name, &scene, &view.clone().with_shadows(true));
        check(&name, &scene, &occluded(view.clone(), true));
        for background in [Background::TRANSPARENT, Background::Studio] {
            let view = occluded(view.clone(), background == Background::Studio);
            check(&name, &scene, &view.with_background(background).with_ground(true));
        }
    }
}

#[test]
fn a_model_has_the_same_bytes_in_units_of_femtometres_and_of_light_years() {
    let in_units = |unit: f32| {
        let mut scene = demos::demo("teapot").unwrap();
        for position in scene.meshes.iter_mut().flat_map(|mesh| &mut mesh.positions) {
            *position = position.map(|side| side * unit);
        }
        let view = perspective(&scene, Size { width: 150, height: 90 });
        bytes(&scene, &view)
    };
    let expected = in_units(1.0);
    // Powers of two leave all digits as they are.
    for exponent in [-50, -30, -10, 10, 30, 60] {
        assert!(in_units(libm::exp2f(exponent as f32)) == expected, "2^{exponent}");
    }
}

#[test]
fn the_order_in_which_triangles_are_cut_is_not_seen() {
    // Waves that hide one another; rows are long enough for the file's order to be kept.
    let mut mesh = primitives::plane(DVec2::new(6.0, 2.0), 600, 50);
    for [x, y, z] in &mut mesh.positions {
        let height = libm::sinf(9.0 * *x) * libm::cosf(11.0 * (*y + *z)) * 0.4;
        (*x, *y, *z) = (*x, *y + height, *z + 0.7 * height);
    }
    mesh.compute_normals(&NormalOptions::default());
    let scene = scene(vec![(mesh, matte([0.7, 0.6, 0.5]))]);
    let view = perspective(&scene, Size { width: 250, height: 90 });
    let of = |one_frame| {
        let execution = Execution { one_frame, ..execution(2, SimdLevel::Auto) };
        let renderer = Renderer::new(scene.clone(), &execution).unwrap();
        (renderer.rgba8(&view).unwrap().pixels, renderer.layers(&view, &Layer::ALL).unwrap())
    };
    assert!(of(true) == of(false));
}

#[test]
fn tiles_drawn_in_sets_have_the_bytes_of_the_picture_and_others_stay() {
    let scene = Arc::new(demos::demo("spheres").unwrap());
    let size = Size { width: 300, height: 170 };
    let view = perspective(&scene, size).with_background([0.1, 0.2, 0.3, 0.5]);
    let renderer = Renderer::new(Arc::clone(&scene), &execution(2, SimdLevel::Auto)).unwrap();
    let whole = renderer.rgba8(&view).unwrap();

    // Several renderers, each with a share of one picture; then one, which bins the view once.
    let mut shared = Picture::default();
    for share in 0..8 {
        let own = Renderer::new(Arc::clone(&scene), &execution(1, SimdLevel::Auto)).unwrap();
        own.rgba8_tiles_into(&view, |tile| tile % 8 == share, &mut shared).unwrap();
    }
    assert!(shared.pixels == whole.pixels, "a partition among renderers differs");
    let mut picture = Picture::default();
    let count = renderer.with_tiles(&view, |tiles| {
        tiles.rgba8_into(|tile| tile >= 7, &mut picture);
        tiles.rgba8_into(|tile| tile < 7, &mut picture);
        tiles.count()
    });
    assert_eq!(count.unwrap(), [5, 3]);
    assert!(picture.pixels == whole.pixels, "a partition of one renderer differs");

    let marked = [1, 2, 3, 4];
    picture.pixels.fill(marked);
    renderer.rgba8_tiles_into(&view, |tile| tile == 6 || tile == 0, &mut picture).unwrap();
    let side = TILE_SIDE as usize;
    for (at, (own, expected)) in picture.pixels.iter().zip(&whole.pixels).enumerate() {
        let [column, row] = [at % 300 / side, at / 300 / side];
        let drawn = [6, 0].contains(&(row * 5 + column));
        assert_eq!(own, if drawn { expected } else { &marked }, "pixel {at}");
    }
}

#[test]
fn views_drawn_at_once_by_a_new_renderer_wait_for_one_another_forever() {
    let scene = Arc::new(demos::demo("welcome").unwrap());
    let mut view = perspective(&scene, Size { width: 48, height: 32 });
    view.shadows = true;
    view.ground = true;
    view.shading.mode = ShadingMode::Flat;
    let drawn_by = |renderer: &Renderer, view: &View| renderer.rgba8(view).unwrap().pixels;
    let execution = execution(2, SimdLevel::Auto);
    let expected = drawn_by(&Renderer::new(Arc::clone(&scene), &execution).unwrap(), &view);
    for _ in 0..50 {
        let renderer = Arc::new(Renderer::new(Arc::clone(&scene), &execution).unwrap());
        let (sender, drawn) = mpsc::channel();
        for _ in 0..4 {
            let (renderer, view, sender) = (Arc::clone(&renderer), view.clone(), sender.clone());
            // No scope, which would wait for a thread that never ends.
            std::thread::spawn(move || sender.send(drawn_by(&renderer, &view)));
        }
        for _ in 0..4 {
            let pixels = drawn.recv_timeout(Duration::from_secs(120)).expect("a picture");
            assert!(pixels == expected, "the pictures differ");
        }
    }
}
