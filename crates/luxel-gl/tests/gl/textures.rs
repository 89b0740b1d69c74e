//! Section 3.8: textures.

use crate::canvas::{canvas, gl, pixels};
use luxel_gl::Context;

const TEXTURE_2D: u32 = 0x0DE1;
const MIN_FILTER: u32 = 0x2801;
const MAG_FILTER: u32 = 0x2800;
const NEAREST: u32 = 0x2600;
const LINEAR_MIPMAP_LINEAR: u32 = 0x2703;
const TEXTURE_ENV: u32 = 0x2300;
const ENV_MODE: u32 = 0x2200;
const ENV_COLOR: u32 = 0x2201;
const REPLACE: u32 = 0x1E01;
const LUMINANCE: u32 = 0x1909;

/// Specifies a square image of bytes of red, green, blue and alpha.
fn image(context: &mut Context, level: i32, internal: u32, side: i32, texels: &[[u8; 4]]) {
    let (internal, size) = (internal as i32, [side; 2]);
    let bytes = texels.as_flattened();
    context.tex_image_2d(
        TEXTURE_2D,
        level,
        internal,
        size,
        0,
        gl::RGBA,
        gl::UNSIGNED_BYTE,
        Some(bytes),
    );
}

/// A square of `side` pixels with coordinates from 0 to `reach`.
fn square(context: &mut Context, side: f32, reach: f32) {
    context.begin(gl::QUADS);
    for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        context.tex_coord(0x84C0, [x * reach, y * reach, 0.0, 1.0]);
        context.vertex([x * side, y * side, 0.0, 1.0]);
    }
    context.end();
}

fn textured(side: u32) -> Context {
    let mut context = canvas(side, side);
    context.enable(TEXTURE_2D);
    context.tex_parameter(TEXTURE_2D, MIN_FILTER, &[NEAREST as f32]);
    context.tex_parameter(TEXTURE_2D, MAG_FILTER, &[NEAREST as f32]);
    context.tex_env(TEXTURE_ENV, ENV_MODE, &[REPLACE as f32]);
    context
}

#[test]
fn section_3_8_1_the_first_texel_is_the_lower_left_one() {
    let mut context = textured(2);
    let texels = [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [13, 14, 15, 16]];
    image(&mut context, 0, gl::RGBA, 2, &texels);
    square(&mut context, 2.0, 1.0);
    assert_eq!(pixels(&mut context), texels);
}

#[test]
fn section_3_8_8_the_level_of_detail_is_the_logarithm_of_the_longer_side_of_a_pixel() {
    // Level n has luminance 30 n, so that the picture holds lambda.
    let mut context = canvas(64, 48);
    context.enable(TEXTURE_2D);
    context.tex_parameter(TEXTURE_2D, MIN_FILTER, &[LINEAR_MIPMAP_LINEAR as f32]);
    context.tex_env(TEXTURE_ENV, ENV_MODE, &[REPLACE as f32]);
    for level in 0..9_u8 {
        let side = 256 >> level;
        let texels = vec![[30 * level, 0, 0, 255]; side * side];
        image(&mut context, i32::from(level), gl::RGBA, side as i32, &texels);
    }
    // A floor in perspective.
    context.matrix_mode(gl::PROJECTION);
    context.load_identity();
    let corners = [
        ([-5.0, -1.0, 1.0], [0.0, 0.0]),
        ([5.0, -1.0, 1.0], [1.0, 0.0]),
        ([5.0, 2.5, 5.0], [1.0, 3.0]),
        ([-5.0, 2.5, 5.0], [0.0, 3.0]),
    ];
    context.begin(gl::QUADS);
    for ([x, y, w], [s, t]) in corners {
        context.tex_coord(0x84C0, [s, t, 0.0, 1.0]);
        context.vertex([x, y, 0.0, w]);
    }
    context.end();
    let coordinates = |px: f64, py: f64| {
        let (x, y) = (px / 32.0 - 1.0, py / 24.0 - 1.0);
        // With a from 0 to 1 up the floor: y_c = -1 + 3.5 a, w = 1 + 4 a, y = y_c / w; x_c = 5 (2 s - 1).
        let a = (y + 1.0) / (3.5 - 4.0 * y);
        (x * (1.0 + 4.0 * a) / 10.0 + 0.5, 3.0 * a)
    };
    let picture = pixels(&mut context);
    let mut compared = 0;
    for row in 0..30 {
        for column in 0..64 {
            let (px, py) = (f64::from(column) + 0.5, f64::from(row) + 0.5);
            let (s, t) = coordinates(px, py);
            let side = |(to_s, to_t): (f64, f64)| {
                let (ds, dt) = ((to_s - s) * 256.0, (to_t - t) * 256.0);
                (ds * ds + dt * dt).sqrt()
            };
            let rho = side(coordinates(px + 1.0, py)).max(side(coordinates(px, py + 1.0)));
            let expected = 30.0 * libm::log2(rho).clamp(0.0, 8.0);
            let actual = f64::from(picture[row as usize * 64 + column as usize][0]);
            assert!((actual - expected).abs() < 1.0, "{column} {row}: {actual} for {expected}");
            compared += 1;
        }
    }
    assert_eq!(compared, 30 * 64);
}

