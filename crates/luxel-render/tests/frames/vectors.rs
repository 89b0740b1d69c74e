//! SVG against the picture: its paths, painted by the tests' own painter.

use crate::scenes::{execution, fitted, frontal, glass, matte, scene, square, view};
use crate::svg_painter::{painted, painted_document, paths};
use luxel_lighting::{Fog, FogLaw, PictureEncoding};
use luxel_math::SimdLevel;
use luxel_render::{RenderError, Renderer, Svg, SvgOptions, View};
use luxel_scene::{
    DMat4, DVec3, Lens, Mesh, Projection, Scene, Size, default_lights, demos, primitives,
};

/// Sixteen places a pixel, as programs smooth edges.
fn sixteen() -> Vec<[f64; 2]> {
    (0..16).map(|at| [(f64::from(at % 4) + 0.5) / 4.0, (f64::from(at / 4) + 0.5) / 4.0]).collect()
}

fn svg(scene: &Scene, view: &View, tolerance: f32) -> Svg {
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    renderer.svg(view, &SvgOptions { tolerance, ..SvgOptions::default() }).unwrap()
}

/// Pixels whose colour is farther than `allowed` steps from the picture's, each looked at in its
/// middle.
fn wrong_pixels(scene: &Scene, view: &View, tolerance: f32, allowed: f64) -> usize {
    // Not quite the middle: corners of these scenes lie there.
    let vectors =
        painted(&paths(&svg(scene, view, tolerance).text), view.size, &[[0.5003, 0.4996]]);
    let pixels = crate::scenes::bytes(scene, view);
    let differs = |(pixel, vector): (&[u8; 4], &[f64; 4])| {
        let alpha = f64::from(pixel[3]) / 255.0;
        (0..3).any(|at| {
            (f64::from(pixel[at]) * alpha - vector[at] * if vector[3] > 0.0 { 1.0 } else { 0.0 })
                .abs()
                > allowed
        })
    };
    pixels.iter().zip(&vectors).filter(|pair| differs(*pair)).count()
}

/// Three squares, each of which passes through the two others.
fn crossing() -> Scene {
    let colors = [[0.9, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.2, 0.9]];
    let mut scene = scene(colors.map(|color| (square(0.0), matte(color))).to_vec());
    let turns = [DMat4::IDENTITY, DMat4::from_rotation_x(1.3), DMat4::from_rotation_y(1.2)];
    for (node, turn) in scene.nodes.iter_mut().zip(turns) {
        node.parent_from_node = turn.into();
    }
    scene
}

/// Three bars in a ring, each before the next: no order of whole bars is right.
fn ring() -> Scene {
    let mut things = Vec::new();
    for (number, color) in
        [[0.9, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.2, 0.9]].into_iter().enumerate()
    {
        // From behind the bar before to in front of the bar after.
        let angle = number as f64 * std::f64::consts::TAU / 3.0;
        let turn = DMat4::from_rotation_z(angle);
        let at = |x: f64, y: f64, z: f64| {
            turn.transform_point3(DVec3::new(x, y, z)).as_vec3().to_array()
        };
        let mesh = Mesh {
            positions: vec![
                at(-1.5, -0.8, -0.5),
                at(1.5, -0.8, 0.5),
                at(1.5, -0.4, 0.5),
                at(-1.5, -0.4, -0.5),
            ],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            polygons: Some(vec![0, 0]),
            ..Mesh::default()
        };
        things.push((mesh, matte(color)));
    }
    scene(things)
}

#[test]
fn faces_through_one_another_and_in_a_ring_hide_what_the_picture_hides() {
    for (name, scene) in [("crossing", crossing()), ("ring", ring())] {
        let mut view = view(120);
        view.camera.view_from_world =
            luxel_scene::Camera::look_at(DVec3::new(2.0, 3.0, 9.0), DVec3::ZERO, DVec3::Y);
        // Where faces meet, the picture rounds depths to f32, and paths have two decimals.
        assert!(wrong_pixels(&scene, &view, 1.0, 2.5) <= 4, "{name}, parallel");
        view.camera.projection =
            Projection { lens: Lens::Perspective { fov_y_radians: 0.3 }, near: 1.0, far: 20.0 };
        let wrong = wrong_pixels(&scene, &view, 1.0, 2.5);
        assert!(wrong <= 4, "{name}, perspective: {wrong}");
    }
}

