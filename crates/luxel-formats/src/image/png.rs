//! PNG, of every colour type and depth.

use super::texels::{Decoded, check, checked_picture, opaque};
use crate::{Limits, Warning};
use ::png::{BitDepth, ColorType, Transformations};
use std::io::Cursor;

/// Deflate encodes at most 258 bytes in two bits.
const BYTES_PER_BYTE: u64 = 1032;

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<Decoded, Warning> {
    let damaged = |error: ::png::DecodingError| format!("the PNG is damaged: {error}");
    let within = usize::try_from(limits.max_memory).unwrap_or(usize::MAX);
    let mut decoder =
        ::png::Decoder::new_with_limits(Cursor::new(bytes), ::png::Limits { bytes: within });
    decoder.set_transformations(Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(damaged)?;
    let (width, height) = (header.width, header.height);
    // Sides of 32 bits each are refused below, but multiplied here.
    let texels = u64::from(width) * u64::from(height);
    let bits = texels.saturating_mul(header.bits_per_pixel() as u64);
    check(width, height, bytes, bits / 8 / BYTES_PER_BYTE, limits)?;
    let mut reader = decoder.read_info().map_err(damaged)?;
    let size = reader.output_buffer_size().ok_or("the PNG is too large")?;
    let mut rows = vec![0; size];
    let frame = reader.next_frame(&mut rows).map_err(damaged)?;
    // An animation's first frame may cover only a part; the still image covers all.
    let (width, height) = (frame.width, frame.height);
    let rows = rows.get(..frame.buffer_size()).unwrap_or(&rows);
    let narrowed;
    let rows = match frame.bit_depth {
        BitDepth::Eight => rows,
        BitDepth::Sixteen => {
            narrowed = rows.chunks_exact(2).map(narrow).collect::<Vec<_>>();
            &narrowed
        }
        // The transformation above excludes other depths.
        depth => return Err(format!("the PNG has {depth:?} bits per channel").into()),
    };
    let texels: Vec<_> = match frame.color_type {
        ColorType::Grayscale => rows.iter().map(|&y| [y, y, y, 255]).collect(),
        ColorType::GrayscaleAlpha => {
            rows.chunks_exact(2).map(|ya| [ya[0], ya[0], ya[0], ya[1]]).collect()
        }
        ColorType::Rgb => rows.chunks_exact(3).map(opaque).collect(),
        ColorType::Rgba => rows.as_chunks().0.to_vec(),
        ColorType::Indexed => return Err("the PNG's palette is missing".into()),
    };
    checked_picture(width, height, texels)
}

/// The nearest of 256 steps to one of 65,536.
fn narrow(bytes: &[u8]) -> u8 {
    let value = u32::from(bytes[0]) << 8 | u32::from(bytes[1]);
    ((value * 255 + 32_767) / 65_535) as u8
}
