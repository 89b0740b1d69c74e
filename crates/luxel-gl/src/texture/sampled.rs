//! A complete texture as fragments see it: images and parameters of one moment.

use super::image::TextureImage;
use super::internal_format::BaseFormat;
use super::object::Target;
use super::parameters::Parameters;
use crate::enums as gl;
use luxel_scene::Filter;
use luxel_scene::texture::addressing::Addressing;
use std::sync::Arc;

/// Images with their rules of sampling; level 0 is the base level.
#[derive(Debug)]
pub(crate) struct SampledTexture {
    pub(crate) target: Target,
    /// The components that environments see; depths count as what their mode makes of them.
    pub(crate) base: BaseFormat,
    /// Of each face its levels.
    pub(crate) faces: Vec<Vec<Arc<TextureImage>>>,
    pub(crate) addressing: [Addressing; 3],
    pub(crate) magnify: Filter,
    pub(crate) minify: Filter,
    pub(crate) between: Option<Filter>,
    pub(crate) least_lod: f32,
    pub(crate) largest_lod: f32,
    pub(crate) lod_bias: f32,
    /// As [`InternalFormat::canonical`](super::InternalFormat::canonical) has it.
    pub(crate) border: [f32; 4],
    /// What a depth is compared with the third coordinate by.
    pub(crate) compare: Option<u32>,
    pub(crate) is_depth: bool,
}

impl SampledTexture {
    /// Bytes of its images.
    pub(super) fn bytes(&self) -> usize {
        self.faces.iter().flatten().map(|image| image.bytes()).sum()
    }

    /// The texture that images and parameters make, if it is complete (section 3.8.10).
    pub(super) fn new(
        target: Target,
        parameters: &Parameters,
        image: impl Fn(usize, usize) -> Option<Arc<TextureImage>>,
    ) -> Option<Self> {
        let base_level = usize::try_from(parameters.base_level).ok()?;
        let max_level = usize::try_from(parameters.max_level).ok()?;
        let dimensions = target.dimensions();
        let base = image(0, base_level)?;
        if base.is_empty() || base_level > max_level {
            return None;
        }
        let size = base.inner_size(dimensions);
        if target == Target::Cube && size[0] != size[1] {
            return None;
        }
        let largest = size[..dimensions].iter().copied().max()?.max(1);
        let last = if parameters.needs_mipmaps() {
            (base_level + largest.ilog2() as usize).min(max_level)
        } else {
            base_level
        };
        let mut faces = Vec::with_capacity(target.faces());
        for face in 0..target.faces() {
            let mut levels = Vec::with_capacity(last - base_level + 1);
            for level in base_level..=last {
                let image = image(face, level)?;
                let expected = size.map(|side| (side >> (level - base_level)).max(1));
                let matches = image.inner_size(dimensions) == expected
                    && image.name == base.name
                    && image.border == base.border;
                if !matches {
                    return None;
                }
                levels.push(image);
            }
            faces.push(levels);
        }
        let format = base.format;
        let base = match (format.is_depth(), parameters.depth_mode) {
            (false, _) => format.base,
            (true, gl::ALPHA) => BaseFormat::Alpha,
            (true, gl::INTENSITY) => BaseFormat::Intensity,
            (true, _) => BaseFormat::Luminance,
        };
        let (minify, between) = parameters.minify_filters();
        let border = parameters.border;
        Some(Self {
            target,
            base,
            faces,
            addressing: [0, 1, 2].map(|axis| {
                if axis < dimensions {
                    parameters.addressing(axis)
                } else {
                    Addressing::ClampToEdge
                }
            }),
            magnify: parameters.magnify_filter(),
            minify,
            between,
            least_lod: parameters.least_lod,
            largest_lod: parameters.largest_lod,
            lod_bias: parameters.lod_bias,
            border: format.canonical(border, 0.0, 1.0),
            compare: (format.is_depth() && parameters.compare_mode == gl::COMPARE_R_TO_TEXTURE)
                .then_some(parameters.compare_func),
            is_depth: format.is_depth(),
        })
    }
}