#[test]
fn section_3_8_13_environments_are_those_of_the_tables_for_every_base_format() {
    const MODULATE: u32 = 0x2100;
    const DECAL: u32 = 0x2101;
    const BLEND: u32 = 0x0BE2;
    const ADD: u32 = 0x0104;
    const ALPHA: u32 = 0x1906;
    const RGB: u32 = 0x1907;
    const LUMINANCE_ALPHA: u32 = 0x190A;
    const INTENSITY: u32 = 0x8049;
    let texel = [200_u8, 90, 40, 150];
    let fragment = [0.8, 0.6, 0.3, 0.7];
    let constant = [0.1, 0.9, 0.5, 0.4];
    let unit = texel.map(|byte| f64::from(byte) / 255.0);
    let mut compared = 0;
    for format in [ALPHA, LUMINANCE, LUMINANCE_ALPHA, INTENSITY, RGB, gl::RGBA] {
        // Colour and alpha of the texel; `None` where the format has none.
        let (color, alpha) = match format {
            ALPHA => (None, Some(unit[3])),
            LUMINANCE => (Some([unit[0]; 3]), None),
            LUMINANCE_ALPHA => (Some([unit[0]; 3]), Some(unit[3])),
            INTENSITY => (Some([unit[0]; 3]), Some(unit[0])),
            RGB => (Some([unit[0], unit[1], unit[2]]), None),
            _ => (Some([unit[0], unit[1], unit[2]]), Some(unit[3])),
        };
        for mode in [REPLACE, MODULATE, DECAL, BLEND, ADD] {
            if mode == DECAL && format != RGB && format != gl::RGBA {
                continue;
            }
            let mut context = textured(1);
            context.tex_env(TEXTURE_ENV, ENV_MODE, &[mode as f32]);
            context.tex_env(TEXTURE_ENV, ENV_COLOR, &constant.map(|value: f64| value as f32));
            image(&mut context, 0, format, 1, &[texel]);
            context.color(fragment.map(|value: f64| value as f32));
            square(&mut context, 1.0, 1.0);
            let mut expected = fragment;
            for channel in 0..3 {
                let (f, Some(t), c) =
                    (fragment[channel], color.map(|color| color[channel]), constant[channel])
                else {
                    continue;
                };
                expected[channel] = match mode {
                    REPLACE => t,
                    MODULATE => f * t,
                    DECAL => f * (1.0 - alpha.unwrap_or(1.0)) + t * alpha.unwrap_or(1.0),
                    BLEND => f * (1.0 - t) + c * t,
                    _ => (f + t).min(1.0),
                };
            }
            if let Some(a) = alpha {
                let f = fragment[3];
                expected[3] = match mode {
                    REPLACE => a,
                    DECAL => f,
                    BLEND if format == INTENSITY => f * (1.0 - a) + constant[3] * a,
                    ADD if format == INTENSITY => (f + a).min(1.0),
                    _ => f * a,
                };
            }
            let actual = pixels(&mut context)[0].map(f64::from);
            for channel in 0..4 {
                let error = (actual[channel] - 255.0 * expected[channel]).abs();
                assert!(error < 0.51, "{format:#x} {mode:#x}: {actual:?} for {expected:?}");
            }
            compared += 1;
        }
    }
    assert_eq!(compared, 26);
}

