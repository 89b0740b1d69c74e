//! Smooth points, lines and polygons (sections 3.3, 3.4.2 and 3.5), and points and lines of several samples (sections
//! 3.3.1 and 3.4.4).

use crate::canvas::{canvas, draw, gl, pixels};
use luxel_gl::Context;

const POINT_SMOOTH: u32 = 0x0b10;
const LINE_SMOOTH: u32 = 0x0b20;
const POLYGON_SMOOTH: u32 = 0x0b41;
const LINE_STIPPLE: u32 = 0x0b24;
const SRC_ALPHA: u32 = 0x0302;
const ONE_MINUS_SRC_ALPHA: u32 = 0x0303;
const SRC_ALPHA_SATURATE: u32 = 0x0308;
const ONE: u32 = 1;
const FRAMEBUFFER: u32 = 0x8d40;
const RENDERBUFFER: u32 = 0x8d41;
const SIDE: usize = 16;

/// A context in which the parts of pixels that are covered add up as brightness.
fn space() -> Context {
    let mut context = canvas(SIDE as u32, SIDE as u32);
    context.enable(POINT_SMOOTH);
    context.enable(LINE_SMOOTH);
    context.enable(POLYGON_SMOOTH);
    context.enable(gl::BLEND);
    context.blend_func(SRC_ALPHA, ONE);
    context
}

/// The red of all pixels, from 0 to 1.
fn parts(context: &mut Context) -> Vec<f64> {
    pixels(context).iter().map(|pixel| f64::from(pixel[0]) / 255.0).collect()
}

#[test]
fn section_3_4_2_alphas_are_the_parts_of_pixels_that_a_line_covers() {
    let mut context = space();
    context.line_width(3.0);
    draw(&mut context, gl::LINES, &[[2.25, 8.0, 0.0], [13.0, 8.0, 0.0]]);
    let found = parts(&mut context);
    for (at, part) in found.iter().enumerate() {
        let (x, y) = (at % SIDE, at / SIDE);
        let across = [(6, 0.5), (7, 1.0), (8, 1.0), (9, 0.5)];
        let across = across.iter().find(|(row, _)| *row == y).map_or(0.0, |(_, part)| *part);
        let along = if x == 2 { 0.75 } else { f64::from(u8::from((3..13).contains(&x))) };
        assert!((part - along * across).abs() < 0.004, "{part} at {x}, {y}");
    }
    // Of any direction and width the parts add up to the area.
    for (end, width) in [([12.0, 9.5], 1.0), ([7.25, 14.0], 2.5), ([3.0, 12.0], 4.0)] {
        let mut context = space();
        context.line_width(width);
        draw(&mut context, gl::LINES, &[[4.0, 4.0, 0.0], [end[0], end[1], 0.0]]);
        let sum: f64 = parts(&mut context).iter().sum();
        let length = f64::from(end[0] - 4.0).hypot(f64::from(end[1] - 4.0));
        assert!((sum - length * f64::from(width)).abs() < 0.1, "{sum} of {length} times {width}");
    }
}

#[test]
fn section_3_3_alphas_are_the_parts_of_pixels_that_a_disc_covers() {
    for size in [1.0, 3.5, 8.0_f32] {
        let mut context = space();
        context.point_size(size);
        draw(&mut context, gl::POINTS, &[[8.2, 7.6, 0.0]]);
        let found = parts(&mut context);
        let sum: f64 = found.iter().sum();
        let area = std::f64::consts::PI * f64::from(size * size) / 4.0;
        assert!((sum - area).abs() < 0.02 * area + 0.02, "{sum} of {area}");
        let [x, y] = [8.2, 7.6].map(|at| (at - size / 2.0) as usize);
        let corner = found[y * SIDE + x];
        assert!(size < 3.0 || corner < 0.5, "a disc has no corners: {corner}");
    }
}

