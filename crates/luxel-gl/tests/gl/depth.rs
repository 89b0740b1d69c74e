//! Window depths (sections 2.10.1, 3.5.5, 4.1.6).

use crate::canvas::{canvas, depths, draw, gl, pixels};
use luxel_gl::Context;
use proptest::prelude::*;

/// One step of a buffer of 24 bits.
const STEP: f32 = 1.0 / 16_777_215.0;
const POLYGON_OFFSET_FILL: u32 = 0x8037;
const WHOLE: [[f32; 3]; 3] = [[-50.0, -50.0, 0.0], [50.0, -50.0, 0.0], [0.0, 90.0, 0.0]];

fn at_depth(z: f32) -> [[f32; 3]; 3] {
    WHOLE.map(|[x, y, _]| [x, y, z])
}

#[test]
fn section_4_1_6_each_comparison_passes_what_it_says() {
    // z is -1 at the far plane here: depth (1 - z) / 2.
    let passes = [
        (0x200, [false, false, false]),
        (0x201, [true, false, false]),
        (0x202, [false, true, false]),
        (0x203, [true, true, false]),
        (0x204, [false, false, true]),
        (0x205, [true, false, true]),
        (0x206, [false, true, true]),
        (0x207, [true, true, true]),
    ];
    for (func, expected) in passes {
        for (z, expected) in [0.5, 0.0, -0.5].into_iter().zip(expected) {
            let mut context = canvas(8, 8);
            context.enable(gl::DEPTH_TEST);
            draw(&mut context, gl::TRIANGLES, &at_depth(0.0));
            context.depth_func(func);
            context.color([1.0, 0.0, 0.0, 1.0]);
            draw(&mut context, gl::TRIANGLES, &at_depth(z));
            let seen = pixels(&mut context)[8 * 4 + 4] == [255, 0, 0, 255];
            assert_eq!(seen, expected, "{func:#x} at {z}");
            let depth = depths(&mut context)[8 * 4 + 4];
            let kept = if expected { (1.0 - z) * 0.5 } else { 0.5 };
            assert!((depth - kept).abs() < 2.0 * STEP, "{func:#x}: {depth}");
        }
    }
}

#[test]
fn section_4_1_6_without_test_or_mask_no_depth_is_written() {
    let mut context = canvas(8, 8);
    draw(&mut context, gl::TRIANGLES, &at_depth(0.5));
    context.enable(gl::DEPTH_TEST);
    context.depth_mask(false);
    draw(&mut context, gl::TRIANGLES, &at_depth(0.25));
    assert_eq!(depths(&mut context)[0], 1.0);
    context.clear_depth(0.25);
    context.clear(gl::DEPTH_BUFFER_BIT);
    assert_eq!(depths(&mut context)[0], 1.0);
    context.depth_mask(true);
    context.clear(gl::DEPTH_BUFFER_BIT);
    assert!((depths(&mut context)[0] - 0.25).abs() < STEP);
}

#[test]
fn section_2_10_1_depths_are_mapped_to_the_range_also_backwards() {
    for [near, far] in [[0.25, 0.75], [1.0, 0.0], [0.5, 0.5]] {
        let mut context = canvas(8, 8);
        context.enable(gl::DEPTH_TEST);
        context.depth_func(0x207);
        context.depth_range(near, far);
        draw(&mut context, gl::TRIANGLES, &at_depth(0.5));
        let expected = (near + (far - near) * 0.25) as f32;
        assert!((depths(&mut context)[0] - expected).abs() < 2.0 * STEP);
    }
}

#[test]
fn section_3_5_1_depth_is_linear_in_the_window() {
    let mut context = canvas(64, 64);
    context.enable(gl::DEPTH_TEST);
    // z = 0.9 - x / 64 - y / 128
    let z = |x: f32, y: f32| 0.9 - x / 64.0 - y / 128.0;
    let corner = |x: f32, y: f32| [x, y, z(x, y)];
    draw(&mut context, gl::TRIANGLES, &[corner(0.0, 0.0), corner(64.0, 0.0), corner(0.0, 64.0)]);
    let found = depths(&mut context);
    for y in 0..64 {
        for x in 0..63 - y {
            let expected = (1.0 - z(x as f32 + 0.5, y as f32 + 0.5)) * 0.5;
            assert!((found[y * 64 + x] - expected).abs() < 4.0 * STEP, "{x}, {y}");
        }
    }
}