#[test]
fn section_3_8_12_a_texture_that_a_draw_waits_with_keeps_its_image() {
    let mut context = textured(1);
    image(&mut context, 0, gl::RGBA, 1, &[[10, 20, 30, 40]]);
    square(&mut context, 1.0, 1.0);
    // Nothing has been looked at: the draw waits.
    let bytes = [90, 90, 90, 90];
    let (format, data_type) = (gl::RGBA, gl::UNSIGNED_BYTE);
    context.tex_sub_image(2, TEXTURE_2D, 0, [0; 3], [1; 3], format, data_type, &bytes);
    assert_eq!(pixels(&mut context), [[10, 20, 30, 40]]);
    square(&mut context, 1.0, 1.0);
    assert_eq!(pixels(&mut context), [bytes]);
}

#[test]
fn section_3_8_15_the_target_of_most_dimensions_counts() {
    let mut context = textured(1);
    image(&mut context, 0, gl::RGBA, 1, &[[10, 20, 30, 40]]);
    let line = Some(&[1, 2, 3, 4][..]);
    context.tex_image_1d(0x0DE0, 0, 4, 1, 0, gl::RGBA, gl::UNSIGNED_BYTE, line);
    context.tex_parameter(0x0DE0, MIN_FILTER, &[NEAREST as f32]);
    context.enable(0x0DE0);
    square(&mut context, 1.0, 1.0);
    assert_eq!(pixels(&mut context), [[10, 20, 30, 40]]);
    context.disable(TEXTURE_2D);
    square(&mut context, 1.0, 1.0);
    assert_eq!(pixels(&mut context), [[1, 2, 3, 4]]);
}

#[test]
fn section_6_1_4_an_image_comes_back_in_the_layout_that_is_set() {
    let mut context = textured(1);
    let texels: Vec<[u8; 4]> = (0..4).map(|at| [at, 50 + at, 100 + at, 150 + at]).collect();
    image(&mut context, 0, gl::RGBA, 2, &texels);
    context.pixel_store(0x0D05, 8.0);
    context.pixel_store(0x0D04, 1.0);
    let (bgr, bytes) = (0x80E0, gl::UNSIGNED_BYTE);
    let length = context.get_tex_image_bytes(TEXTURE_2D, 0, bgr, bytes);
    assert_eq!(length, 3 + 8 + 6);
    let mut out = vec![255; length];
    context.get_tex_image(TEXTURE_2D, 0, bgr, bytes, &mut out);
    assert_eq!(out[3..9], [100, 50, 0, 101, 51, 1]);
    assert_eq!(out[11..], [102, 52, 2, 103, 53, 3]);
    assert_eq!(out[..3], [255; 3]);
}

#[test]
fn section_5_4_lists_keep_pixels_and_leave_out_proxies() {
    let mut context = textured(1);
    context.new_list(1, gl::COMPILE);
    image(&mut context, 0, gl::RGBA, 1, &[[7, 8, 9, 10]]);
    let proxy = 0x8064;
    context.tex_image_2d(proxy, 0, 4, [4; 2], 0, gl::RGBA, gl::UNSIGNED_BYTE, None);
    context.end_list();
    let width = context.get_tex_level_parameter(proxy, 0, 0x1000).unwrap();
    assert_eq!(width.to_i32(0), 4, "a proxy is executed at once");
    assert_eq!(context.get_tex_level_parameter(TEXTURE_2D, 0, 0x1000).unwrap().to_i32(0), 0);
    context.call_list(1);
    square(&mut context, 1.0, 1.0);
    assert_eq!(pixels(&mut context), [[7, 8, 9, 10]]);
}

