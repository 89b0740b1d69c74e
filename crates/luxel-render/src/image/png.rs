//! PNG (W3C Portable Network Graphics, third edition).

use super::PictureError;
use super::legend::LayerWords;
use luxel_lighting::PictureEncoding;
use luxel_scene::Size;
use png::{BitDepth, ColorType, Compression, Encoder, ScaledFloat, SrgbRenderingIntent};
use std::io::{self, Write};

/// 8 bits, with straight alpha.
pub(crate) fn write_rgba8(
    size: Size,
    pixels: &[[u8; 4]],
    encoding: PictureEncoding,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    write(size, ColorType::Rgba, BitDepth::Eight, Some(encoding), pixels.as_flattened(), out)
}

/// 16 bits, with straight alpha.
pub(crate) fn write_rgba16(
    size: Size,
    pixels: &[[u16; 4]],
    encoding: PictureEncoding,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let bytes = big_endian(pixels.as_flattened());
    write(size, ColorType::Rgba, BitDepth::Sixteen, Some(encoding), &bytes, out)
}

/// A layer in 16 bits.
pub(crate) fn write_layer(
    size: Size,
    words: &LayerWords,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let (color, words) = match words {
        LayerWords::Gray(words) => (ColorType::Grayscale, words.as_slice()),
        LayerWords::Rgb(pixels) => (ColorType::Rgb, pixels.as_flattened()),
    };
    write(size, color, BitDepth::Sixteen, None, &big_endian(words), out)
}

fn write(
    size: Size,
    color: ColorType,
    depth: BitDepth,
    encoding: Option<PictureEncoding>,
    bytes: &[u8],
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let mut encoder = Encoder::new(out, size.width, size.height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    // Pictures are written far more often than they are sent: quick first, small second.
    encoder.set_compression(Compression::Fast);
    match encoding {
        Some(PictureEncoding::Srgb) => {
            encoder.set_source_srgb(SrgbRenderingIntent::RelativeColorimetric);
        }
        Some(PictureEncoding::None) => encoder.set_source_gamma(ScaledFloat::new(1.0)),
        None => {}
    }
    let mut writer = encoder.write_header().map_err(io::Error::from)?;
    writer.write_image_data(bytes).map_err(io::Error::from)?;
    writer.finish().map_err(io::Error::from)?;
    Ok(())
}

/// Words as PNG and PPM store them: high byte first.
pub(crate) fn big_endian(words: &[u16]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_be_bytes()).collect()
}