#[test]
fn many_squares_through_one_another_hide_what_the_picture_hides() {
    let mut scene = glass();
    for material in &mut scene.materials {
        material.alpha_mode = luxel_scene::AlphaMode::Opaque;
    }
    let view = fitted(&scene, Size { width: 200, height: 200 });
    let wrong = wrong_pixels(&scene, &view, 1.0, 2.5);
    // All edges meet in the middle, within a pixel; outlines of areas and of all have two decimals.
    assert!(wrong <= 6, "{wrong} pixels are wrong");
}

fn ball() -> Scene {
    scene(vec![(primitives::sphere(1.0, 48, 24), matte([0.8, 0.6, 0.4]))])
}

#[test]
fn shaded_colours_are_within_the_tolerance_of_the_picture() {
    let scene = ball();
    let mut view = fitted(&scene, Size { width: 160, height: 160 });
    view.lights = default_lights();
    let law = FogLaw::DepthCue { near: 1.5, far: 4.0, front: 1.0, back: 0.3 };
    view.fog = Some(Fog { color: [0.2, 0.2, 0.3], law });
    view.background = [0.1, 0.3, 0.2, 1.0].into();
    for tolerance in [1.0, 3.0, 8.0] {
        let wrong = wrong_pixels(&scene, &view, tolerance, f64::from(tolerance) + 1.0);
        // Outlines at two decimals; facets at the rim that are narrower than half a pixel.
        assert!(wrong <= 24, "tolerance {tolerance}: {wrong} pixels");
    }
    let size = |tolerance| svg(&scene, &view, tolerance).text.len();
    assert!(size(8.0) * 3 < size(1.0), "a coarser picture is smaller");
}

#[test]
fn demos_as_vectors_show_the_picture() {
    for name in ["teapot", "cornell", "plane"] {
        let scene = demos::demo(name).unwrap();
        let mut view = fitted(&scene, Size { width: 160, height: 90 });
        view.lights = if scene.lights.is_empty() { default_lights() } else { scene.lights.clone() };
        view.background = [0.2, 0.2, 0.25, 1.0].into();
        let wrong = wrong_pixels(&scene, &view, 4.0, 6.0);
        // Outlines at two decimals, and pieces less than half a pixel wide, which have one colour.
        assert!(wrong <= 160 * 90 / 100, "{name}: {wrong} pixels");
    }
}

#[test]
fn no_seam_lets_the_background_through() {
    let scene = ball();
    let mut view = fitted(&scene, Size { width: 96, height: 96 });
    view.lights = default_lights();
    view.background = [1.0, 0.0, 1.0, 1.0].into();
    let vectors = painted(&paths(&svg(&scene, &view, 2.0).text), view.size, &sixteen());
    let pixels = crate::scenes::bytes(&scene, &view);
    let inside = |x: usize, y: usize| {
        (y - 2..=y + 2).all(|y| (x - 2..=x + 2).all(|x| pixels[y * 96 + x][1] > 0))
    };
    let (mut looked_at, mut off, mut worst) = (0, 0, 0.0_f64);
    for y in 2..94 {
        for x in (2..94).filter(|&x| inside(x, y)) {
            let at = y * 96 + x;
            let differences =
                (0..3).map(|rgb| (f64::from(pixels[at][rgb]) - vectors[at][rgb]).abs());
            let difference = differences.fold(0.0, f64::max);
            worst = worst.max(difference);
            off += usize::from(difference > 6.0);
            looked_at += 1;
        }
    }
    // The background differs by 128 steps and more.
    assert!(looked_at > 2000 && worst < 16.0, "{looked_at} pixels, {worst} steps at worst");
    assert!(off * 100 < looked_at, "{off} of {looked_at} pixels");
}

