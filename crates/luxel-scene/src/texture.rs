//! Images, and textures: images with their rules of sampling.
//!
//! [`addressing`] and [`level_of_detail`] are what any sampler is made of, whatever its texels and dimensions are.

use crate::encoding::Encoding;
use mipmap::mip_chain;
use std::sync::Arc;

pub mod addressing;
pub mod level_of_detail;
mod mipmap;
mod sampler;

pub use mipmap::Taps;
pub use sampler::{Filter, Sampler, Wrap};

/// A picture with all its mipmap levels, 8 bits per channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// The name in the file or material.
    pub name: String,
    /// How its bytes stand for light.
    pub encoding: Encoding,
    /// Level 0 is the picture itself, each further one half as wide and high, down to 1x1. There
    /// is at least one, and none is without texels.
    pub levels: Vec<MipLevel>,
}

/// One mipmap level.
#[derive(Clone, Debug, PartialEq)]
pub struct MipLevel {
    /// Texels across.
    pub width: u32,
    /// Texels down.
    pub height: u32,
    /// Rows from top to bottom: red, green, blue, alpha.
    pub texels: Vec<[u8; 4]>,
}

/// Without its mipmap levels, which follow from the first.
#[cfg(feature = "serde")]
impl serde::Serialize for Image {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let base = self.levels.first();
        let size = base.map_or((0, 0), |base| (base.width, base.height));
        let texels = base.map_or(&[][..], |base| &base.texels[..]);
        (&self.name, self.encoding, size, texels).serialize(serializer)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Image {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (name, encoding, (width, height), texels) =
            <(String, Encoding, (u32, u32), Vec<[u8; 4]>)>::deserialize(deserializer)?;
        Ok(Self::new(name, encoding, width, height, texels))
    }
}

impl Image {
    /// A picture and all its mipmap levels, which take a third of the picture's memory again.
    ///
    /// `texels` are rows from top to bottom. Rows that aren't whole are dropped; if none is left,
    /// the image is the [stand-in](Self::stand_in).
    #[must_use]
    pub fn new(
        name: impl Into<String>,
        encoding: Encoding,
        width: u32,
        height: u32,
        mut texels: Vec<[u8; 4]>,
    ) -> Self {
        let rows = texels.len().checked_div(width as usize).unwrap_or(0).min(height as usize);
        if rows == 0 {
            return Self::stand_in(name);
        }
        texels.truncate(rows * width as usize);
        let base = MipLevel { width, height: rows as u32, texels };
        Self { name: name.into(), encoding, levels: mip_chain(base, encoding) }
    }

    /// The placeholder of an unreadable image: a checker of two quiet greys, which shows that
    /// something is missing and still lets form be seen.
    #[must_use]
    pub fn stand_in(name: impl Into<String>) -> Self {
        let [light, dark] = [[200, 200, 200, 255], [130, 130, 130, 255]];
        Self::new(name, Encoding::Srgb, 2, 2, vec![light, dark, dark, light])
    }
}

/// An image with its rules of sampling.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The image, shared by the textures that sample it differently.
    pub image: Arc<Image>,
    /// The rules.
    pub sampler: Sampler,
}