#[test]
fn section_3_4_2_smooth_lines_have_colours_depths_and_stipples() {
    let mut context = space();
    context.enable(gl::DEPTH_TEST);
    context.disable(gl::BLEND);
    context.line_width(2.0);
    context.begin(gl::LINES);
    context.color([0.0, 0.0, 0.0, 1.0]);
    context.vertex([0.0, 8.0, 0.5, 1.0]);
    context.color([1.0, 0.0, 0.0, 1.0]);
    context.vertex([16.0, 8.0, -0.5, 1.0]);
    context.end();
    let found = parts(&mut context);
    let depths = crate::canvas::depths(&mut context);
    for x in 0..SIDE {
        let expected = (x as f64 + 0.5) / 16.0;
        assert!((found[8 * SIDE + x] - expected).abs() < 0.005);
        assert!((f64::from(depths[8 * SIDE + x]) - (0.25 + expected / 2.0)).abs() < 1e-6);
    }
    let mut context = space();
    context.enable(LINE_STIPPLE);
    context.line_stipple(2, 0x5555);
    context.line_width(2.0);
    draw(&mut context, gl::LINES, &[[0.0, 8.0, 0.0], [16.0, 8.0, 0.0]]);
    let found = parts(&mut context);
    let row: Vec<bool> = found[8 * SIDE..9 * SIDE].iter().map(|part| *part > 0.0).collect();
    assert!((0..SIDE).all(|x| row[x] == (x / 2 % 2 == 0)), "{row:?}");
}

#[test]
fn sections_3_3_1_and_3_4_4_samples_within_the_figures_are_covered() {
    // The mean of a pixel's four samples is about the part that is covered, whether smooth or not.
    for smooth in [false, true] {
        let mut context = canvas(SIDE as u32, SIDE as u32);
        let plane = context.gen_renderbuffers(1)[0];
        context.bind_renderbuffer(RENDERBUFFER, plane);
        context.renderbuffer_storage(RENDERBUFFER, 4, 0x8058, SIDE as i32, SIDE as i32);
        let object = context.gen_framebuffers(1)[0];
        context.bind_framebuffer(FRAMEBUFFER, object);
        context.framebuffer_renderbuffer(FRAMEBUFFER, 0x8ce0, RENDERBUFFER, plane);
        let switch = if smooth { Context::enable } else { Context::disable };
        switch(&mut context, POINT_SMOOTH);
        switch(&mut context, LINE_SMOOTH);
        let mut area = |work: &dyn Fn(&mut Context)| {
            context.bind_framebuffer(FRAMEBUFFER, object);
            context.clear(gl::COLOR_BUFFER_BIT);
            work(&mut context);
            context.bind_framebuffer(0x8ca9, 0);
            context.blit_framebuffer([0, 0, 16, 16], [0, 0, 16, 16], gl::COLOR_BUFFER_BIT, 0x2600);
            context.bind_framebuffer(FRAMEBUFFER, 0);
            parts(&mut context).iter().sum::<f64>()
        };
        let point = area(&|context| {
            context.point_size(7.5);
            draw(context, gl::POINTS, &[[8.0, 8.0, 0.0]]);
        });
        let expected = if smooth { 44.2 } else { 56.25 };
        assert!((point - expected).abs() < 2.0, "{point} instead of {expected}");
        let line = area(&|context| {
            context.line_width(2.5);
            draw(context, gl::LINES, &[[2.0, 3.0, 0.0], [13.0, 11.0, 0.0]]);
        });
        assert!((line - 2.5 * 13.6).abs() < 2.0, "{line}");
    }
}

/// A pentagon about (8, 8), of that radius, turned a little.
fn pentagon(radius: f32) -> Vec<[f32; 3]> {
    let corners = [
        [0.9553, 0.2955],
        [0.0142, 0.9999],
        [-0.9466, 0.3225],
        [-0.5992, -0.8006],
        [0.5763, -0.8173],
    ];
    corners.map(|[x, y]: [f32; 2]| [8.0 + radius * x, 8.0 + radius * y, 0.0]).to_vec()
}

/// The area of a polygon.
fn area(corners: &[[f32; 3]]) -> f64 {
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    let doubled: f64 = pairs
        .map(|(a, b)| f64::from(a[0]) * f64::from(b[1]) - f64::from(b[0]) * f64::from(a[1]))
        .sum();
    (doubled / 2.0).abs()
}

