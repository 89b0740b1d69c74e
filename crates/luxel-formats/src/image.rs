//! Decodes PNG and JPEG into 8-bit texels.
//!
//! Dimensions are checked against the limits, and against the most that so many bytes can encode,
//! before texels are allocated: a header can claim anything.

#[cfg(feature = "jpeg")]
mod jpeg;
#[cfg(feature = "png")]
mod png;
mod texels;

#[cfg(not(all(feature = "jpeg", feature = "png")))]
use crate::error::missing_feature;
use crate::{Limits, Warning};
use luxel_scene::{Encoding, Image};
#[cfg(not(all(feature = "jpeg", feature = "png")))]
use texels::Decoded;

/// Decodes an image; the first bytes decide its format.
pub(crate) fn decode(
    name: &str,
    bytes: &[u8],
    encoding: Encoding,
    limits: &Limits,
) -> Result<Image, Warning> {
    let decoded = if bytes.starts_with(b"\x89PNG") {
        png(bytes, limits)?
    } else if bytes.starts_with(&[0xff, 0xd8]) {
        jpeg(bytes, limits)?
    } else if bytes.is_empty() {
        return Err("the image is empty".into());
    } else {
        return Err("the image is neither PNG nor JPEG: convert it to one of them".into());
    };
    Ok(Image::new(name, encoding, decoded.width, decoded.height, decoded.texels))
}

#[cfg(feature = "png")]
use self::png::decode as png;

#[cfg(not(feature = "png"))]
fn png(_: &[u8], _: &Limits) -> Result<Decoded, Warning> {
    Err(missing_feature("PNG images", "png").into())
}

#[cfg(feature = "jpeg")]
use self::jpeg::decode as jpeg;

#[cfg(not(feature = "jpeg"))]
fn jpeg(_: &[u8], _: &Limits) -> Result<Decoded, Warning> {
    Err(missing_feature("JPEG images", "jpeg").into())
}

#[cfg(feature = "png")]
#[cfg(test)]
mod tests;