#[test]
fn what_a_part_of_an_image_reads_is_known_while_a_list_is_compiled() {
    const FACE: u32 = 0x8515;
    let (format, data_type) = (gl::RGBA, gl::UNSIGNED_BYTE);
    let mut context = textured(1);
    image(&mut context, 0, gl::RGBA, 4, &[[0; 4]; 16]);
    context.tex_image_2d(FACE, 0, 4, [4; 2], 0, format, data_type, None);
    let read = |context: &Context, target: u32, offset: i32, size: [i32; 2]| {
        let (offset, size) = ([offset, 0, 0], [size[0], size[1], 1]);
        context.tex_sub_image_bytes(2, target, 0, offset, size, format, data_type)
    };
    // Whether a part fits isn't known before the list is called; nothing is as large as the last one.
    for (listed, beyond) in [(false, 0), (true, 32)] {
        if listed {
            context.new_list(1, gl::COMPILE);
        }
        assert_eq!(read(&context, TEXTURE_2D, 0, [4, 2]), 32);
        assert_eq!(read(&context, FACE, 0, [4, 2]), 32, "a part of a face needn't be square");
        assert_eq!(read(&context, TEXTURE_2D, 1, [4, 2]), beyond);
        assert_eq!(read(&context, TEXTURE_2D, 0, [1 << 20, 2]), 0);
        assert_eq!(read(&context, TEXTURE_2D, 0, [-1, 2]), 0);
    }
}

#[test]
fn section_3_8_1_draws_of_textures_that_are_gone_are_carried_out_before_memory_ends() {
    let mut context = textured(8);
    context.clear_color([1.0; 4]);
    context.clear(gl::COLOR_BUFFER_BIT);
    // More than all images together may take, if draws that wait kept them.
    for name in 1..=1100 {
        context.bind_texture(TEXTURE_2D, name);
        context.tex_parameter(TEXTURE_2D, MIN_FILTER, &[NEAREST as f32]);
        let size = [1024; 2];
        context.tex_image_2d(TEXTURE_2D, 0, 4, size, 0, gl::RGBA, gl::UNSIGNED_BYTE, None);
        square(&mut context, 8.0, 1.0);
        context.delete_textures(1, &[name]);
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
    assert_eq!(pixels(&mut context), vec![[0; 4]; 64]);
}

#[test]
fn section_6_1_4_luminance_of_colours_is_their_red() {
    let mut context = textured(1);
    image(&mut context, 0, gl::RGBA, 1, &[[100, 60, 30, 200]]);
    let mut found = [0; 2];
    context.get_tex_image(TEXTURE_2D, 0, 0x190A, gl::UNSIGNED_BYTE, &mut found);
    assert_eq!(found, [100, 200]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_3_8_1_texels_are_made_of_indices_and_bits() {
    let mut context = textured(2);
    context.pixel_map(0x0C73, 2, &[0.0, 1.0]);
    context.pixel_map(0x0C75, 1, &[1.0]);
    context.pixel_store(0x0CF5, 1.0);
    let bits = [0b0100_0000, 0b1000_0000];
    context.tex_image_2d(TEXTURE_2D, 0, 4, [2, 2], 0, 0x1900, 0x1A00, Some(&bits));
    square(&mut context, 2.0, 1.0);
    let (off, on) = ([0, 0, 0, 255], [0, 255, 0, 255]);
    assert_eq!(pixels(&mut context), [off, on, on, off]);
    context.tex_sub_image(2, TEXTURE_2D, 0, [0; 3], [2, 1, 1], 0x1900, gl::UNSIGNED_BYTE, &[1, 0]);
    square(&mut context, 2.0, 1.0);
    assert_eq!(pixels(&mut context), [on, off, on, off]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}
