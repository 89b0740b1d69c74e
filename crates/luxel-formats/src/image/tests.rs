use super::*;
use crate::Hint;
use ::png::{BitDepth, ColorType};

const LIMITS: Limits =
    Limits { max_memory: 1 << 20, max_depth: 8, progress: None, files: None, given: None };

fn png(width: u32, height: u32, color: ColorType, depth: BitDepth, rows: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(vec![1, 2, 3, 40, 50, 60]);
        encoder.set_trns(vec![7, 255]);
    }
    encoder.write_header().unwrap().write_image_data(rows).unwrap();
    bytes
}

/// The checksum of a chunk's type and data (PNG specification, annex D).
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc: u32, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            crc >> 1 ^ (0xedb8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

fn texels(bytes: &[u8]) -> Vec<[u8; 4]> {
    decode("x", bytes, Encoding::Srgb, &LIMITS).unwrap().levels[0].texels.clone()
}

#[test]
fn every_png_colour_type_becomes_rgba() {
    use BitDepth::{Eight, One, Sixteen};
    for (color, depth, row, expected) in [
        (ColorType::Grayscale, Eight, &[9, 200][..], [[9, 9, 9, 255], [200, 200, 200, 255]]),
        (ColorType::Grayscale, One, &[0b0100_0000], [[0, 0, 0, 255], [255, 255, 255, 255]]),
        (
            ColorType::Grayscale,
            Sixteen,
            &[0x80, 0xff, 255, 255],
            [[128, 128, 128, 255], [255, 255, 255, 255]],
        ),
        (ColorType::GrayscaleAlpha, Eight, &[9, 1, 8, 2], [[9, 9, 9, 1], [8, 8, 8, 2]]),
        (ColorType::Rgb, Eight, &[1, 2, 3, 4, 5, 6], [[1, 2, 3, 255], [4, 5, 6, 255]]),
        (ColorType::Rgba, Eight, &[1, 2, 3, 4, 5, 6, 7, 8], [[1, 2, 3, 4], [5, 6, 7, 8]]),
        (ColorType::Indexed, Eight, &[1, 0], [[40, 50, 60, 255], [1, 2, 3, 7]]),
    ] {
        assert_eq!(texels(&png(2, 1, color, depth, row)), expected, "{color:?} {depth:?}");
    }
}

#[test]
fn false_dimensions_fail_before_texels_are_allocated() {
    let mut bytes = png(2, 1, ColorType::Grayscale, BitDepth::Eight, &[0, 0]);
    // Width in IHDR, with its checksum left wrong or not: either way no allocation.
    bytes[16..20].copy_from_slice(&60_000_u32.to_be_bytes());
    bytes[20..24].copy_from_slice(&60_000_u32.to_be_bytes());
    assert!(decode("x", &bytes, Encoding::Srgb, &Limits::default()).is_err());
    // Sides whose product with the bits of a texel overflows 64 bits; the checksum is right.
    bytes[16..24].copy_from_slice(&[0xaa; 8]);
    bytes[24..26].copy_from_slice(&[16, 6]);
    let checksum = crc(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
    let message = decode("x", &bytes, Encoding::Srgb, &Limits::default()).unwrap_err();
    assert!(message.message.contains("2863311530x2863311530"), "{message}");
    let zeros = png(600, 600, ColorType::Rgba, BitDepth::Eight, &vec![0; 600 * 600 * 4]);
    let warning = decode("x", &zeros, Encoding::Srgb, &LIMITS).unwrap_err();
    assert_eq!(warning.hint, Some(Hint::RaiseMemoryLimit), "{warning}");
}

#[test]
fn truncated_and_foreign_images_are_errors() {
    let bytes = png(2, 1, ColorType::Rgb, BitDepth::Eight, &[1, 2, 3, 4, 5, 6]);
    for length in 0..bytes.len() - 16 {
        assert!(decode("x", &bytes[..length], Encoding::Srgb, &LIMITS).is_err(), "{length}");
    }
    assert!(decode("x", b"GIF89a", Encoding::Srgb, &LIMITS).is_err());
    assert!(decode("x", &[0xff, 0xd8, 0xff, 0xe0, 0], Encoding::Srgb, &LIMITS).is_err());
}
