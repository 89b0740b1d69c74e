//! JPEG, baseline and progressive.

use super::texels::{Decoded, LONGEST_SIDE, check, checked_picture, opaque};
use crate::{Limits, Warning};
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// The first scan of a JPEG spends at least a bit on each block of 8x8 texels.
const BLOCKS_PER_BYTE: u64 = 8;

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<Decoded, Warning> {
    let damaged =
        |error: zune_jpeg::errors::DecodeErrors| format!("the JPEG is damaged: {error:?}");
    let options = DecoderOptions::new_safe()
        .set_max_width(LONGEST_SIDE as usize)
        .set_max_height(LONGEST_SIDE as usize)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(damaged)?;
    let (width, height) = decoder.dimensions().ok_or("the JPEG has no dimensions")?;
    let [width, height] = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    let blocks = u64::from(width.div_ceil(8)) * u64::from(height.div_ceil(8));
    check(width, height, bytes, blocks / BLOCKS_PER_BYTE, limits)?;
    let rows = decoder.decode().map_err(damaged)?;
    checked_picture(width, height, rows.chunks_exact(3).map(opaque).collect())
}
