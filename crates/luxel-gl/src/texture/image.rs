//! One image of a texture: a level of it, or a level of a face.

use super::internal_format::{InternalFormat, Storage};
use crate::depth::DepthPlane;
use crate::plane::Plane;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Texels in rows from the bottom up, images from front to back; red, green, blue, alpha, as
/// [`InternalFormat::canonical`] has them.
#[derive(Clone, Debug)]
pub(crate) enum Texels {
    Bytes(Vec<[u8; 4]>),
    Words(Vec<[u16; 4]>),
    /// In whole steps; nothing while it is drawn to.
    Depth(Option<DepthPlane>),
}

/// What the images of a group of contexts take, in bytes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Budget(Arc<AtomicUsize>);

/// A part of a budget, given back with the image that it is for.
#[derive(Debug)]
struct Charge {
    budget: Budget,
    bytes: usize,
}

impl Budget {
    /// Takes so many bytes; `None` if there are not as many left.
    fn charge(&self, bytes: usize) -> Option<Charge> {
        let charge = self.clone().taken(bytes);
        (self.0.load(Ordering::Relaxed) <= crate::limits::TEXTURE_BYTES).then_some(charge)
    }

    fn taken(self, bytes: usize) -> Charge {
        self.0.fetch_add(bytes, Ordering::Relaxed);
        Charge { budget: self, bytes }
    }
}

impl Clone for Charge {
    fn clone(&self) -> Self {
        self.budget.clone().taken(self.bytes)
    }
}

impl Drop for Charge {
    fn drop(&mut self) {
        self.budget.0.fetch_sub(self.bytes, Ordering::Relaxed);
    }
}

/// An image with its format.
#[derive(Clone, Debug)]
pub(crate) struct TextureImage {
    /// The internal format as queries return it.
    pub(crate) name: u32,
    pub(crate) format: InternalFormat,
    /// Width, height and depth, borders included; 1 where there is no such dimension.
    pub(crate) size: [u32; 3],
    /// The border's width: 0 or 1.
    pub(crate) border: u32,
    pub(crate) texels: Texels,
    /// Beside depths, of formats that have them; nothing while it is drawn to.
    pub(crate) stencil: Option<Plane<u32>>,
    charge: Charge,
}

impl TextureImage {
    /// An image that is black, or as near as possible; `None` if there is no memory for it.
    pub(crate) fn new(
        name: u32,
        format: InternalFormat,
        size: [u32; 3],
        border: u32,
        budget: &Budget,
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
        let bytes = match format.storage {
            Storage::Words => 8,
            _ => 4 + 4 * usize::from(format.stencil),
        };
        let charge = budget.charge(count.checked_mul(bytes)?)?;
        let texels = match format.storage {
            Storage::Bytes => Texels::Bytes(filled(count, format.canonical([0; 4], 0, 255))?),
            Storage::Words => Texels::Words(filled(count, format.canonical([0; 4], 0, u16::MAX))?),
            Storage::Depth(_) => Texels::Depth(Some(DepthPlane::new(
                format.depth_kind(),
                [size[0], size[1]],
                1,
                0.0,
            )?)),
        };
        let stencil =
            if format.stencil { Some(Plane::new([size[0], size[1]], 1, 0)?) } else { None };
        Some(Self { name: format.queried(name), format, size, border, texels, stencil, charge })
    }

    /// Bytes that it is charged with.
    pub(super) fn bytes(&self) -> usize {
        self.charge.bytes
    }

    /// What the image is charged to.
    pub(super) fn budget(&self) -> &Budget {
        &self.charge.budget
    }

    /// Whether there are no texels.
    pub(crate) fn is_empty(&self) -> bool {
        self.size.contains(&0)
    }

    /// Width, height and depth without borders.
    pub(crate) fn inner_size(&self, dimensions: usize) -> [u32; 3] {
        let mut size = self.size;
        if self.border == 0 {
            return size;
        }
        for side in &mut size[..dimensions] {
            *side = side.saturating_sub(2 * self.border);
        }
        size
    }

    pub(crate) fn index(&self, [x, y, z]: [u32; 3]) -> usize {
        let [width, height, _] = self.size.map(|side| side as usize);
        (z as usize * height + y as usize) * width + x as usize
    }

    /// Sets a texel from red, green, blue and alpha, which are clamped (depths come as red, stencil values as
    /// green).
    pub(crate) fn put(&mut self, index: usize, color: [f32; 4]) {
        let color = color.map(|value| if value > 0.0 { value.min(1.0) } else { 0.0 });
        let stencil_value = color[1];
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
            Texels::Depth(depths) => {
                let at = place(self.size, index);
                if let Some(stencil) = &mut self.stencil {
                    stencil.set(at, 0, (stencil_value * 255.0 + 0.5) as u32);
                }
                if let Some(depths) = depths {
                    let depth = match self.format.storage {
                        Storage::Depth(16) => {
                            ((f64::from(color[0]) * 65535.0).round() / 65535.0) as f32
                        }
                        _ => color[0],
                    };
                    depths.set_unit(at, 0, depth);
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
            Texels::Depth(_) => [self.depth(place(self.size, index)); 4],
        }
    }

    /// A depth from 0 to 1; 0 while it is drawn to.
    #[inline]
    pub(crate) fn depth(&self, at: [u32; 2]) -> f32 {
        match &self.texels {
            Texels::Depth(Some(depths)) => depths.unit(at, 0).unwrap_or(0.0),
            _ => 0.0,
        }
    }

    /// The stencil value of a texel; 0 without any.
    pub(crate) fn stencil(&self, index: usize) -> u32 {
        let stencil = self.stencil.as_ref();
        stencil.and_then(|plane| plane.get(place(self.size, index), 0)).unwrap_or(0)
    }
}

/// Column and row of a texel.
fn place([width, ..]: [u32; 3], index: usize) -> [u32; 2] {
    let width = width.max(1) as usize;
    [(index % width) as u32, (index / width) as u32]
}