#[test]
fn no_seam_lets_what_lies_behind_through() {
    let mut behind = square(-1.5);
    for place in &mut behind.positions {
        place[0] *= 4.0;
        place[1] *= 4.0;
    }
    // Its strips reach from one outline to the other, and are narrower than three pixels.
    let column = primitives::cylinder(0.7, 2.0, 64);
    let mut scene = scene(vec![(column, matte([0.8, 0.8, 0.7])), (behind, matte([0.9, 0.0, 0.9]))]);
    scene.nodes[0].parent_from_node = DMat4::from_rotation_z(0.1).into();
    let view = view(96).with_samples(16).with_lights(default_lights());
    let vectors = painted_document(&svg(&scene, &view, 1.0).text, view.size, &sixteen());
    let pixels = crate::scenes::bytes(&scene, &view);
    let (mut looked_at, mut off) = (0, 0);
    for y in 3..93 {
        for x in 3..93 {
            let mut around = (y - 2..=y + 2).flat_map(|y| (x - 2..=x + 2).map(move |x| y * 96 + x));
            let on_column = |at: usize| pixels[at][1] > 20;
            if around.all(on_column) {
                let at = y * 96 + x;
                let green = f64::from(pixels[at][1]) - vectors[at][1];
                off += usize::from(green.abs() > 6.0);
                if green.abs() > 6.0 {
                    eprintln!("OFF {x} {y} {green}");
                }
                looked_at += 1;
            }
        }
    }
    assert!(looked_at > 800 && off * 100 < looked_at, "{off} of {looked_at} pixels");
}

#[test]
fn outlines_are_no_heavier_than_the_pictures() {
    let mut things = vec![(primitives::sphere(1.0, 48, 24), matte([0.8, 0.6, 0.4]))];
    things.push((square(0.3), matte([0.2, 0.3, 0.6])));
    let scene = scene(things);
    let mut view = fitted(&scene, Size { width: 96, height: 96 }).with_samples(16);
    view.lights = default_lights();
    view.background = [0.0; 4].into();
    let vectors = painted_document(&svg(&scene, &view, 2.0).text, view.size, &sixteen());
    let pixels = crate::scenes::bytes(&scene, &view);
    let (mut count, mut expected, mut found, mut light) = (0.0, 0.0, 0.0, 0.0_f64);
    for (pixel, vector) in pixels.iter().zip(&vectors) {
        let alpha = f64::from(pixel[3]);
        if alpha > 0.0 && alpha < 255.0 {
            count += 1.0;
            expected += alpha;
            found += 255.0 * vector[3];
            // Colours are those of the surface, whatever lies below.
            for (&wanted, channel) in pixel[..3].iter().zip(vector) {
                let own = channel / vector[3].max(1e-9);
                light += (own - f64::from(wanted)).abs() * vector[3] / 3.0;
            }
        }
    }
    let (expected, found) = (expected / count, found / count);
    assert!(count > 200.0 && expected < 140.0, "{count} pixels of {expected}");
    assert!((found - expected).abs() < 4.0, "alpha {found} instead of {expected} in the mean");
    let light = light / count;
    assert!(light < 4.0, "colours of outlines are {light} steps off in the mean");
}

#[test]
fn what_is_hidden_of_a_seen_face_is_not_painted() {
    let mut scene =
        scene(vec![(square(0.0), matte([0.9; 3])), (square(0.0), matte([0.1, 0.1, 0.8]))]);
    // Before the middle of the first, whose light changes from left to right.
    let smaller = DMat4::from_scale(DVec3::new(0.75, 1.5, 1.0));
    scene.nodes[1].parent_from_node = (DMat4::from_translation(DVec3::Z * 0.5) * smaller).into();
    let law = FogLaw::DepthCue { near: 1.0, far: 20.0, front: 1.0, back: 0.0 };
    scene.nodes[0].parent_from_node = DMat4::from_rotation_y(0.4).into();
    let mut view = view(64).with_fog(Some(Fog { color: [0.0; 3], law }));
    let all = svg(&scene, &view, 1.0);
    let middle = [32.3, 32.4];
    let below: Vec<_> = paths(&all.text).into_iter().filter(|path| path.contains(middle)).collect();
    view.fog = None;
    let even = svg(&scene, &view, 1.0);
    assert!(all.pieces > even.pieces + 4, "{} pieces are no gradient", all.pieces);
    let grey = below.iter().skip(1).filter(|path| path.color[0] == path.color[2]);
    assert_eq!(grey.count(), 0, "areas of the hidden square in the middle of the other");
}

