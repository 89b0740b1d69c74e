//! Pictures: PNG and JPEG become 8-bit texels.
//!
//! Dimensions are checked against the limits, and against what so many bytes can hold at all,
//! before texels are allocated: a header can claim anything.

use crate::Limits;
use luxel_scene::{Encoding, Image};
use png::{BitDepth, ColorType, Transformations};
use std::io::Cursor;
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// What one texel takes at most: in the decoder's own format, as RGBA, and in the mipmaps.
const BYTES_PER_TEXEL: u64 = 8 + 4 + 2;

/// A picture can't be wider or higher than this: the bound of PNG viewers and of graphics APIs.
const LONGEST_SIDE: u32 = 65_535;

/// Deflate's shortest code stands for 258 bytes in two bits.
const PNG_BYTES_PER_BYTE: u64 = 1032;

/// The first scan of a JPEG spends at least a bit on each block of 8x8 texels.
const JPEG_BLOCKS_PER_BYTE: u64 = 8;

/// Decodes a picture; its first bytes tell the format. What is wrong is told in a sentence.
pub(crate) fn decode(
    name: &str,
    bytes: &[u8],
    encoding: Encoding,
    limits: &Limits,
) -> Result<Image, String> {
    let decoded = if bytes.starts_with(b"\x89PNG") {
        decode_png(bytes, limits)?
    } else if bytes.starts_with(&[0xff, 0xd8]) {
        decode_jpeg(bytes, limits)?
    } else if bytes.is_empty() {
        return Err("the picture is empty".to_owned());
    } else {
        return Err("the picture is neither PNG nor JPEG: convert it to one of these".to_owned());
    };
    Ok(Image::new(name, encoding, decoded.width, decoded.height, decoded.texels))
}

struct Decoded {
    width: u32,
    height: u32,
    texels: Vec<[u8; 4]>,
}

/// Checks dimensions before anything is allocated by them. `bytes_needed` is what the file must
/// at least have for them.
fn check(
    width: u32,
    height: u32,
    bytes: &[u8],
    bytes_needed: u64,
    limits: &Limits,
) -> Result<(), String> {
    if width == 0 || height == 0 || width.max(height) > LONGEST_SIDE {
        return Err(format!("the picture says it is {width}x{height}"));
    }
    if bytes_needed > bytes.len() as u64 {
        let length = bytes.len();
        return Err(format!(
            "the picture says it is {width}x{height}, but has only {length} bytes"
        ));
    }
    let needed = u64::from(width) * u64::from(height) * BYTES_PER_TEXEL;
    if needed > limits.max_memory {
        let limit = limits.max_memory;
        return Err(format!(
            "a picture of {width}x{height} would take {needed} bytes; the limit is {limit}: \
             raise it with --max-memory"
        ));
    }
    Ok(())
}

fn decode_png(bytes: &[u8], limits: &Limits) -> Result<Decoded, String> {
    let said = |error: png::DecodingError| format!("the PNG is damaged: {error}");
    let within = usize::try_from(limits.max_memory).unwrap_or(usize::MAX);
    let mut decoder =
        png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: within });
    decoder.set_transformations(Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(said)?;
    let (width, height) = (header.width, header.height);
    // Sides of 32 bits each are refused below, but multiplied here.
    let texels = u64::from(width) * u64::from(height);
    let bits = texels.saturating_mul(header.bits_per_pixel() as u64);
    check(width, height, bytes, bits / 8 / PNG_BYTES_PER_BYTE, limits)?;
    let mut reader = decoder.read_info().map_err(said)?;
    let size = reader.output_buffer_size().ok_or("the PNG is too large")?;
    let mut rows = vec![0; size];
    let frame = reader.next_frame(&mut rows).map_err(said)?;
    // An animation's first frame may cover only a part; the still picture covers all of it.
    let (width, height) = (frame.width, frame.height);
    let rows = rows.get(..frame.buffer_size()).unwrap_or(&rows);
    let narrowed;
    let rows = match frame.bit_depth {
        BitDepth::Eight => rows,
        BitDepth::Sixteen => {
            narrowed = rows.chunks_exact(2).map(narrow).collect::<Vec<_>>();
            &narrowed
        }
        // The transformation above leaves no other.
        depth => return Err(format!("the PNG has {depth:?} bits a channel")),
    };
    let texels: Vec<_> = match frame.color_type {
        ColorType::Grayscale => rows.iter().map(|&y| [y, y, y, 255]).collect(),
        ColorType::GrayscaleAlpha => {
            rows.chunks_exact(2).map(|ya| [ya[0], ya[0], ya[0], ya[1]]).collect()
        }
        ColorType::Rgb => rows.chunks_exact(3).map(opaque).collect(),
        ColorType::Rgba => rows.as_chunks().0.to_vec(),
        ColorType::Indexed => return Err("the PNG's palette is missing".to_owned()),
    };
    whole(width, height, texels)
}

/// The nearest of 256 steps to one of 65,536.
fn narrow(bytes: &[u8]) -> u8 {
    let value = u32::from(bytes[0]) << 8 | u32::from(bytes[1]);
    ((value * 255 + 32_767) / 65_535) as u8
}

fn opaque(rgb: &[u8]) -> [u8; 4] {
    [rgb[0], rgb[1], rgb[2], 255]
}

fn decode_jpeg(bytes: &[u8], limits: &Limits) -> Result<Decoded, String> {
    let said = |error: zune_jpeg::errors::DecodeErrors| format!("the JPEG is damaged: {error:?}");
    let options = DecoderOptions::new_safe()
        .set_max_width(LONGEST_SIDE as usize)
        .set_max_height(LONGEST_SIDE as usize)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(said)?;
    let (width, height) = decoder.dimensions().ok_or("the JPEG has no dimensions")?;
    let [width, height] = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    let blocks = u64::from(width.div_ceil(8)) * u64::from(height.div_ceil(8));
    check(width, height, bytes, blocks / JPEG_BLOCKS_PER_BYTE, limits)?;
    let rows = decoder.decode().map_err(said)?;
    whole(width, height, rows.chunks_exact(3).map(opaque).collect())
}

fn whole(width: u32, height: u32, texels: Vec<[u8; 4]>) -> Result<Decoded, String> {
    if texels.len() as u64 == u64::from(width) * u64::from(height) {
        Ok(Decoded { width, height, texels })
    } else {
        Err("the picture's channels are of a kind that luxel doesn't read".to_owned())
    }
}

#[cfg(test)]
mod tests;
