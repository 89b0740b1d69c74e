//! Checks of dimensions, and RGBA texels, for all decoders.
#![cfg_attr(
    not(any(feature = "jpeg", feature = "png")),
    allow(dead_code, reason = "this build has no decoder")
)]

use crate::{ErrorKind, Limits, Warning};

/// Maximum bytes of a texel: in the decoder's format, as RGBA, and in the mipmaps.
const BYTES_PER_TEXEL: u64 = 8 + 4 + 2;

/// Maximum width and height of an image, as in PNG viewers and graphics APIs.
pub(super) const LONGEST_SIDE: u32 = 65_535;

/// A decoded image.
pub(super) struct Decoded {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) texels: Vec<[u8; 4]>,
}

/// Checks dimensions before texels are allocated. A file of fewer than `bytes_needed` bytes can't
/// hold them.
pub(super) fn check(
    width: u32,
    height: u32,
    bytes: &[u8],
    bytes_needed: u64,
    limits: &Limits,
) -> Result<(), Warning> {
    if width == 0 || height == 0 || width.max(height) > LONGEST_SIDE {
        return Err(format!("the image declares {width}x{height} texels").into());
    }
    if bytes_needed > bytes.len() as u64 {
        let length = bytes.len();
        return Err(format!(
            "the image declares {width}x{height} texels, but has only {length} bytes"
        )
        .into());
    }
    let needed = u64::from(width) * u64::from(height) * BYTES_PER_TEXEL;
    if needed > limits.max_memory {
        let what = format!("an image of {width}x{height}");
        return Err(ErrorKind::TooLarge { what, needed, limit: limits.max_memory }.into());
    }
    Ok(())
}

/// A texel without alpha.
pub(super) fn opaque(rgb: &[u8]) -> [u8; 4] {
    [rgb[0], rgb[1], rgb[2], 255]
}

/// The image, if the number of texels fits its dimensions.
pub(super) fn checked_picture(
    width: u32,
    height: u32,
    texels: Vec<[u8; 4]>,
) -> Result<Decoded, Warning> {
    if texels.len() as u64 == u64::from(width) * u64::from(height) {
        Ok(Decoded { width, height, texels })
    } else {
        Err("the image has a channel layout that luxel doesn't read".into())
    }
}
