//! Mipmaps: each level half as wide, high and deep as the one before it.

use super::{Image, ImageError, Layout, PixelFormat};

/// A level of a texture, its rows one after another.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Width, height, depth.
    pub size: [usize; 3],
    /// The pixels.
    pub pixels: Vec<u8>,
}

/// The power of two that is nearest to a size: from three quarters on the next one.
#[must_use]
pub fn nearest_power(size: usize) -> usize {
    let power = 1usize << size.max(1).ilog2();
    if size - power.min(size) >= power.div_ceil(2) && power > 1 { power * 2 } else { power }
}

/// How many levels a texture has below one of this size: down to a single pixel.
#[must_use]
pub fn mipmap_count(size: [usize; 3]) -> u32 {
    size.iter().max().map_or(0, |&most| most.max(1).ilog2())
}

/// The levels `first..=last` of a texture, of which `image` is level 0.
///
/// # Errors
///
/// [`ImageError::Memory`].
pub fn mipmaps(
    image: &Image,
    format: PixelFormat,
    first: u32,
    last: u32,
) -> Result<Vec<Level>, ImageError> {
    let mut levels = Vec::new();
    let mut halved: Option<Image> = None;
    for number in 0..=last {
        let level = halved.as_ref().unwrap_or(image);
        if number >= first {
            let mut pixels = vec![0; Layout::TIGHT.span(format, level.size)?];
            level.write(&mut pixels, &Layout::TIGHT, format);
            levels.push(Level { size: level.size, pixels });
        }
        if number < last {
            halved = Some(level.scaled(level.size.map(|side| (side / 2).max(1)))?);
        }
    }
    Ok(levels)
}
