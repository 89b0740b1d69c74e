//! Reading pixels (section 4.3.2) and OSMesa's buffers.

use crate::canvas::{canvas, gl};
use luxel_gl::{ColorLayout, Context};

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
