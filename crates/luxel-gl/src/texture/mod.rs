//! Textures (OpenGL 1.5, section 3.8): formats of texels, images, objects with their parameters.

pub(crate) mod image;
pub(crate) mod internal_format;
mod mipmap;
pub(crate) mod object;
pub(crate) mod parameters;
pub(crate) mod sampled;

pub(crate) use image::{Texels, TextureImage};
pub(crate) use internal_format::{BaseFormat, InternalFormat, is_compressed};
pub(crate) use object::{ImageTarget, Target, TextureHandle, Textures, locked};
pub(crate) use parameters::Parameters;
pub(crate) use sampled::SampledTexture;
