//! Which pixels polygons, points and lines have (sections 3.3 to 3.5).

use crate::canvas::{canvas, draw, gl, pixels};
use luxel_gl::Context;
use proptest::prelude::*;

const SIDE: i32 = 24;

/// Pixels whose centre lies within a triangle, or on a left or bottom edge of it, in exact integers of 1/256 pixel.
fn oracle(corners: [[i32; 2]; 3]) -> Vec<bool> {
    let [a, mut b, mut c] = corners.map(|corner| corner.map(i64::from));
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if area < 0 {
        std::mem::swap(&mut b, &mut c);
    }
    let inside = |x: i32, y: i32| {
        let p = [x, y].map(|at| i64::from(at) * 256 + 128);
        area != 0
            && [[a, b], [b, c], [c, a]].iter().all(|[from, to]| {
                let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
                let side = dx * (p[1] - from[1]) - dy * (p[0] - from[0]);
                // Counter-clockwise with y up: left edges run down, bottom ones to the right.
                side > 0 || side == 0 && (dy < 0 || dy == 0 && dx > 0)
            })
    };
    (0..SIDE * SIDE).map(|at| inside(at % SIDE, at / SIDE)).collect()
}

fn corner() -> impl Strategy<Value = [i32; 2]> {
    // Often in the middle of pixels and between them, where ties are.
    let place = prop_oneof![
        -1000..7000_i32,
        (0..SIDE).prop_map(|at| at * 256 + 128),
        (0..SIDE).prop_map(|at| at * 256)
    ];
    [place.clone(), place]
}

fn covered(corners: [[i32; 2]; 3]) -> Vec<bool> {
    let mut context = canvas(SIDE as u32, SIDE as u32);
    let places = corners.map(|corner| {
        let [x, y] = corner.map(|at| at as f32 / 256.0);
        [x, y, 0.0]
    });
    draw(&mut context, gl::TRIANGLES, &places);
    pixels(&mut context).iter().map(|pixel| *pixel == [255; 4]).collect()
}

proptest! {
    #[test]
    fn section_3_5_1_a_triangle_has_the_pixels_of_an_exact_oracle(corners in [corner(), corner(), corner()]) {
        prop_assert_eq!(covered(corners), oracle(corners));
    }

    #[test]
    fn section_3_5_1_pixels_along_a_shared_edge_are_drawn_once(
        edge in [corner(), corner()], mut others in [corner(), corner()],
    ) {
        let side = |p: [i32; 2]| {
            let [a, b] = edge.map(|end| end.map(i64::from));
            (b[0] - a[0]) * (i64::from(p[1]) - a[1]) - (i64::from(p[0]) - a[0]) * (b[1] - a[1])
        };
        if side(others[0]).signum() * side(others[1]).signum() > 0 {
            // To the other side, through the edge's middle.
            others[1] = [0, 1].map(|axis| edge[0][axis] + edge[1][axis] - others[1][axis]);
        }
        let mut context = canvas(SIDE as u32, SIDE as u32);
        context.enable(gl::BLEND);
        context.blend_func(1, 1);
        context.color([0.25; 4]);
        for other in others {
            let places = [edge[0], edge[1], other]
                .map(|at| [at[0] as f32 / 256.0, at[1] as f32 / 256.0, 0.0]);
            draw(&mut context, gl::TRIANGLES, &places);
        }
        // 64, or nothing; twice would be 128.
        prop_assert!(pixels(&mut context).iter().all(|pixel| [0, 64].contains(&pixel[0])));
    }

    #[test]
    fn section_3_5_1_a_primitive_of_one_colour_has_it_beside_others(
        edge in [corner(), corner()], others in [corner(), corner()], color in any::<[u8; 4]>(),
        w in 1.0..9.0_f32, changes in any::<bool>(), mode in prop::sample::select(vec![gl::TRIANGLES, gl::LINES]),
    ) {
        let own = |context: &mut Context| {
            context.color(color.map(|byte| f32::from(byte) / 255.0));
            context.begin(mode);
            for ([x, y], w) in [edge[0], edge[1], others[0]].into_iter().zip([1.0, w, 1.0]) {
                context.vertex([x as f32 / 256.0 * w, y as f32 / 256.0 * w, 0.0, w]);
            }
            context.end();
        };
        let mut alone = canvas(SIDE as u32, SIDE as u32);
        own(&mut alone);
        let mut beside = canvas(SIDE as u32, SIDE as u32);
        beside.begin(gl::TRIANGLES);
        for (number, [x, y]) in [edge[0], edge[1], others[1]].into_iter().enumerate() {
            let part = if changes { number as f32 / 2.0 } else { 0.5 };
            beside.color([part, 0.5, 1.0 - part, 1.0]);
            beside.vertex([x as f32 / 256.0, y as f32 / 256.0, 0.0, 1.0]);
        }
        beside.end();
        own(&mut beside);
        let mut cleared = canvas(SIDE as u32, SIDE as u32);
        cleared.clear_color(color.map(|byte| 1.0 - (f32::from(byte) / 255.0).round()));
        cleared.clear(gl::COLOR_BUFFER_BIT);
        own(&mut cleared);
        let all = [&mut alone, &mut beside, &mut cleared].map(pixels);
        for ((alone, beside), cleared) in all[0].iter().zip(&all[1]).zip(&all[2]) {
            let is_own = *alone == color && *cleared == color;
            prop_assert!(is_own || *alone == [0; 4], "{alone:?}");
            prop_assert!(!is_own || *beside == color, "{beside:?}");
        }
    }
}

