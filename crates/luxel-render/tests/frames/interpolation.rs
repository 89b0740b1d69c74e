//! Interpolation between corners: in perspective, on the screen, along scanlines; clamped, and with normals as long as
//! interpolation leaves them.

use crate::scenes::{bytes, execution, largest_difference, linear, matte, scene, square, view};
use crate::shading::{sheet, sheet_view};
use luxel_math::SimdLevel;
use luxel_render::{At, Clamp, Interpolation, NormalLength, Renderer, Shading, ShadingMode, View};
use luxel_scene::DMat4;

/// A square whose corners differ, turned about the line of sight.
fn rolled(interpolation: Interpolation, degrees: f64) -> Vec<[u8; 4]> {
    let mut mesh = square(0.0);
    mesh.colors = vec![[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0], [1.0; 4]];
    let mut scene = scene(vec![(mesh, matte([1.0; 3]))]);
    scene.nodes[0].parent_from_node = DMat4::from_rotation_z(degrees.to_radians()).into();
    let shading = Shading { mode: ShadingMode::Gouraud, interpolation, ..Shading::default() };
    let pixels = bytes(&scene, &view(65).with_shading(shading));
    // Turned back: pixels near the middle, asked at the same places of the square.
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let at = |x: f64, y: f64| {
        let [x, y] = [cos * x - sin * y, sin * x + cos * y];
        pixels[(32.0 - y).round() as usize * 65 + (32.0 + x).round() as usize]
    };
    let asked = [[5.0, 0.0], [0.0, 5.0], [-5.0, 0.0], [0.0, -5.0], [7.0, 7.0], [-7.0, 7.0]];
    asked.map(|[x, y]| at(x, y)).to_vec()
}

#[test]
fn a_rolled_quad_changes_its_colours_along_rows_and_not_in_perspective() {
    let quarter = |interpolation| {
        let (before, after) = (rolled(interpolation, 0.0), rolled(interpolation, 90.0));
        largest_difference(&before, &after)
    };
    // By a right angle pixels fall on pixels, and colours may be compared exactly.
    assert!(quarter(Interpolation::Perspective) <= 1);
    assert!(quarter(Interpolation::Scanline) <= 1, "rows and columns give the same in a square");
    let eighth = |interpolation| {
        let (before, after) = (rolled(interpolation, 0.0), rolled(interpolation, 45.0));
        largest_difference(&before, &after)
    };
    // Half a pixel aside is a few steps; rows that change their ends are many.
    let (right, along_rows) = (eighth(Interpolation::Perspective), eighth(Interpolation::Scanline));
    assert!(along_rows > right + 20, "{along_rows} and {right}");
}

#[test]
fn rolled_by_45_degrees_a_quad_keeps_its_colours_in_perspective_to_a_step() {
    // Asked at the places themselves, not at the pixels next to them.
    let colors = |interpolation, degrees: f64| -> Vec<[u8; 4]> {
        let mut mesh = square(0.0);
        mesh.colors =
            vec![[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0], [1.0; 4]];
        let mut scene = scene(vec![(mesh, matte([1.0; 3]))]);
        scene.nodes[0].parent_from_node = DMat4::from_rotation_z(degrees.to_radians()).into();
        let shading = Shading {
            mode: ShadingMode::Gouraud,
            interpolation,
            clamp: Clamp::Vertex,
            ..Shading::default()
        };
        let view = view(64).with_shading(shading);
        let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let mut told = Vec::new();
        for (x, y) in [(9.0, 1.0), (-3.0, 12.0), (5.0, -7.0), (-11.0, -10.0), (12.0, 12.0)] {
            let [x, y] = [cos * x - sin * y, sin * x + cos * y];
            let at = At::Point([32.0 + x, 32.0 - y]);
            told.push(renderer.explain(&view, at).unwrap().rgba8);
        }
        told
    };
    let changed = |interpolation| {
        largest_difference(&colors(interpolation, 0.0), &colors(interpolation, 45.0))
    };
    assert!(changed(Interpolation::Perspective) <= 1);
    assert!(changed(Interpolation::Scanline) > 10);
}

