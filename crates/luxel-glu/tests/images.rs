//! Images and mipmaps (GLU 1.3, chapter 3): formats, storage, scaling.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_glu::{Image, ImageError, Layout, PixelFormat, mipmap_count, mipmaps, nearest_power};
use proptest::prelude::*;

const RGB: u32 = 0x1907;
const RGBA: u32 = 0x1908;
const LUMINANCE: u32 = 0x1909;
const COLOR_INDEX: u32 = 0x1900;
const UNSIGNED_BYTE: u32 = 0x1401;
const UNSIGNED_SHORT: u32 = 0x1403;
const FLOAT: u32 = 0x1406;
const BITMAP: u32 = 0x1A00;
const UNSIGNED_SHORT_5_6_5: u32 = 0x8363;

/// Formats and types that go together.
fn all_formats() -> Vec<PixelFormat> {
    let mut formats = Vec::new();
    for format in (0x1900..=0x190A).chain(0x80E0..=0x80E1) {
        for kind in (0x1400..=0x1406).chain([BITMAP]).chain(0x8032..=0x8036).chain(0x8362..=0x8368)
        {
            match PixelFormat::new(format, kind) {
                Ok(format) => formats.push(format),
                Err(error) => assert_eq!(error, ImageError::Operation, "{format:#x} {kind:#x}"),
            }
        }
    }
    formats
}

#[test]
fn formats_and_types_that_do_not_go_together_are_refused() {
    // 7 types for each of 13 formats, bitmaps for two, packed ones for RGB, and for RGBA and BGRA.
    assert_eq!(all_formats().len(), 7 * 13 + 2 + 4 + 2 * 8);
    assert_eq!(PixelFormat::new(5, FLOAT), Err(ImageError::Enum));
    assert_eq!(PixelFormat::new(RGB, 5), Err(ImageError::Enum));
    assert_eq!(PixelFormat::new(RGBA, UNSIGNED_SHORT_5_6_5), Err(ImageError::Operation));
}

#[test]
fn rows_are_where_the_pixel_store_says() {
    let format = PixelFormat::new(RGB, UNSIGNED_BYTE).unwrap();
    let layout = Layout { alignment: 4, row_length: 5, skip: [2, 1, 0], ..Layout::TIGHT };
    // Rows of 15 bytes on multiples of 4: the second and third row, from the third pixel on.
    assert_eq!(layout.span(format, [2, 2, 1]), Ok(2 * 16 + 4 * 3));
    let memory: Vec<u8> = (0..44).collect();
    let image = Image::read(&memory, &layout, format, [2, 2, 1]).unwrap();
    let bytes: Vec<u8> = image.values.iter().map(|value| (value * 255.0 + 0.5) as u8).collect();
    assert_eq!(bytes, [22, 23, 24, 25, 26, 27, 38, 39, 40, 41, 42, 43]);
    let mut back = vec![0; 44];
    image.write(&mut back, &layout, format);
    assert_eq!((back[21], back[22], back[27], back[28], back[43]), (0, 22, 27, 0, 43));
}

