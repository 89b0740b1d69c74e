//! Layers against geometry that is known.

use crate::scenes::{execution, fitted, matte, scene, square, view};
use luxel_math::SimdLevel;
use luxel_render::{Layer, LayerValues, Picture, RenderError, Renderer, Shading, ShadingMode};
use luxel_scene::{DMat4, DVec3};
use std::sync::atomic::AtomicBool;

/// Two squares, the second one nearer and shifted to the right by half a unit.
fn renderer() -> Renderer {
    let mut near = square(2.0);
    near.positions.iter_mut().for_each(|position| position[0] += 0.5);
    let scene = scene(vec![(square(0.0), matte([1.0; 3])), (near, matte([1.0; 3]))]);
    Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap()
}

fn values(layer: Layer) -> LayerValues {
    renderer().layers(&view(64), &[layer]).unwrap().remove(0)
}

fn f32s(layer: Layer) -> Vec<f32> {
    match values(layer.clone()) {
        LayerValues::F32(values) => values,
        LayerValues::U32(_) => panic!("{layer:?} holds floats"),
    }
}

fn u32s(layer: Layer) -> Vec<u32> {
    match values(layer.clone()) {
        LayerValues::U32(values) => values,
        LayerValues::F32(_) => panic!("{layer:?} holds ids"),
    }
}

/// The number of the pixel whose centre is nearest to a place in the world.
fn pixel(x: f64, y: f64) -> usize {
    ((2.0 - y) * 16.0) as usize * 64 + ((x + 2.0) * 16.0) as usize
}

#[test]
fn objects_and_triangles_are_numbered_as_they_come() {
    let (objects, triangles) = (u32s(Layer::Object), u32s(Layer::Triangle));
    assert_eq!(objects[pixel(-0.8, 0.0)], 0);
    assert_eq!(objects[pixel(0.0, 0.0)], 1);
    assert_eq!(objects[pixel(-1.8, 0.0)], u32::MAX);
    // Lower right and upper left of the far square.
    assert_eq!(triangles[pixel(-0.75, -0.9)], 0);
    assert_eq!(triangles[pixel(-0.9, 0.9)], 1);
    assert_eq!(triangles[pixel(-1.8, 0.0)], u32::MAX);
}

#[test]
fn objects_that_are_not_drawn_hide_nothing_and_come_back() {
    let mut renderer = renderer();
    let objects = |renderer: &Renderer| renderer.layers(&view(64), &[Layer::Object]).unwrap();
    let picture = |renderer: &Renderer| renderer.rgba8(&view(64)).unwrap().pixels;
    let (all, whole) = (objects(&renderer), picture(&renderer));
    for only in [0, 1] {
        renderer.draw_only(|object| object == only);
        let LayerValues::U32(ids) = objects(&renderer).remove(0) else { panic!("no ids") };
        let is_seen = |x: f64| ids[pixel(x, 0.0)] == 0;
        let expected = if only == 0 { [true, true, false] } else { [false, true, true] };
        assert_eq!([-0.8, 0.0, 1.3].map(is_seen), expected, "{only}");
    }
    renderer.draw_only(|_| true);
    assert_eq!((objects(&renderer), picture(&renderer)), (all, whole));
}

#[test]
fn depths_are_those_of_an_orthographic_camera() {
    // The eye is 10 away, near 1, far 20.
    let (depth, z) = (f32s(Layer::Depth), f32s(Layer::Z));
    assert!((depth[pixel(-0.8, 0.0)] - 9.0 / 19.0).abs() < 1e-6);
    assert!((depth[pixel(0.0, 0.0)] - 7.0 / 19.0).abs() < 1e-6);
    assert_eq!(depth[pixel(-1.8, 0.0)], 1.0);
    assert!((z[pixel(0.0, 0.0)] - 8.0).abs() < 1e-6);
    assert_eq!(z[pixel(-1.8, 0.0)], f32::INFINITY);
}