#[test]
fn scanlines_run_between_the_edges_of_the_quad_and_not_of_its_triangles() {
    // In the middle of an upright square all corners weigh the same, which no diagonal gives.
    let mut mesh = square(0.0);
    mesh.colors = vec![[1.0, 0.0, 0.0, 1.0], [0.0; 4], [0.0; 4], [0.0; 4]];
    let scene = scene(vec![(mesh, matte([1.0; 3]))]);
    let red = |interpolation| {
        let shading = Shading { mode: ShadingMode::Gouraud, interpolation, ..Shading::default() };
        linear(&scene, &view(65).with_shading(shading))[32 * 65 + 32][0]
    };
    assert!((red(Interpolation::Scanline) - 0.25).abs() < 1e-5);
    assert!((red(Interpolation::Perspective) - 0.5).abs() < 1e-5);
}

#[test]
fn intensities_are_clamped_at_the_corners_unless_it_is_said_otherwise() {
    // Light 4 on one corner and 0 on the others: half of it is 2 along the edge, or 1 / 2.
    let mut mesh = square(0.0);
    mesh.colors = vec![[4.0, 4.0, 4.0, 1.0], [0.0; 4], [0.0; 4], [0.0; 4]];
    let scene = scene(vec![(mesh, matte([1.0; 3]))]);
    let middle = |clamp| {
        let shading = Shading { mode: ShadingMode::Gouraud, clamp, ..Shading::default() };

        linear(&scene, &view(65).with_shading(shading))[32 * 65 + 32][0]
    };
    assert!((middle(Clamp::Vertex) - 0.5).abs() < 1e-5);
    assert!((middle(Clamp::End) - 2.0).abs() < 1e-5);
}

#[test]
fn screen_interpolation_is_perspective_where_nothing_recedes_and_differs_where_it_does() {
    let scene = sheet();
    let of = |interpolation| {
        let mode = ShadingMode::Gouraud;
        let shading = Shading { interpolation, mode, ..Shading::default() };
        bytes(&scene, &sheet_view(ShadingMode::Gouraud).with_shading(shading))
    };
    let slid = largest_difference(&of(Interpolation::Screen), &of(Interpolation::Perspective));
    assert!(slid > 0 && slid < 60, "{slid}");
    let flat = largest_difference(
        &rolled(Interpolation::Screen, 0.0),
        &rolled(Interpolation::Perspective, 0.0),
    );
    assert!(flat <= 1, "{flat}");
}

#[test]
fn normals_that_keep_their_interpolated_length_darken_the_middle_by_just_that() {
    // Normals at both sides turned away by 45 degrees: between them their mean is 0.7071 long.
    let mut mesh = square(0.0);
    let slant = std::f32::consts::FRAC_1_SQRT_2;
    let [left, right] = [[-slant, 0.0, slant], [slant, 0.0, slant]];
    mesh.normals = vec![left, right, right, left];
    let scene = scene(vec![(mesh, matte([1.0; 3]))]);
    let view_of = |normal_length| {
        let shading = Shading { normal_length, ..Shading::default() };
        view(65).with_shading(shading)
    };
    let middle = |view: &View| linear(&scene, view)[32 * 65 + 32][0];
    assert!((middle(&view_of(NormalLength::Unit)) - 1.0).abs() < 1e-5);
    let short = view_of(NormalLength::Interpolated);
    assert!((middle(&short) - slant).abs() < 1e-5);
    // What is explained is what was drawn.
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let picture = bytes(&scene, &short);
    for x in [18, 25, 32, 40, 46] {
        let explained = renderer.explain(&short, At::Pixel([x, 32])).unwrap();
        assert_eq!(explained.rgba8, picture[32 * 65 + x as usize]);
    }
}