#[test]
fn bytes_of_numbers_and_bits_of_bitmaps_can_be_turned() {
    let format = PixelFormat::new(LUMINANCE, UNSIGNED_SHORT).unwrap();
    let layout = Layout { swap_bytes: true, ..Layout::TIGHT };
    let memory = 0x1234u16.swap_bytes().to_ne_bytes();
    let image = Image::read(&memory, &layout, format, [1, 1, 1]).unwrap();
    assert_eq!(image.values, [f32::from(0x1234u16) / 65535.0]);
    let bitmap = PixelFormat::new(COLOR_INDEX, BITMAP).unwrap();
    let bits = |lsb_first: bool| {
        let layout = Layout { lsb_first, skip: [1, 0, 0], ..Layout::TIGHT };
        Image::read(&[0b0100_0010], &layout, bitmap, [7, 1, 1]).unwrap().values
    };
    assert_eq!(bits(false), [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    assert_eq!(bits(true), [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
}

#[test]
fn spans_beyond_memory_are_errors_and_not_overflows() {
    let format = PixelFormat::new(RGBA, FLOAT).unwrap();
    let huge = i32::MAX as usize;
    assert_eq!(Layout::TIGHT.span(format, [huge, huge, huge]), Err(ImageError::Memory));
    let skipped =
        Layout { skip: [huge, huge, huge], row_length: huge, image_height: huge, ..Layout::TIGHT };
    assert_eq!(skipped.span(format, [1, 1, 1]), Err(ImageError::Memory));
    assert_eq!(Image::zero([huge, huge, 1], 4), Err(ImageError::Memory));
}

#[test]
fn a_smaller_image_is_the_mean_and_a_larger_one_is_interpolated() {
    let image = Image { size: [4, 1, 1], components: 1, values: vec![0.0, 1.0, 0.5, 0.1] };
    assert_eq!(image.scaled([2, 1, 1]).unwrap().values, [0.5, 0.3]);
    let means = image.scaled([3, 1, 1]).unwrap().values;
    for (mean, expected) in means.iter().zip([0.25, 0.75, 0.2]) {
        assert!((mean - expected).abs() < 1e-6, "{means:?}");
    }
    let two = Image { size: [2, 1, 1], components: 1, values: vec![0.0, 1.0] };
    assert_eq!(two.scaled([4, 1, 1]).unwrap().values, [0.0, 0.25, 0.75, 1.0]);
    assert_eq!(two.scaled([0, 1, 1]), Err(ImageError::Value));
}

#[test]
fn mipmaps_halve_each_side_down_to_one_pixel() {
    let format = PixelFormat::new(LUMINANCE, UNSIGNED_BYTE).unwrap();
    let image = Image {
        size: [4, 2, 2],
        components: 1,
        values: (0..16).map(|i| i as f32 / 255.0).collect(),
    };
    assert_eq!(mipmap_count(image.size), 2);
    let levels = mipmaps(&image, format, 0, 2).unwrap();
    let sizes: Vec<[usize; 3]> = levels.iter().map(|level| level.size).collect();
    assert_eq!(sizes, [[4, 2, 2], [2, 1, 1], [1, 1, 1]]);
    // Means of 0 1 4 5 8 9 12 13 and of 2 3 6 7 10 11 14 15, and of all.
    assert_eq!(levels[1].pixels, [7, 9]);
    assert_eq!(levels[2].pixels, [8]);
    assert_eq!([1, 2, 3, 5, 6, 11, 12, 65].map(nearest_power), [1, 2, 4, 4, 8, 8, 16, 64]);
}

proptest! {
    #[test]
    fn what_is_written_is_read_again(bytes in prop::collection::vec(any::<u8>(), 80), which in 0usize..113) {
        let format = all_formats()[which];
        let layout = Layout { alignment: 2, row_length: 3, swap_bytes: which % 2 == 0, ..Layout::TIGHT };
        let size = [2, 2, 1];
        let length = layout.span(format, size).unwrap();
        let image = Image::read(&bytes[..length], &layout, format, size).unwrap();
        let mut back = vec![0; length];
        image.write(&mut back, &layout, format);
        let again = Image::read(&back, &layout, format, size).unwrap();
        for (a, b) in image.values.iter().zip(&again.values) {
            // Of a signed type the least number is below -1.
            prop_assert!(a.is_nan() && b.is_nan() || (a - b).abs() <= a.abs() * 1e-6, "{} and {}", a, b);
        }
    }

    #[test]
    fn scaling_keeps_the_mean(values in prop::collection::vec(0f32..1.0, 24), w in 1usize..7, h in 1usize..5) {
        let image = Image { size: [6, 4, 1], components: 1, values };
        let scaled = image.scaled([w, h, 1]).unwrap();
        let mean = |image: &Image| image.values.iter().map(|&x| f64::from(x)).sum::<f64>() / image.values.len() as f64;
        prop_assert!((mean(&image) - mean(&scaled)).abs() < 1e-5);
    }
}
