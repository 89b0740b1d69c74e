//! Images at the raster position.

use crate::canvas::{canvas, depths, draw, gl, pixels};
use luxel_gl::Context;

const COLOR: u32 = 0x1800;
const STENCIL: u32 = 0x1802;
const STENCIL_INDEX: u32 = 0x1901;
const SHORT: u32 = 0x1402;

const RED: [u8; 4] = [255, 0, 0, 255];
const BLUE: [u8; 4] = [0, 0, 255, 255];
const BLACK: [u8; 4] = [0; 4];

fn draw_words(context: &mut Context, size: [i32; 2], words: &[[u8; 4]]) {
    context.draw_pixels(size, gl::RGBA, gl::UNSIGNED_BYTE, words.as_flattened());
}

#[test]
fn section_3_6_4_pixels_come_back_as_they_were_drawn() {
    let mut context = canvas(20, 20);
    let words: Vec<[u8; 4]> = (0..=255).map(|at| [at, 255 - at, at / 2, at ^ 0x55]).collect();
    context.window_pos([2.0, 3.0, 0.5]);
    draw_words(&mut context, [16, 16], &words);
    let mut bytes = vec![0; 1024];
    context.read_pixels(2, 3, 16, 16, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    assert_eq!(bytes, words.as_flattened());
    let all = pixels(&mut context);
    assert_eq!([all[0], all[19 * 20 + 19]], [BLACK; 2]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_3_6_4_each_pixel_is_a_rectangle_as_large_as_the_zoom() {
    let mut context = canvas(6, 4);
    context.pixel_zoom(2.0, -1.0);
    context.window_pos([1.0, 3.0, 0.0]);
    draw_words(&mut context, [2, 2], &[RED, BLUE, BLUE, RED]);
    let row = |of: [[u8; 4]; 2]| [BLACK, of[0], of[0], of[1], of[1], BLACK];
    let expected = [[BLACK; 6], row([BLUE, RED]), row([RED, BLUE]), [BLACK; 6]];
    assert_eq!(pixels(&mut context), expected.as_flattened());
}

#[test]
fn section_3_6_4_depths_are_fragments_of_the_raster_positions_colour() {
    let mut context = canvas(4, 1);
    context.clear_depth(0.5);
    context.clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
    context.enable(gl::DEPTH_TEST);
    context.color([1.0, 0.0, 0.0, 1.0]);
    context.window_pos([0.0; 3]);
    let values = [0.25_f32, 0.75, -1.0, 0.5];
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_ne_bytes()).collect();
    context.draw_pixels([4, 1], gl::DEPTH_COMPONENT, gl::FLOAT, &bytes);
    assert_eq!(pixels(&mut context), [RED, BLACK, RED, BLACK]);
    let found = depths(&mut context);
    assert!((found[0] - 0.25).abs() < 1e-7 && (found[1] - 0.5).abs() < 1e-7 && found[2] == 0.0);
}

#[test]
fn section_4_3_1_stencil_values_are_written_by_the_mask_alone() {
    let mut context = canvas(2, 2);
    context.clear_stencil(0xf0);
    context.clear(0x400);
    context.stencil_mask(0x3f);
    context.enable(0x0B90);
    context.stencil_func(0x0200, 0, 255);
    context.window_pos([0.0; 3]);
    let bytes: Vec<u8> = [1_i16, 2, -1, 300].iter().flat_map(|value| value.to_ne_bytes()).collect();
    context.pixel_store(0x0CF5, 2.0);
    context.draw_pixels([2, 2], STENCIL_INDEX, SHORT, &bytes);
    let read = |context: &mut Context| {
        let mut found = [0; 8];
        context.read_pixels(0, 0, 2, 2, STENCIL_INDEX, gl::UNSIGNED_BYTE, &mut found);
        [found[0], found[1], found[4], found[5]]
    };
    assert_eq!(read(&mut context), [0xc1, 0xc2, 0xff, 0xec]);
    // A copy within the framebuffer reads before it writes.
    context.stencil_mask(0xff);
    context.window_pos([1.0, 0.0, 0.0]);
    context.copy_pixels([0, 0], [2, 2], STENCIL);
    assert_eq!(read(&mut context), [0xc1, 0xc1, 0xff, 0xff]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_4_3_3_copies_leave_out_what_lies_outside_of_the_framebuffer() {
    let mut context = canvas(4, 4);
    context.color([1.0, 0.0, 0.0, 1.0]);
    draw(&mut context, gl::QUADS, &[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    context.window_pos([1.0, 1.0, 0.0]);
    context.copy_pixels([-1, -1], [2, 2], COLOR);
    let all = pixels(&mut context);
    assert_eq!([all[0], all[5], all[10]], [RED, BLACK, RED]);
    context.copy_pixels([i32::MIN, i32::MAX], [i32::MAX, i32::MAX], COLOR);
    context.pixel_zoom(f32::NAN, f32::INFINITY);
    context.copy_pixels([0, 0], [4, 4], COLOR);
    assert_eq!(pixels(&mut context), all);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_3_10_images_are_fogged_by_the_distance_of_the_raster_position() {
    let mut context = canvas(1, 1);
    context.enable(0x0B60);
    for (pname, value) in [(0x0B65, 0x2601 as f32), (0x0B64, 4.0), (0x8450, 0x8451 as f32)] {
        context.fog(pname, &[value]);
    }
    context.fog(0x0B66, &[0.0, 0.0, 1.0, 1.0]);
    context.fog_coord(3.0);
    context.window_pos([0.0; 3]);
    draw_words(&mut context, [1, 1], &[RED]);
    assert_eq!(pixels(&mut context), [[64, 0, 191, 255]]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_3_6_5_pixels_are_scaled_biased_and_mapped_wherever_they_go() {
    const RED_SCALE: u32 = 0x0D14;
    const MAP_COLOR: u32 = 0x0D10;
    const G_TO_G: u32 = 0x0C77;
    let mut context = canvas(4, 1);
    let words = [[200, 0, 10, 255], [100, 255, 20, 0]];
    context.pixel_transfer(RED_SCALE, 0.5);
    context.pixel_map(G_TO_G, 2, &[0.2, 0.0]);
    context.pixel_map(0x0C76, 256, &[0; 256].map(|_: i32| 1.0));
    context.pixel_map(0x0C76, 2, &[0.0, 1.0]);
    context.window_pos([0.0; 3]);
    draw_words(&mut context, [2, 1], &words);
    let drawn = [[100, 0, 10, 255], [50, 255, 20, 0]];
    context.window_pos([2.0, 0.0, 0.0]);
    context.copy_pixels([0, 0], [2, 1], COLOR);
    context.pixel_transfer(RED_SCALE, 1.0);
    assert_eq!(pixels(&mut context)[..2], drawn);
    assert_eq!(pixels(&mut context)[2..], [[50, 0, 10, 255], [25, 255, 20, 0]]);
    // Tables count where they are switched on; blue and alpha have one value, 0.
    context.pixel_transfer(MAP_COLOR, 1.0);
    assert_eq!(pixels(&mut context)[..2], [[0, 51, 0, 0], [0, 0, 0, 0]]);
    context.window_pos([0.0; 3]);
    draw_words(&mut context, [2, 1], &words);
    context.pixel_transfer(MAP_COLOR, 0.0);
    assert_eq!(pixels(&mut context)[..2], [[255, 51, 0, 0], [0, 0, 0, 0]]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

const COLOR_INDEX: u32 = 0x1900;
const BITMAP: u32 = 0x1A00;
const I_TO_R: u32 = 0x0C72;
const I_TO_A: u32 = 0x0C75;

#[test]
fn section_3_6_5_indices_and_bits_take_their_colours_from_the_maps() {
    let mut context = canvas(4, 1);
    context.pixel_map(I_TO_R, 4, &[0.0, 0.2, 0.4, 1.0]);
    context.pixel_map(I_TO_A, 1, &[1.0]);
    let expected = [[0, 0, 0, 255], [51, 0, 0, 255], [102, 0, 0, 255], [255, 0, 0, 255]];
    let draw = |context: &mut Context, data_type: u32, bytes: &[u8]| {
        context.clear(gl::COLOR_BUFFER_BIT);
        context.window_pos([0.0; 3]);
        context.draw_pixels([4, 1], COLOR_INDEX, data_type, bytes);
        pixels(context)
    };
    assert_eq!(draw(&mut context, gl::UNSIGNED_BYTE, &[0, 1, 2, 7]), expected);
    // Bits are indices 0 and 1, the highest first; of lists the same.
    let bits = [0b1010_0000];
    assert_eq!(context.draw_pixels_bytes([4, 1], COLOR_INDEX, BITMAP), 1);
    let drawn = draw(&mut context, BITMAP, &bits);
    assert_eq!(drawn, [expected[1], expected[0], expected[1], expected[0]]);
    context.new_list(1, gl::COMPILE);
    context.draw_pixels([4, 1], COLOR_INDEX, BITMAP, &bits);
    context.end_list();
    context.clear(gl::COLOR_BUFFER_BIT);
    context.window_pos([0.0; 3]);
    context.call_list(1);
    assert_eq!(pixels(&mut context), drawn);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    for (format, data_type, error) in [
        (COLOR_INDEX, 0x8035, gl::INVALID_OPERATION),
        (gl::RGBA, BITMAP, gl::INVALID_ENUM),
        (0x8227, 0x8035, gl::INVALID_OPERATION),
    ] {
        context.draw_pixels([4, 1], format, data_type, &[0; 64]);
        assert_eq!(context.get_error(), error, "{format:#x} {data_type:#x}");
    }
}

#[test]
fn section_3_7_a_bitmap_at_a_pixels_edge_begins_with_that_pixel() {
    // The transform in f32 takes some of these positions to just below the edge.
    for width in [7, 99, 400, 999] {
        let mut context = canvas(width, 1);
        for x in 0..width {
            context.raster_pos([x as f32, 0.0, 0.0, 1.0]);
            context.bitmap([1, 1], [0.0; 2], [0.0; 2], Some(&[0x80]));
            let covered = pixels(&mut context).iter().filter(|pixel| **pixel != BLACK).count();
            assert_eq!(covered, x as usize + 1, "{x} of {width}");
        }
    }
}
