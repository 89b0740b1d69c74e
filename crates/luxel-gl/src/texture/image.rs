//! One image of a texture: a level of it, or a level of a face.

use super::internal_format::{InternalFormat, Storage};

/// Texels in rows from the bottom up, images from front to back; red, green, blue, alpha, as
/// [`InternalFormat::canonical`] has them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Texels {
    Bytes(Vec<[u8; 4]>),
    Words(Vec<[u16; 4]>),
    Depth(Vec<f32>),
}

/// An image with its format.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TextureImage {
    /// The internal format, as it was asked for.
    pub(crate) name: u32,
    pub(crate) format: InternalFormat,
    /// Width, height and depth, borders included; 1 where there is no such dimension.
    pub(crate) size: [u32; 3],
    /// The border's width: 0 or 1.
    pub(crate) border: u32,
    pub(crate) texels: Texels,
}

impl TextureImage {
    /// An image that is black, or as near as possible; `None` if there is no memory for it.
    pub(crate) fn new(
        name: u32,
        format: InternalFormat,
        size: [u32; 3],
        border: u32,
    ) -> Option<Self> {
        fn filled<T: Clone>(count: usize, value: T) -> Option<Vec<T>> {
            let mut texels = Vec::new();
            texels.try_reserve_exact(count).ok()?;
            texels.resize(count, value);
            Some(texels)
        }
        let count = size.iter().try_fold(1_usize, |count, side| {
            count.checked_mul(*side as usize).filter(|count| *count <= crate::limits::TEXELS)
        })?;
        let texels = match format.storage {
            Storage::Bytes => Texels::Bytes(filled(count, format.canonical([0; 4], 0, 255))?),
            Storage::Words => Texels::Words(filled(count, format.canonical([0; 4], 0, u16::MAX))?),
            Storage::Depth(_) => Texels::Depth(filled(count, 0.0)?),
        };
        Some(Self { name, format, size, border, texels })
    }

    /// Whether there are no texels.
    pub(crate) fn is_empty(&self) -> bool {
        self.size.contains(&0)
    }

    /// Width, height and depth without borders.
    pub(crate) fn inner_size(&self, dimensions: usize) -> [u32; 3] {
        let mut size = self.size;
        for side in &mut size[..dimensions] {
            *side = side.saturating_sub(2 * self.border);
        }
        size
    }

    pub(crate) fn index(&self, [x, y, z]: [u32; 3]) -> usize {
        let [width, height, _] = self.size.map(|side| side as usize);
        (z as usize * height + y as usize) * width + x as usize
    }

    /// Sets a texel from red, green, blue and alpha, which are clamped (depths come as red).
    pub(crate) fn put(&mut self, index: usize, color: [f32; 4]) {
        let color = color.map(|value| if value > 0.0 { value.min(1.0) } else { 0.0 });
        let color = self.format.canonical(color, 0.0, 1.0);
        match &mut self.texels {
            Texels::Bytes(texels) => {
                if let Some(texel) = texels.get_mut(index) {
                    *texel = color.map(|value| (value * 255.0 + 0.5) as u8);
                }
            }
            Texels::Words(texels) => {
                if let Some(texel) = texels.get_mut(index) {
                    *texel = color.map(|value| (f64::from(value) * 65535.0 + 0.5) as u16);
                }
            }
            Texels::Depth(texels) => {
                if let Some(texel) = texels.get_mut(index) {
                    *texel = match self.format.storage {
                        Storage::Depth(16) => {
                            ((f64::from(color[0]) * 65535.0).round() / 65535.0) as f32
                        }
                        _ => color[0],
                    };
                }
            }
        }
    }

    /// A texel, not yet by the curve of sRGB; a depth in all four.
    pub(crate) fn get(&self, index: usize) -> [f32; 4] {
        match &self.texels {
            Texels::Bytes(texels) => texels
                .get(index)
                .map_or([0.0; 4], |texel| texel.map(|byte| f32::from(byte) / 255.0)),
            Texels::Words(texels) => texels
                .get(index)
                .map_or([0.0; 4], |texel| texel.map(|word| f32::from(word) / 65535.0)),
            Texels::Depth(texels) => [texels.get(index).copied().unwrap_or(0.0); 4],
        }
    }
}
