//! Reading pixels (section 4.3.2) and OSMesa's buffers.

use crate::canvas::{canvas, gl};
use luxel_gl::{ColorLayout, Configuration, Context};
use proptest::prelude::*;

/// Four pixels a row, each of its own colour, three rows.
fn painted() -> Context {
    let mut context = canvas(4, 3);
    context.enable(gl::SCISSOR_TEST);
    for y in 0..3 {
        for x in 0..4 {
            context.scissor(x, y, 1, 1);
            let channel = |value: i32| value as f32 / 255.0;
            context.clear_color([channel(10 * x), channel(20 * y), channel(200), channel(100 + x)]);
            context.clear(gl::COLOR_BUFFER_BIT);
        }
    }
    context
}

fn color(x: usize, y: usize) -> [u8; 4] {
    [10 * x as u8, 20 * y as u8, 200, 100 + x as u8]
}

#[test]
fn section_4_3_2_rows_are_packed_by_alignment_length_and_skips() {
    let mut context = painted();
    context.pixel_store(0x0D02, 5.0);
    context.pixel_store(0x0D03, 1.0);
    context.pixel_store(0x0D04, 2.0);
    // Rows of 5 pixels of 3 bytes, aligned to 4: 16 bytes.
    let size = context.pack_bytes(2, 2, 0x1907, gl::UNSIGNED_BYTE);
    assert_eq!(size, 16 + 6 + 16 + 6);
    let mut bytes = vec![7; size];
    context.read_pixels(1, 1, 2, 2, 0x1907, gl::UNSIGNED_BYTE, &mut bytes);
    let at = |start: usize| &bytes[start..start + 3];
    assert_eq!([at(22), at(25)], [&color(1, 1)[..3], &color(2, 1)[..3]]);
    assert_eq!([at(38), at(41)], [&color(1, 2)[..3], &color(2, 2)[..3]]);
    assert!(bytes[..22].iter().all(|byte| *byte == 7));
}