#[test]
fn section_3_5_alphas_are_the_parts_of_pixels_that_a_polygon_covers() {
    let mut corners = pentagon(6.5);
    for turned in [false, true] {
        let mut context = space();
        draw(&mut context, gl::POLYGON, &corners);
        let sum: f64 = parts(&mut context).iter().sum();
        assert!(
            (sum - area(&corners)).abs() < 0.2,
            "{sum} of {}, turned: {turned}",
            area(&corners)
        );
        corners.reverse();
    }
    let square = [[2.25, 3.0, 0.0], [12.0, 3.0, 0.0], [12.0, 9.5, 0.0], [2.25, 9.5, 0.0]];
    let mut context = space();
    draw(&mut context, gl::QUADS, &square);
    for (at, part) in parts(&mut context).iter().enumerate() {
        let (x, y) = (at % SIDE, at / SIDE);
        let across = if x == 2 { 0.75 } else { f64::from(u8::from((3..12).contains(&x))) };
        let up = if y == 9 { 0.5 } else { f64::from(u8::from((3..9).contains(&y))) };
        assert!((part - across * up).abs() < 0.004, "{part} at {x}, {y}");
    }
    // Thinner than a pixel.
    let sliver = [[1.0, 2.0, 0.0], [14.0, 10.2, 0.0], [14.0, 10.6, 0.0]];
    let mut context = space();
    draw(&mut context, gl::TRIANGLES, &sliver);
    let sum: f64 = parts(&mut context).iter().sum();
    assert!((sum - area(&sliver)).abs() < 0.1, "{sum} of {}", area(&sliver));
}

#[test]
fn section_3_5_diagonals_of_a_smooth_polygon_are_seams() {
    let corners = pentagon(7.0);
    let drawn = |is_smooth: bool| {
        let mut context = space();
        context.blend_func(SRC_ALPHA, ONE_MINUS_SRC_ALPHA);
        if !is_smooth {
            context.disable(POLYGON_SMOOTH);
        }
        context.enable(gl::DEPTH_TEST);
        context.begin(gl::POLYGON);
        for [x, y, _] in &corners {
            context.color([x / 16.0, y / 16.0, 0.5, 1.0]);
            context.vertex([*x, *y, x / 16.0, 1.0]);
        }
        context.end();
        (pixels(&mut context), crate::canvas::depths(&mut context))
    };
    let ((smooth, depths), (plain, plain_depths)) = (drawn(true), drawn(false));
    let mut inside = 0;
    for (at, pixel) in plain.iter().enumerate() {
        let from_middle = (at % SIDE) as f32 + 0.5 - 8.0;
        let away = from_middle.hypot((at / SIDE) as f32 + 0.5 - 8.0);
        if away < 7.0 * 0.8 - 0.72 {
            inside += 1;
            assert_eq!((smooth[at], depths[at]), (*pixel, plain_depths[at]), "at {at}");
        }
    }
    assert!(inside > 60);
}

#[test]
fn section_3_5_neighbours_add_up_where_alpha_saturates() {
    let mut context = space();
    context.clear_color([0.0; 4]);
    context.clear(gl::COLOR_BUFFER_BIT);
    context.blend_func(SRC_ALPHA_SATURATE, ONE);
    let corners = pentagon(7.0);
    for number in 0..5 {
        let triangle = [[8.1, 7.7, 0.0], corners[number], corners[(number + 1) % 5]];
        draw(&mut context, gl::TRIANGLES, &triangle);
    }
    let found = parts(&mut context);
    let sum: f64 = found.iter().sum();
    assert!((sum - area(&corners)).abs() < 1.0, "{sum} of {}", area(&corners));
    assert!((4..12).all(|y| (4..12).all(|x| found[y * SIDE + x] > 0.97)), "seams");
}

#[test]
fn section_2_11_clipped_smooth_polygons_lose_their_parts() {
    // Beyond z = 1 from the middle on.
    let mut context = space();
    let square = [[2.5, 3.0, 0.0], [13.5, 3.0, -2.0], [13.5, 9.0, -2.0], [2.5, 9.0, 0.0]];
    draw(&mut context, gl::QUADS, &square);
    let found = parts(&mut context);
    let sum: f64 = found.iter().sum();
    assert!((sum - 5.5 * 6.0).abs() < 0.2, "{sum}");
    assert!((found[5 * SIDE + 2] - 0.5).abs() < 0.004);
}