#[test]
fn section_3_3_points_are_squares_about_their_place() {
    for size in 1..8_i32 {
        let mut context = canvas(16, 16);
        context.point_size(size as f32);
        draw(&mut context, gl::POINTS, &[[8.2, 7.9, 0.0]]);
        let lit: Vec<[i32; 2]> = (0..256)
            .zip(pixels(&mut context))
            .filter(|(_, pixel)| *pixel == [255; 4])
            .map(|(at, _)| [at % 16, at / 16])
            .collect();
        assert_eq!(lit.len(), (size * size) as usize);
        // Odd sizes about the middle of pixel (8, 7), even ones about the corner (8, 8).
        let first = if size % 2 == 1 { [8 - size / 2, 7 - size / 2] } else { [8 - size / 2; 2] };
        assert_eq!(lit[0], first, "size {size}");
    }
}

#[test]
fn section_3_4_2_wide_lines_repeat_their_pixels_across_the_major_axis() {
    let mut context = canvas(16, 16);
    context.line_width(3.0);
    draw(&mut context, gl::LINES, &[[2.5, 8.5, 0.0], [10.5, 8.5, 0.0]]);
    let found = pixels(&mut context);
    for y in 0..16 {
        for x in 0..16 {
            let lit = (2..10).contains(&x) && (7..10).contains(&y);
            assert_eq!(found[y * 16 + x] == [255; 4], lit, "{x}, {y}");
        }
    }
}

#[test]
fn section_3_4_2_stipples_go_on_through_a_strip() {
    let mut context = canvas(16, 16);
    context.enable(0x0B24);
    context.line_stipple(2, 0b0011);
    draw(&mut context, gl::LINE_STRIP, &[[0.5, 2.5, 0.0], [5.5, 2.5, 0.0], [15.5, 2.5, 0.0]]);
    let row: Vec<bool> = (0..16).map(|x| pixels(&mut context)[2 * 16 + x] == [255; 4]).collect();
    // Two pixels a bit: bits 0 and 1, then fourteen of the pattern's zeros.
    let expected: Vec<bool> = (0..16).map(|x| x < 4).collect();
    assert_eq!(row, expected);
}

#[test]
fn section_2_11_and_3_5_the_viewport_bounds_polygons() {
    let mut context = canvas(64, 64);
    context.viewport(10, 20, 30, 8);
    draw(
        &mut context,
        gl::TRIANGLES,
        &[[-900.0, -900.0, 0.0], [900.0, -900.0, 0.0], [0.0, 9e5, 0.0]],
    );
    for (at, pixel) in (0..).zip(pixels(&mut context)) {
        let (x, y) = (at % 64, at / 64);
        let inside = (10..40).contains(&x) && (20..28).contains(&y);
        assert_eq!(pixel == [255; 4], inside, "{x}, {y}");
    }
}