#[test]
fn section_4_3_2_pixels_outside_of_the_framebuffer_leave_memory_alone() {
    let mut context = painted();
    let mut bytes = [9; 6 * 5 * 4];
    context.read_pixels(-1, -1, 6, 5, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    for (at, pixel) in bytes.as_chunks::<4>().0.iter().enumerate() {
        let (x, y) = (at % 6, at / 6);
        let inside = (1..5).contains(&x) && (1..4).contains(&y);
        assert_eq!(*pixel, if inside { color(x - 1, y - 1) } else { [9; 4] });
    }
    context.read_pixels(i32::MAX, i32::MIN, 3, 3, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    context.read_pixels(0, 0, 9, 9, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes[..5]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_4_3_2_formats_and_types_convert() {
    let mut context = painted();
    let mut read = |format: u32, data_type: u32| {
        let mut bytes = vec![0; context.pack_bytes(1, 1, format, data_type)];
        context.read_pixels(2, 1, 1, 1, format, data_type, &mut bytes);
        bytes
    };
    assert_eq!(read(0x80E1, gl::UNSIGNED_BYTE), [200, 20, 20, 102]);
    assert_eq!(read(0x1909, gl::UNSIGNED_BYTE), [240]);
    assert_eq!(read(0x190A, gl::UNSIGNED_BYTE), [240, 102]);
    assert_eq!(read(0x1906, gl::UNSIGNED_BYTE), [102]);
    let red = f32::from_ne_bytes(read(0x1903, gl::FLOAT).try_into().unwrap());
    assert!((red - 20.0 / 255.0).abs() < 1e-6);
    let packed = u32::from_ne_bytes(read(gl::RGBA, 0x8035).try_into().unwrap());
    assert_eq!(packed, 0x1414_c866);
    assert_eq!(read(0x1900, gl::UNSIGNED_BYTE), [0_u8; 0]);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
}

#[test]
fn osmesa_buffers_have_the_order_direction_and_type_that_was_asked_for() {
    let plane = |format: u32, data_type: u32, row_length: usize, y_up: bool, bytes: usize| {
        let mut context = painted();
        let mut plane = vec![1; bytes];
        context.color_plane(ColorLayout { format, data_type, row_length, y_up }, &mut plane);
        plane
    };
    let rgba = plane(gl::RGBA, gl::UNSIGNED_BYTE, 0, true, 48);
    assert_eq!(rgba[4 * 6..][..4], color(2, 1));
    let argb = plane(2, gl::UNSIGNED_BYTE, 6, false, 72);
    let [r, g, b, a] = color(1, 2);
    assert_eq!(argb[4..8], [a, r, g, b]);
    assert_eq!(argb[16..24], [1; 8]);
    let bgra = plane(1, 0x1403, 0, true, 96);
    assert_eq!(bgra[..2], (200_u16 * 257).to_ne_bytes());
    let packed = plane(5, 0x8363, 0, true, 24);
    assert_eq!(packed[..2], ((200_u16 * 31 + 127) / 255).to_ne_bytes());
    let mut context = canvas(4, 3);
    context.enable(gl::DEPTH_TEST);
    context.clear_depth(0.5);
    context.clear(gl::DEPTH_BUFFER_BIT);
    let mut depths = [0; 12];
    context.depth_plane(&mut depths);
    assert_eq!(depths, [8_388_608; 12]);
}

#[test]
fn osmesa_buffers_stay_as_they_are_while_nothing_is_drawn() {
    let mut context = canvas(4, 3);
    let layout =
        ColorLayout { format: gl::RGBA, data_type: gl::UNSIGNED_BYTE, row_length: 0, y_up: true };
    let mut plane = [7; 48];
    context.color_plane(layout, &mut plane);
    assert_eq!(plane, [7; 48]);
    context.clear(gl::COLOR_BUFFER_BIT);
    context.color_plane(layout, &mut plane);
    assert_eq!(plane, [0; 48]);
}

proptest! {
    #[test]
    fn section_4_3_2_rows_are_read_as_their_pixels_are_one_by_one(
        [x, y] in [-9..30_i32, -9..50_i32], size in [0..40_i32, 0..60_i32], format in 0..14_usize,
        data_type in prop::sample::select(vec![gl::UNSIGNED_BYTE, 0x1403, gl::FLOAT]), swaps in any::<bool>(),
        row_length in prop_oneof![Just(0), 1..50_i32], skip in [0..3_i32, 0..3_i32], alignment in 0..4_u32,
        scale in prop::sample::select(vec![1.0, 0.5]), alpha in any::<bool>(), missing in prop_oneof![3 => Just(0), 1 => 1..400_usize],
    ) {
        const FORMATS: [u32; 14] = [
            0x1903, 0x1904, 0x1905, 0x1906, 0x1907, 0x1908, 0x80E0, 0x80E1, 0x8000, 0x1909, 0x190A, 0x1902, 0x1901,
            0x1908,
        ];
        let mut context = Context::new(Configuration { alpha, ..Configuration::default() });
        context.resize_default(27, 45);
        context.enable(gl::DEPTH_TEST);
        context.begin(gl::TRIANGLES);
        for ([x, y, z], color) in [[-0.9, -1.0, 0.5], [1.0, -0.5, -0.5], [0.0, 1.5, 0.9]].into_iter().zip([
            [1.0, 0.25, 0.0, 0.5], [0.0, 1.0, 0.5, 1.0], [0.3, 0.0, 1.0, 0.0],
        ]) {
            context.color(color);
            context.vertex([x, y, z, 1.0]);
        }
        context.end();
        // GL_RED_SCALE
        context.pixel_transfer(0x0D14, scale);
        let (format, [width, height]) = (FORMATS[format], size);
        let mut one = |at: [i32; 2]| {
            let mut bytes = vec![77; context.pack_bytes(1, 1, format, data_type)];
            context.read_pixels(at[0], at[1], 1, 1, format, data_type, &mut bytes);
            bytes
        };
        // GL_PACK_SWAP_BYTES reverses elements, of which a pixel has some.
        let element = match data_type {
            gl::UNSIGNED_BYTE => 1,
            0x1403 => 2,
            _ => 4,
        };
        let mut pixels = Vec::new();
        for row in 0..height {
            for column in 0..width {
                let mut bytes = one([x + column, y + row]);
                if swaps {
                    bytes.chunks_mut(element).for_each(<[u8]>::reverse);
                }
                pixels.push(bytes);
            }
        }
        let pixel = pixels.first().map_or(1, Vec::len);
        for (name, value) in [(0x0D00, i32::from(swaps)), (0x0D02, row_length), (0x0D03, skip[0]), (0x0D04, skip[1])] {
            context.pixel_store(name, value as f32);
        }
        context.pixel_store(0x0D05, (1 << alignment) as f32);
        let length = context.pack_bytes(width, height, format, data_type).saturating_sub(missing);
        let mut found = vec![77; length];
        context.read_pixels(x, y, width, height, format, data_type, &mut found);
        prop_assert_eq!(context.get_error(), gl::NO_ERROR);
        let row = (if row_length > 0 { row_length } else { width }) as usize * pixel;
        let stride = if element >= 1 << alignment { row } else { row.div_ceil(1 << alignment) << alignment };
        let mut expected = vec![77; length];
        for (number, bytes) in pixels.iter().enumerate() {
            let (across, up) = (number % width as usize, number / width as usize);
            let at = [x + across as i32, y + up as i32];
            let start = (skip[0] as usize + up) * stride + (skip[1] as usize + across) * pixel;
            let is_there = (0..27).contains(&at[0]) && (0..45).contains(&at[1]);
            if let Some(place) = expected.get_mut(start..start + pixel).filter(|_| is_there) {
                place.copy_from_slice(bytes);
            }
        }
        prop_assert!(found == expected);
    }
}