#[test]
fn section_3_5_5_offset_moves_by_the_slope_and_by_steps() {
    let offset = |factor: f32, units: f32, slope: f32| {
        let mut context = canvas(64, 64);
        context.enable(gl::DEPTH_TEST);
        context.enable(POLYGON_OFFSET_FILL);
        context.polygon_offset(factor, units);
        let corner = |x: f32, y: f32| [x, y, -slope * x];
        let corners = [corner(0.0, 0.0), corner(64.0, 0.0), corner(0.0, 64.0)];
        draw(&mut context, gl::TRIANGLES, &corners);
        let moved = depths(&mut context)[64 * 8 + 8];
        let mut plain = canvas(64, 64);
        plain.enable(gl::DEPTH_TEST);
        draw(&mut plain, gl::TRIANGLES, &corners);
        moved - depths(&mut plain)[64 * 8 + 8]
    };
    assert!((offset(0.0, 100.0, 0.0) - 200.0 * STEP).abs() < 1.5 * STEP);
    assert!((offset(2.0, 0.0, 0.01) - 2.0 * 0.005).abs() < 8.0 * STEP);
    assert!((offset(-1.0, -5.0, 0.01) + 0.005 + 10.0 * STEP).abs() < 8.0 * STEP);
}

#[test]
fn section_4_1_6_two_passes_over_the_same_triangles_have_equal_depths() {
    let mut context = canvas(64, 64);
    context.matrix_mode(gl::PROJECTION);
    context.load_identity();
    context.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 50.0);
    context.enable(gl::DEPTH_TEST);
    // Some reach behind the eye, and are clipped.
    let corners: Vec<[f32; 3]> = (0..60)
        .map(|n| [(n * 7 % 13) as f32 - 6.0, (n * 5 % 11) as f32 - 5.0, (n % 9) as f32 - 7.0])
        .collect();
    for (func, color) in [(0x201, [1.0, 0.0, 0.0, 1.0]), (0x202, [0.0, 1.0, 0.0, 1.0])] {
        context.depth_func(func);
        context.color(color);
        draw(&mut context, gl::TRIANGLES, &corners);
    }
    let found = pixels(&mut context);
    assert!(!found.contains(&[255, 0, 0, 255]));
    assert!(found.iter().filter(|pixel| **pixel == [0, 255, 0, 255]).count() > 1000);
}

#[test]
fn section_3_5_5_whole_units_move_by_whole_steps_also_near_the_far_plane() {
    let drawn = |units: f32| {
        let mut context = canvas(64, 64);
        context.enable(gl::DEPTH_TEST);
        context.enable(POLYGON_OFFSET_FILL);
        context.polygon_offset(0.0, units);
        let corners = [[0.0, 0.0, -0.3], [64.0, 3.0, -0.9], [5.0, 64.0, -0.5]];
        draw(&mut context, gl::TRIANGLES, &corners);
        let mut depths = vec![0; 64 * 64];
        context.depth_plane(&mut depths);
        depths
    };
    let (plain, moved) = (drawn(0.0), drawn(-1.0));
    let drawn = plain.iter().zip(&moved).filter(|(plain, _)| **plain < 16_777_215);
    assert!(drawn.clone().count() > 1500);
    assert!(drawn.into_iter().all(|(plain, moved)| plain - moved == 2));
}

/// A triangle with its own state: how depths are compared, written and moved, and whether colours are.
#[derive(Clone, Debug)]
pub(crate) struct Drawn {
    corners: [[f32; 3]; 3],
    func: u32,
    writes: bool,
    colors: bool,
    moved: bool,
}

/// Triangles of a few pixels, most of them.
pub(crate) fn drawn() -> impl Strategy<Value = Drawn> {
    drawn_with(prop_oneof![4 => 0.1..3.0_f32, 2 => 3.0..10.0_f32, 1 => 10.0..90.0_f32])
}

/// Triangles of which many cover tiles.
pub(crate) fn drawn_large() -> impl Strategy<Value = Drawn> {
    drawn_with(60.0..600.0_f32)
}

