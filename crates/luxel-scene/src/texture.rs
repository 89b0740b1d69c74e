//! Images and how they are sampled.

use std::sync::Arc;

/// How an image's bytes stand for light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Red, green and blue by the curve of IEC 61966-2-1; alpha linear: colours.
    Srgb,
    /// All four linear: normals, roughness, masks.
    Linear,
}

/// A picture with all its mipmap levels, 8 bits a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// What the file or material calls it.
    pub name: String,
    /// How its bytes stand for light.
    pub encoding: Encoding,
    /// Level 0 is the picture itself, each further one half as wide and high, down to 1x1.
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

/// What happens outside 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The picture repeats.
    #[default]
    Repeat,
    /// It repeats, every other one mirrored.
    MirroredRepeat,
    /// The edge goes on.
    ClampToEdge,
}

/// How texels become a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// A weighted mean of neighbours, and of mipmap levels.
    #[default]
    Linear,
}

/// The rules of sampling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sampler {
    /// Across.
    pub wrap_u: Wrap,
    /// Down.
    pub wrap_v: Wrap,
    /// Where a texel covers more than a pixel.
    pub magnify: Filter,
    /// Where a pixel covers more than a texel, within a level.
    pub minify: Filter,
    /// Between levels; `None`: only level 0 is used.
    pub mipmap: Option<Filter>,
}

impl Sampler {
    /// Repeating, trilinear: what files that say nothing get.
    #[must_use]
    pub const fn trilinear() -> Self {
        Self {
            wrap_u: Wrap::Repeat,
            wrap_v: Wrap::Repeat,
            magnify: Filter::Linear,
            minify: Filter::Linear,
            mipmap: Some(Filter::Linear),
        }
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
