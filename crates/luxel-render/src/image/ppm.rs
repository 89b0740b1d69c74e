//! PPM, the portable pixmap (`P6`) and PGM (`P5`) of Netpbm.

use super::PictureError;
use super::legend::LayerWords;
use super::png::big_endian;
use luxel_scene::Size;
use std::io::Write;

/// 8 bits. The format has no alpha: encoded colours are laid over black, as viewers do it.
pub(crate) fn write_rgba8(
    size: Size,
    pixels: &[[u8; 4]],
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    write_header(b"P6", size, 255, out)?;
    let over_black =
        |color: u8, alpha: u8| ((u32::from(color) * u32::from(alpha) + 127) / 255) as u8;
    let bytes: Vec<u8> = pixels
        .iter()
        .flat_map(|&[r, g, b, alpha]| [r, g, b].map(|color| over_black(color, alpha)))
        .collect();
    out.write_all(&bytes)?;
    Ok(())
}

/// 16 bits, high byte first, over black.
pub(crate) fn write_rgba16(
    size: Size,
    pixels: &[[u16; 4]],
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    write_header(b"P6", size, 65535, out)?;
    let over_black =
        |color: u16, alpha: u16| ((u64::from(color) * u64::from(alpha) + 32767) / 65535) as u16;
    let words: Vec<u16> = pixels
        .iter()
        .flat_map(|&[r, g, b, alpha]| [r, g, b].map(|color| over_black(color, alpha)))
        .collect();
    out.write_all(&big_endian(&words))?;
    Ok(())
}

/// A layer in 16 bits, grey ones as `P5`.
pub(crate) fn write_layer(
    size: Size,
    words: &LayerWords,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let (magic, words) = match words {
        LayerWords::Gray(words) => (b"P5", words.as_slice()),
        LayerWords::Rgb(pixels) => (b"P6", pixels.as_flattened()),
    };
    write_header(magic, size, 65535, out)?;
    out.write_all(&big_endian(words))?;
    Ok(())
}

fn write_header(
    magic: &[u8; 2],
    size: Size,
    largest: u16,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    out.write_all(magic)?;
    write!(out, "\n{} {}\n{largest}\n", size.width, size.height)?;
    Ok(())
}
