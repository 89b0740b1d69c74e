//! Tests and blending of fragments (section 4.1), masks and clears (section 4.2), fog (section 3.10).

use crate::canvas::{canvas, draw, gl, pixels};
use luxel_gl::Context;

const WHOLE: [[f32; 3]; 3] = [[-50.0, -50.0, 0.0], [50.0, -50.0, 0.0], [0.0, 90.0, 0.0]];

/// The colour after drawing `source` over `destination`.
fn over(destination: [f32; 4], source: [f32; 4], set: impl Fn(&mut Context)) -> [u8; 4] {
    let mut context = canvas(8, 8);
    context.clear_color(destination);
    context.clear(gl::COLOR_BUFFER_BIT);
    context.color(source);
    set(&mut context);
    draw(&mut context, gl::TRIANGLES, &WHOLE);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    pixels(&mut context)[20]
}

const SOURCE: [f32; 4] = [0.8, 0.4, 0.2, 0.6];
const DESTINATION: [f32; 4] = [0.2, 0.6, 1.0, 0.4];

/// A factor's name, and its value for a channel.
type Factor = (u32, fn(usize) -> f32);

#[test]
fn section_4_1_7_factors_weigh_source_and_destination() {
    let factors: [Factor; 14] = [
        (0, |_| 0.0),
        (1, |_| 1.0),
        (0x0300, |at| SOURCE[at]),
        (0x0301, |at| 1.0 - SOURCE[at]),
        (0x0302, |_| SOURCE[3]),
        (0x0303, |_| 1.0 - SOURCE[3]),
        (0x0304, |_| DESTINATION[3]),
        (0x0305, |_| 1.0 - DESTINATION[3]),
        (0x0306, |at| DESTINATION[at]),
        (0x0307, |at| 1.0 - DESTINATION[at]),
        (0x8001, |at| [0.1, 0.3, 0.5, 0.7][at]),
        (0x8002, |at| 1.0 - [0.1, 0.3, 0.5, 0.7][at]),
        (0x8003, |_| 0.7),
        (0x8004, |_| 1.0 - 0.7),
    ];
    for (source, of_source) in factors {
        for (destination, of_destination) in factors {
            let found = over(DESTINATION, SOURCE, |context| {
                context.enable(gl::BLEND);
                context.blend_color([0.1, 0.3, 0.5, 0.7]);
                context.blend_func(source, destination);
            });
            for channel in 0..4 {
                let sum = SOURCE[channel] * of_source(channel)
                    + DESTINATION[channel] * of_destination(channel);
                let expected = sum.clamp(0.0, 1.0) * 255.0;
                let found = f32::from(found[channel]);
                assert!(
                    (found - expected).abs() < 1.5,
                    "{source:#x} {destination:#x}: {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn section_4_1_7_alpha_has_factors_of_its_own() {
    let with = |factors: [u32; 4]| {
        over(DESTINATION, SOURCE, |context| {
            let [source, destination, source_alpha, destination_alpha] = factors;
            context.enable(gl::BLEND);
            context.blend_func_separate(source, destination, source_alpha, destination_alpha);
        })
    };
    // ZERO and ONE beside SRC_ALPHA and ONE_MINUS_SRC_ALPHA.
    assert_eq!(with([1, 0, 0, 1]), [204, 102, 51, 102]);
    assert_eq!(with([0, 1, 1, 0]), [51, 153, 255, 153]);
    assert_eq!(with([0x0302, 0x0303, 1, 0]), [143, 122, 133, 153]);
    // SRC_ALPHA_SATURATE: min(A_s, 1 - A_d) for colours, 1 for alpha.
    assert_eq!(with([0x0308, 0, 0x0308, 0]), [122, 61, 31, 153]);
    assert_eq!(with([0x0308, 0, 0x0302, 0]), [122, 61, 31, 92]);
}

#[test]
fn section_4_1_7_equations_add_subtract_and_take_extremes() {
    let with = |equation| {
        over(DESTINATION, SOURCE, |context| {
            context.enable(gl::BLEND);
            context.blend_func(1, 1);
            context.blend_equation(equation);
        })
    };
    assert_eq!(with(0x8006), [255, 255, 255, 255]);
    assert_eq!(with(0x800A), [153, 0, 0, 51]);
    assert_eq!(with(0x800B), [0, 51, 204, 0]);
    assert_eq!(with(0x8007), [51, 102, 51, 102]);
    assert_eq!(with(0x8008), [204, 153, 255, 153]);
}

#[test]
fn section_4_1_10_logical_operations_act_on_bits() {
    let operations: [fn(u8, u8) -> u8; 16] = [
        |_, _| 0,
        |s, d| s & d,
        |s, d| s & !d,
        |s, _| s,
        |s, d| !s & d,
        |_, d| d,
        |s, d| s ^ d,
        |s, d| s | d,
        |s, d| !(s | d),
        |s, d| !(s ^ d),
        |_, d| !d,
        |s, d| s | !d,
        |s, _| !s,
        |s, d| !s | d,
        |s, d| !(s & d),
        |_, _| 255,
    ];
    let byte = |value: f32| (value * 255.0 + 0.5) as u8;
    for (number, operation) in (0x1500..).zip(operations) {
        let found = over(DESTINATION, SOURCE, |context| {
            context.enable(0x0BF2);
            context.logic_op(number);
        });
        let expected: [u8; 4] =
            std::array::from_fn(|at| operation(byte(SOURCE[at]), byte(DESTINATION[at])));
        assert_eq!(found, expected, "{number:#x}");
    }
}

#[test]
fn section_4_1_4_the_alpha_test_compares_with_its_reference() {
    let passes = |func, reference| {
        over([0.0; 4], SOURCE, |context| {
            context.enable(0x0BC0);
            context.alpha_func(func, reference);
        }) != [0; 4]
    };
    let outcomes =
        |reference| (0x200..=0x207).map(|func| passes(func, reference)).collect::<Vec<_>>();
    assert_eq!(outcomes(0.7), [false, true, false, true, false, true, false, true]);
    assert_eq!(outcomes(0.5), [false, false, false, false, true, true, true, true]);
    assert_eq!(outcomes(0.6), [false, false, true, true, false, false, true, true]);
}

#[test]
fn section_4_2_2_masks_keep_channels_also_from_clears() {
    let mask = |context: &mut Context| context.color_mask(true, false, true, false);
    assert_eq!(over(DESTINATION, SOURCE, mask), [204, 153, 51, 102]);
    let mut context = canvas(8, 8);
    // What is drawn before the clear is lit before it.
    context.color([1.0, 1.0, 0.0, 1.0]);
    draw(&mut context, gl::TRIANGLES, &WHOLE);
    context.color_mask(true, false, true, false);
    context.clear_color([0.0, 0.0, 1.0, 0.0]);
    context.clear(gl::COLOR_BUFFER_BIT);
    assert_eq!(pixels(&mut context)[20], [0, 255, 255, 255]);
}

#[test]
fn section_4_1_2_the_scissor_box_bounds_draws_and_clears() {
    let mut context = canvas(80, 80);
    context.enable(gl::SCISSOR_TEST);
    context.scissor(3, 60, 70, 9);
    context.clear_color([0.0, 1.0, 0.0, 1.0]);
    context.clear(gl::COLOR_BUFFER_BIT);
    context.scissor(62, -5, 4, 100);
    draw(
        &mut context,
        gl::TRIANGLES,
        &[[-900.0, -900.0, 0.0], [900.0, -900.0, 0.0], [0.0, 900.0, 0.0]],
    );
    for (at, pixel) in (0..).zip(pixels(&mut context)) {
        let (x, y) = (at % 80, at / 80);
        let expected = if (62..66).contains(&x) {
            [255; 4]
        } else if (3..73).contains(&x) && (60..69).contains(&y) {
            [0, 255, 0, 255]
        } else {
            [0; 4]
        };
        assert_eq!(pixel, expected, "{x}, {y}");
    }
}

#[test]
fn section_3_10_fog_mixes_by_distance_or_by_coordinate() {
    let fogged = |mode: f32, source: f32| {
        let mut context = canvas(8, 8);
        context.enable(0x0B60);
        context.fog(0x0B65, &[mode]);
        context.fog(0x0B62, &[0.5]);
        context.fog(0x0B63, &[1.0]);
        context.fog(0x0B64, &[3.0]);
        context.fog(0x0B66, &[0.0, 0.0, 1.0, 0.0]);
        context.fog(0x8450, &[source]);
        context.color([1.0, 0.0, 0.0, 0.5]);
        context.fog_coord(2.5);
        draw(&mut context, gl::TRIANGLES, &WHOLE.map(|[x, y, _]| [x, y, -0.8]));
        pixels(&mut context)[20]
    };
    let expected =
        |factor: f32| [(factor * 255.0).round() as i32, ((1.0 - factor) * 255.0).round() as i32];
    let cases = [
        (9729.0, 33874.0, 1.0),
        (9729.0, 33873.0, 0.25),
        (2048.0, 33874.0, 0.670_32),
        (2048.0, 33873.0, 0.286_505),
        (2049.0, 33873.0, 0.209_611),
    ];
    for (mode, source, factor) in cases {
        let [r, _, b, a] = fogged(mode, source).map(i32::from);
        let [er, eb] = expected(factor);
        assert!((r - er).abs() <= 1 && (b - eb).abs() <= 1 && a == 128, "{mode} {source}: {r} {b}");
    }
}

#[test]
fn section_3_5_2_polygons_are_drawn_where_the_stipple_has_bits() {
    let mut context = canvas(64, 64);
    let pattern: Vec<u8> = (0..128_u32).map(|at| (at * 57 + 11) as u8).collect();
    context.polygon_stipple(&pattern);
    context.enable(0x0B42);
    draw(
        &mut context,
        gl::TRIANGLES,
        &[[-900.0, -900.0, 0.0], [900.0, -900.0, 0.0], [0.0, 900.0, 0.0]],
    );
    for (at, pixel) in (0..).zip(pixels(&mut context)) {
        let (x, y) = (at % 64 % 32, at / 64 % 32);
        let bit = pattern[y * 4 + x / 8] >> (7 - x % 8) & 1 == 1;
        assert_eq!(pixel == [255; 4], bit, "{x}, {y}");
    }
}

#[test]
fn section_4_1_5_stencils_count_and_bound() {
    let mut context = canvas(8, 8);
    context.enable(0x0B90);
    context.stencil_op(0x1E00, 0x1E00, 0x1E02);
    context.color_mask(false, false, false, false);
    for _ in 0..3 {
        draw(&mut context, gl::TRIANGLES, &WHOLE);
    }
    draw(&mut context, gl::TRIANGLES, &[[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]]);
    context.color_mask(true, true, true, true);
    context.stencil_op(0x1E00, 0x1E00, 0x1E00);
    context.stencil_func(0x202, 4, 0xff);
    draw(&mut context, gl::TRIANGLES, &WHOLE);
    let found = pixels(&mut context);
    assert_eq!([found[0], found[63]], [[255; 4], [0; 4]]);
    let mut values = [0; 64];
    context.read_pixels(0, 0, 8, 8, 0x1901, gl::UNSIGNED_BYTE, &mut values);
    assert_eq!([values[0], values[63]], [4, 3]);
}

#[test]
fn section_3_7_bitmaps_are_drawn_at_the_raster_position_which_moves() {
    let mut context = canvas(80, 20);
    context.color([1.0, 0.0, 0.0, 1.0]);
    context.raster_pos([60.5, 5.0, 0.0, 1.0]);
    // What is current later doesn't matter.
    context.color([0.0, 1.0, 0.0, 1.0]);
    let bits: Vec<u8> =
        [0x8001_u16, 0x4002, 0xffff].iter().flat_map(|row| row.to_be_bytes()).collect();
    context.pixel_store(0x0CF5, 1.0);
    assert_eq!(context.bitmap_bytes(16, 3), 6);
    context.new_list(1, gl::COMPILE);
    context.bitmap([16, 3], [2.0, -1.0], [9.0, 0.5], Some(&bits));
    context.end_list();
    context.call_list(1);
    let found = pixels(&mut context);
    for (at, pixel) in found.iter().enumerate() {
        let (x, y) = (at as i32 % 80 - 58, at as i32 / 80 - 6);
        let row =
            usize::try_from(y).ok().and_then(|y| [0x8001, 0x4002, 0xffff_u32].get(y).copied());
        let set = (0..16).contains(&x) && row.is_some_and(|row| row >> (15 - x) & 1 == 1);
        assert_eq!(*pixel, if set { [255, 0, 0, 255] } else { [0; 4] }, "{x}, {y}");
    }
    let position = context.get(0x0B07).unwrap();
    assert_eq!([position.to_f32(0), position.to_f32(1)], [69.5, 5.5]);
    context.bitmap([0, 0], [0.0; 2], [1.0, 1.0], None);
    context.bitmap([-1, 0], [0.0; 2], [1.0, 1.0], None);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
    assert_eq!(context.get(0x0B07).unwrap().to_f32(0), 70.5);
}