#[test]
fn section_2_6_2_flat_colours_come_from_the_last_vertex_but_of_polygons_from_the_first() {
    for (mode, provoking) in [(gl::TRIANGLES, 2), (gl::QUADS, 3), (gl::POLYGON, 0)] {
        let mut context = canvas(8, 8);
        context.shade_model(0x1D00);
        context.begin(mode);
        let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
        for (number, [x, y]) in corners.into_iter().enumerate() {
            context.color([number as f32 / 3.0, 0.0, 0.0, 1.0]);
            context.vertex([x, y, 0.0, 1.0]);
        }
        context.end();
        let expected = [(provoking as f32 / 3.0 * 255.0).round() as u8, 0, 0, 255];
        assert_eq!(pixels(&mut context)[8 + 6], expected);
    }
}

/// A triangle of lines or points with a plane of the user at x = 8: what lies to its left stays.
fn cut_triangle(mode: u32) -> Vec<[u8; 4]> {
    let mut context = canvas(16, 16);
    context.clip_plane(0x3000, [-1.0, 0.0, 0.0, 8.5]);
    context.enable(0x3000);
    context.polygon_mode(0x0408, mode);
    draw(&mut context, gl::TRIANGLES, &[[2.5, 2.5, 0.0], [14.5, 2.5, 0.0], [2.5, 14.5, 0.0]]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    pixels(&mut context)
}

#[test]
fn section_2_11_clipping_makes_edges_along_the_users_planes() {
    let lines = cut_triangle(0x1B01);
    let is_drawn = |at: [usize; 2]| lines[at[1] * 16 + at[0]] != [0; 4];
    let column = (2..9).filter(|y| is_drawn([8, *y])).count();
    assert!(column >= 5, "the edge along the plane has {column} pixels");
    assert!(is_drawn([2, 5]) && is_drawn([5, 2]) && !is_drawn([11, 2]) && !is_drawn([5, 5]));
    let points = cut_triangle(0x1B00);
    let drawn: Vec<usize> = (0..256).filter(|at| points[*at] != [0; 4]).collect();
    assert_eq!(drawn, [2 * 16 + 2, 2 * 16 + 8, 8 * 16 + 8, 14 * 16 + 2]);
}

#[test]
fn section_2_11_lines_of_polygons_end_at_the_sides_of_the_window() {
    let mut context = canvas(16, 16);
    context.polygon_mode(0x0408, 0x1B01);
    draw(&mut context, gl::TRIANGLES, &[[-8.0, 4.5, 0.0], [24.0, 4.5, 0.0], [8.0, 40.0, 0.0]]);
    let drawn = pixels(&mut context);
    let row = (0..16).filter(|x| drawn[4 * 16 + x] != [0; 4]).count();
    assert!(row >= 15, "{row}");
    let side = (6..9).filter(|y| drawn[y * 16] != [0; 4]).count();
    assert_eq!(side, 0, "no edge goes along the window's side");
}

#[test]
fn section_3_5_quads_that_are_clipped_are_split_as_those_of_lists() {
    let quad = |context: &mut Context, reach: f32| {
        context.begin(gl::QUADS);
        let corners = [[0.0, 0.0], [reach, 0.0], [16.0, 16.0], [0.0, 16.0]];
        for (number, [x, y]) in corners.into_iter().enumerate() {
            context.color([(number % 2) as f32, 0.0, 0.0, 1.0]);
            context.vertex([x, y, 0.0, 1.0]);
        }
        context.end();
    };
    let centre = |reach: f32, listed: bool| {
        let mut context = canvas(16, 16);
        if listed {
            context.new_list(1, gl::COMPILE);
            quad(&mut context, reach);
            context.end_list();
            context.call_list(1);
        } else {
            quad(&mut context, reach);
        }
        pixels(&mut context)[8 * 16 + 8][0]
    };
    assert!(centre(16.0, false) < 40 && centre(16.0, true) > 215);
    assert_eq!(centre(17.0, false), centre(17.0, true));
}
