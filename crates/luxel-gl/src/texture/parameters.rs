//! Parameters of a texture (OpenGL 1.5, section 3.8.4, table 3.19).

use crate::enums as gl;
use luxel_scene::Filter;
use luxel_scene::texture::addressing::Addressing;

/// What `glTexParameter` sets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Parameters {
    /// Of s, t and r.
    pub(crate) wrap: [u32; 3],
    pub(crate) minify: u32,
    pub(crate) magnify: u32,
    pub(crate) border: [f32; 4],
    pub(crate) priority: f32,
    pub(crate) least_lod: f32,
    pub(crate) largest_lod: f32,
    pub(crate) base_level: i32,
    pub(crate) max_level: i32,
    pub(crate) lod_bias: f32,
    pub(crate) depth_mode: u32,
    pub(crate) compare_mode: u32,
    pub(crate) compare_func: u32,
    pub(crate) generate_mipmap: bool,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            wrap: [gl::REPEAT; 3],
            minify: gl::NEAREST_MIPMAP_LINEAR,
            magnify: gl::LINEAR,
            border: [0.0; 4],
            priority: 1.0,
            least_lod: -1000.0,
            largest_lod: 1000.0,
            base_level: 0,
            max_level: 1000,
            lod_bias: 0.0,
            depth_mode: gl::LUMINANCE,
            compare_mode: gl::NONE,
            compare_func: gl::LEQUAL,
            generate_mipmap: false,
        }
    }
}

impl Parameters {
    /// Whether minified texels come from more levels than one.
    pub(crate) fn needs_mipmaps(&self) -> bool {
        !matches!(self.minify, gl::NEAREST | gl::LINEAR)
    }

    /// Filters within a level of minified texels, and between levels.
    pub(crate) fn minify_filters(&self) -> (Filter, Option<Filter>) {
        match self.minify {
            gl::NEAREST => (Filter::Nearest, None),
            gl::LINEAR => (Filter::Linear, None),
            gl::NEAREST_MIPMAP_NEAREST => (Filter::Nearest, Some(Filter::Nearest)),
            gl::LINEAR_MIPMAP_NEAREST => (Filter::Linear, Some(Filter::Nearest)),
            gl::NEAREST_MIPMAP_LINEAR => (Filter::Nearest, Some(Filter::Linear)),
            _ => (Filter::Linear, Some(Filter::Linear)),
        }
    }

    /// The filter of magnified texels.
    pub(crate) fn magnify_filter(&self) -> Filter {
        if self.magnify == gl::NEAREST { Filter::Nearest } else { Filter::Linear }
    }

    /// How an axis wraps; `GL_CLAMP` is that of the edge where the nearest texel is taken.
    pub(crate) fn addressing(&self, axis: usize) -> Addressing {
        match self.wrap[axis] {
            gl::REPEAT => Addressing::Repeat,
            gl::MIRRORED_REPEAT => Addressing::MirroredRepeat,
            gl::CLAMP_TO_EDGE => Addressing::ClampToEdge,
            gl::CLAMP_TO_BORDER => Addressing::ClampToBorder,
            _ => Addressing::Clamp,
        }
    }
}