/// Triangles of that size, in few depths: equally near ones are frequent.
fn drawn_with(size: impl Strategy<Value = f32>) -> impl Strategy<Value = Drawn> {
    let place = [0.0..100.0_f32, 0.0..70.0_f32];
    let corner = || ([-1.0..1.0_f32, -1.0..1.0_f32], -2..3_i32);
    let func = prop_oneof![6 => 0..4_u32, 1 => 4..12_u32];
    let rarely = || prop::bool::weighted(0.04);
    (
        place,
        size,
        [corner(), corner(), corner()],
        any::<bool>(),
        func,
        [rarely(), rarely(), rarely()],
    )
        .prop_map(|([x, y], size, corners, level, func, [keeps, hides, moved])| {
            let z = |z: i32| if level { 0.0 } else { z as f32 / 4.0 };
            let corner =
                |([dx, dy], depth): ([f32; 2], i32)| [x + dx * size, y + dy * size, z(depth)];
            // Most share one of four: runs of those that may wait.
            let func =
                [0x201, 0x203, 0x204, 0x206].get(func as usize).copied().unwrap_or(0x1fc + func);
            Drawn { corners: corners.map(corner), func, writes: !keeps, colors: !hides, moved }
        })
}

/// Draws them in turn, all in the colours of their numbers; with `waits` all are carried out together.
pub(crate) fn draw_all(context: &mut Context, all: &[Drawn], run: usize, waits: bool) {
    context.enable(gl::DEPTH_TEST);
    context.polygon_offset(0.0, 4000.0);
    for (number, of) in all.iter().enumerate() {
        // Runs of triangles have the first one's comparison.
        context.depth_func(all[number - number % run].func);
        context.depth_mask(of.writes);
        context.color_mask(of.colors, of.colors, of.colors, of.colors);
        if of.moved {
            context.enable(POLYGON_OFFSET_FILL);
        } else {
            context.disable(POLYGON_OFFSET_FILL);
        }
        let [low, high] = [number & 255, number >> 8].map(|byte| byte as f32 / 255.0);
        context.color([low, high, 1.0, 1.0]);
        draw(context, gl::TRIANGLES, &of.corners);
        if !waits {
            context.finish();
        }
    }
}

/// Clears the depth of a pixel of each tile, so that tiles have values of their own.
pub(crate) fn clear_parts_of_tiles(context: &mut Context, [width, height]: [usize; 2]) {
    context.enable(gl::SCISSOR_TEST);
    for y in (0..height).step_by(64) {
        for x in (0..width).step_by(64) {
            context.scissor(x as i32 + 5, y as i32 + 3, 1, 1);
            context.clear(gl::DEPTH_BUFFER_BIT);
        }
    }
    context.disable(gl::SCISSOR_TEST);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn section_4_1_6_triangles_that_are_drawn_together_hide_one_another_in_the_order_of_calls(
        all in prop::collection::vec(drawn(), 1..160), run in 1..64_usize, start in prop::sample::select(vec![0.0, 0.5, 1.0]),
    ) {
        let outcome = |waits: bool| {
            let mut context = canvas(100, 70);
            context.clear_depth(start);
            context.clear(gl::DEPTH_BUFFER_BIT);
            draw_all(&mut context, &all, run, waits);
            (pixels(&mut context), depths(&mut context))
        };
        prop_assert!(outcome(true) == outcome(false));
    }

    #[test]
    fn section_4_1_6_what_is_decided_about_a_whole_tile_is_as_pixel_by_pixel(
        all in prop::collection::vec(drawn_large(), 1..12), start in prop::sample::select(vec![0.0, 0.5, 1.0]),
        is_cut in any::<bool>(),
    ) {
        let outcome = |is_written: bool| {
            let mut context = canvas(200, 140);
            context.clear_depth(start);
            context.clear(gl::DEPTH_BUFFER_BIT);
            if is_written {
                clear_parts_of_tiles(&mut context, [200, 140]);
            }
            if is_cut {
                context.enable(gl::SCISSOR_TEST);
                context.scissor(30, 20, 120, 100);
            }
            draw_all(&mut context, &all, 1, true);
            (pixels(&mut context), depths(&mut context))
        };
        prop_assert!(outcome(true) == outcome(false));
    }
}