#[test]
fn positions_normals_and_weights_agree_with_the_square() {
    let (positions, normals) = (f32s(Layer::Position), f32s(Layer::Normal));
    let (weights, uvs) = (f32s(Layer::Barycentric), f32s(Layer::Uv));
    for y in 0..64 {
        for x in 0..64 {
            let at = y * 64 + x;
            let [px, py] = [x, y].map(|pixel| (f64::from(pixel as u32) + 0.5) / 16.0 - 2.0);
            let py = -py;
            // The far square, left of the near one.
            if px.abs() < 1.0 && py.abs() < 1.0 && px < -0.5 {
                let near = |value: f32, expected: f64| (f64::from(value) - expected).abs() < 1e-6;
                assert!(near(positions[3 * at], px) && near(positions[3 * at + 1], py), "{x} {y}");
                assert!(near(positions[3 * at + 2], 0.0));
                assert_eq!(normals[3 * at..3 * at + 3], [0.0, 0.0, 1.0]);
                let sum: f32 = weights[3 * at..3 * at + 3].iter().sum();
                assert!((sum - 1.0).abs() < 1e-6);
                assert!(near(uvs[2 * at], (px + 1.0) / 2.0));
                assert!(near(uvs[2 * at + 1], (1.0 - py) / 2.0));
            }
        }
    }
}

#[test]
fn a_picture_with_its_layers_has_the_bytes_of_each_alone() {
    let demo = luxel_scene::demos::demo("spheres").unwrap();
    let size = luxel_scene::Size { width: 150, height: 100 };
    let renderer = Renderer::new(demo.clone(), &execution(2, SimdLevel::Auto)).unwrap();
    let lights = luxel_scene::default_lights();
    let modes = [ShadingMode::Phong, ShadingMode::Subdivided { tolerance: 2.0 }];
    let backgrounds = [[0.2, 0.4, 0.6, 0.5], [1.0, 0.0, 0.0, 0.0]];
    for ((samples, mode), background) in
        [1, 4].into_iter().zip(modes).zip(backgrounds).chain([((1, modes[1]), backgrounds[1])])
    {
        let lights = lights.clone();
        let shading = Shading { mode, ..Shading::default() };
        let view = fitted(&demo, size)
            .with_samples(samples)
            .with_lights(lights)
            .with_background(background)
            .with_ground(samples == 1 && mode == modes[0])
            .with_shading(shading);
        let (mut picture, mut values) = (Picture::default(), Vec::new());
        renderer.rgba8_with_layers(&view, &Layer::ALL, &mut picture, &mut values).unwrap();
        let alone = renderer.rgba8(&view).unwrap();
        assert!(picture.pixels == alone.pixels, "{samples} samples, {background:?}");
        assert_eq!(picture.subdivision, alone.subdivision);
        for (layer, values) in Layer::ALL.iter().zip(&values) {
            let alone = renderer.layers(&view, std::slice::from_ref(layer)).unwrap().remove(0);
            assert!(*values == alone, "{layer:?}, {samples} samples");
        }
    }
}

#[test]
fn a_picture_that_was_stopped_is_no_success() {
    let renderer = renderer();
    let (mut picture, mut values) = (Picture::default(), Vec::new());
    for samples in [1, 4] {
        for layers in [&[][..], &[Layer::Z], &Layer::ALL] {
            let view = view(64).with_samples(samples);
            let mut draw = |stop: bool| {
                let stop = AtomicBool::new(stop);
                renderer.rgba8_with_layers_until(&stop, &view, layers, &mut picture, &mut values)
            };
            assert!(draw(false).is_ok());
            assert!(matches!(draw(true), Err(RenderError::Stopped)), "{samples}, {layers:?}");
        }
    }
}

#[test]
fn objects_are_drawn_where_they_were_moved() {
    let mut renderer = renderer();
    let objects = |renderer: &Renderer| renderer.layers(&view(64), &[Layer::Object]).unwrap();
    let mut moved = renderer.objects().to_vec();
    let untouched = objects(&renderer);
    moved.remove(0);
    for object in &mut moved {
        object.world_from_mesh = (DMat4::from_translation(DVec3::new(-1.0, 0.0, 0.0))
            * object.world_from_mesh.matrix())
        .into();
    }
    // The near square, then the far one in two places.
    let far = renderer.objects()[0].clone();
    moved.extend([far.clone(), far]);
    renderer.show_objects(moved);
    let LayerValues::U32(ids) = objects(&renderer).remove(0) else { panic!("no ids") };
    let seen = [-1.4, 0.0, 0.8, 1.3].map(|x| ids[pixel(x, 0.0)]);
    assert_eq!(seen, [0, 0, 1, u32::MAX], "x from -1.5 to 0.5, then the far square up to 1");
    let all = renderer.scene().objects();
    renderer.show_objects(all);
    assert_eq!(objects(&renderer), untouched);
}