#[test]
fn no_line_shows_where_faces_in_a_ring_are_cut() {
    let scene = ring();
    let mut view = view(200).with_samples(16);
    view.camera.view_from_world =
        luxel_scene::Camera::look_at(DVec3::new(2.0, 3.0, 9.0), DVec3::ZERO, DVec3::Y);
    let vectors = painted_document(&svg(&scene, &view, 1.0).text, view.size, &sixteen());
    let pixels = crate::scenes::bytes(&scene, &view);
    let mut lines = 0;
    for y in 2..198 {
        for x in 2..198 {
            let around = (y - 2..=y + 2).flat_map(|y| (x - 2..=x + 2).map(move |x| y * 200 + x));
            let own = pixels[y * 200 + x];
            let even =
                { around }.all(|at| (0..3).all(|rgb| pixels[at][rgb].abs_diff(own[rgb]) < 4));
            let off =
                (0..3).any(|rgb| (f64::from(own[rgb]) - vectors[y * 200 + x][rgb]).abs() > 8.0);
            lines += usize::from(even && off);
        }
    }
    assert!(lines <= 2, "{lines} pixels within the bars show what lies behind");
}

#[test]
fn glass_blends_as_in_the_picture() {
    let scene = glass();
    // Programs blend encoded colours, so that only these can be compared.
    let view = fitted(&scene, Size { width: 128, height: 128 })
        .with_encoding(PictureEncoding::None)
        .with_background([1.0; 4]);
    let wrong = wrong_pixels(&scene, &view, 1.0, 6.0);
    assert!(wrong <= 128 * 128 / 200, "{wrong} pixels");
}

#[test]
fn an_even_square_is_one_path_of_its_four_corners() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let expected = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"16\" height=\"16\" \
                    viewBox=\"0 0 16 16\">\n<path fill=\"#fff\" d=\"m4 12v-8h8v8z\"/>\n</svg>\n";
    assert_eq!(svg(&scene, &view(16), 1.0).text, expected);
}

#[test]
fn of_objects_in_one_plane_the_first_is_painted_where_the_picture_shows_it() {
    let colors = [[0.9, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.2, 0.9]];
    let mut scene = scene(colors.map(|color| (square(0.0), matte(color))).to_vec());
    // In one plane but for rounding, which moves each otherwise.
    let plane = DMat4::from_rotation_x(0.7) * DMat4::from_rotation_y(0.4);
    for (number, node) in scene.nodes.iter_mut().enumerate() {
        let turn = DMat4::from_rotation_z(0.5 * number as f64);
        let place = DMat4::from_translation(DVec3::new(0.3 * number as f64, 0.2, 0.0));
        let rounded = |value: f64| f64::from(value as f32);
        let world = (plane * place * turn).to_cols_array().map(rounded);
        node.parent_from_node = DMat4::from_cols_array(&world).into();
    }
    let view = view(120);
    assert!(wrong_pixels(&scene, &view, 1.0, 2.5) <= 4);
    // The first square is seen whole.
    let red = |pixel: &&[u8; 4]| pixel[0] / 2 > pixel[1].max(pixel[2]);
    let seen = |scene: &Scene| crate::scenes::bytes(scene, &view).iter().filter(red).count();
    let together = seen(&scene);
    scene.nodes.truncate(1);
    assert_eq!(together, seen(&scene));
    assert!(together > 1000, "{together} pixels");
}

#[test]
fn what_lies_behind_is_not_painted() {
    let near = (square(1.0), matte([1.0; 3]));
    let scene = scene(vec![near, (square(-1.0), matte([0.5; 3])), (square(0.0), matte([0.2; 3]))]);
    assert_eq!(svg(&scene, &view(16), 1.0).faces, 2);
}

#[test]
fn the_text_depends_on_neither_threads_nor_instruction_set() {
    let scene = crossing();
    let view = fitted(&scene, Size { width: 64, height: 64 }).with_lights(vec![frontal([0.9; 3])]);
    let text = |threads, simd| {
        let renderer = Renderer::new(scene.clone(), &execution(threads, simd)).unwrap();
        renderer.svg(&view, &SvgOptions::default()).unwrap().text
    };
    assert_eq!(text(1, SimdLevel::Auto), text(3, SimdLevel::Auto));
    assert_eq!(text(1, SimdLevel::Scalar), text(3, SimdLevel::Auto));
}

#[test]
fn too_many_pieces_are_refused() {
    let scene = ball();
    let view = fitted(&scene, Size { width: 64, height: 64 }).with_lights(default_lights());
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let options = SvgOptions { max_pieces: 100, ..SvgOptions::default() };
    assert_eq!(renderer.svg(&view, &options), Err(RenderError::TooManyPieces(100)));
}
