//! Texture objects and their names (OpenGL 1.5, sections 3.8.10 to 3.8.12).

use super::image::{Budget, TextureImage};
use super::mipmap::half;
use super::parameters::Parameters;
use super::sampled::SampledTexture;
use crate::enums as gl;
use crate::limits::{CUBE_SIDE, TEXTURE_3D_SIDE, TEXTURE_LEVELS, TEXTURE_NAMES, TEXTURE_SIDE};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What a texture is: which of a unit's bindings it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    One,
    Two,
    Three,
    Cube,
}

impl Target {
    pub(crate) const ALL: [Self; 4] = [Self::One, Self::Two, Self::Three, Self::Cube];

    /// The target that a texture is bound to.
    pub(crate) fn named(name: u32) -> Option<Self> {
        Some(match name {
            gl::TEXTURE_1D => Self::One,
            gl::TEXTURE_2D => Self::Two,
            gl::TEXTURE_3D => Self::Three,
            gl::TEXTURE_CUBE_MAP => Self::Cube,
            _ => return None,
        })
    }

    /// Dimensions of an image.
    pub(crate) fn dimensions(self) -> usize {
        match self {
            Self::One => 1,
            Self::Two | Self::Cube => 2,
            Self::Three => 3,
        }
    }

    pub(crate) fn faces(self) -> usize {
        if self == Self::Cube { 6 } else { 1 }
    }

    /// The longest side of an image.
    pub(crate) fn largest_side(self) -> u32 {
        match self {
            Self::One | Self::Two => TEXTURE_SIDE,
            Self::Three => TEXTURE_3D_SIDE,
            Self::Cube => CUBE_SIDE,
        }
    }

    /// Levels that there can be.
    pub(crate) fn levels(self) -> i32 {
        self.largest_side().ilog2() as i32 + 1
    }
}

/// One image of a target: a face, or of a proxy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ImageTarget {
    pub(crate) target: Target,
    pub(crate) face: usize,
    pub(crate) proxy: bool,
}

impl ImageTarget {
    pub(crate) fn named(name: u32) -> Option<Self> {
        let of = |target, face, proxy| Some(Self { target, face, proxy });
        match name {
            gl::TEXTURE_1D => of(Target::One, 0, false),
            gl::TEXTURE_2D => of(Target::Two, 0, false),
            gl::TEXTURE_3D => of(Target::Three, 0, false),
            gl::PROXY_TEXTURE_1D => of(Target::One, 0, true),
            gl::PROXY_TEXTURE_2D => of(Target::Two, 0, true),
            gl::PROXY_TEXTURE_3D => of(Target::Three, 0, true),
            gl::PROXY_TEXTURE_CUBE_MAP => of(Target::Cube, 0, true),
            gl::TEXTURE_CUBE_MAP_POSITIVE_X..=gl::TEXTURE_CUBE_MAP_NEGATIVE_Z => {
                of(Target::Cube, (name - gl::TEXTURE_CUBE_MAP_POSITIVE_X) as usize, false)
            }
            _ => None,
        }
    }
}

/// A texture object.
#[derive(Debug)]
pub(crate) struct Texture {
    pub(crate) name: u32,
    pub(crate) target: Target,
    parameters: Parameters,
    /// Of each face its levels; a level that wasn't specified is `None`.
    images: Vec<Vec<Option<Arc<TextureImage>>>>,
    /// What fragments see, until something changes; within it `None` if the texture is incomplete.
    sampled: Option<Option<Arc<SampledTexture>>>,
}

/// A texture that units, framebuffers and names refer to.
pub(crate) type TextureHandle = Arc<Mutex<Texture>>;

/// A texture, to be looked at or changed.
pub(crate) fn locked(texture: &TextureHandle) -> MutexGuard<'_, Texture> {
    texture.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Texture {
    pub(crate) fn new(name: u32, target: Target) -> Self {
        Self {
            name,
            target,
            parameters: Parameters::default(),
            images: vec![vec![None; TEXTURE_LEVELS]; target.faces()],
            sampled: None,
        }
    }

    pub(crate) fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    pub(crate) fn parameters_mut(&mut self) -> &mut Parameters {
        self.sampled = None;
        &mut self.parameters
    }

    /// The image of a level; `None` if there is none.
    pub(crate) fn image(&self, face: usize, level: usize) -> Option<&Arc<TextureImage>> {
        self.images.get(face)?.get(level)?.as_ref()
    }

    /// The image of a level, to be changed: a copy if a draw that waits refers to it.
    pub(crate) fn image_mut(&mut self, face: usize, level: usize) -> Option<&mut TextureImage> {
        self.sampled = None;
        self.images.get_mut(face)?.get_mut(level)?.as_mut().map(Arc::make_mut)
    }

    pub(crate) fn set_image(&mut self, face: usize, level: usize, image: TextureImage) {
        self.sampled = None;
        if let Some(place) = self.images.get_mut(face).and_then(|levels| levels.get_mut(level)) {
            *place = Some(Arc::new(image));
        }
    }

    /// The texture as fragments see it; `None` if it is incomplete.
    pub(crate) fn sampled(&mut self) -> Option<Arc<SampledTexture>> {
        if self.sampled.is_none() {
            let sampled = SampledTexture::new(self.target, &self.parameters, |face, level| {
                self.image(face, level).map(Arc::clone)
            });
            self.sampled = Some(sampled.map(Arc::new));
        }
        self.sampled.clone().flatten()
    }

    /// Bytes of the images that something beside the texture looks at, as it is now: draws that wait.
    pub(crate) fn bytes_in_use(&self) -> usize {
        match &self.sampled {
            Some(Some(sampled)) if Arc::strong_count(sampled) > 1 => sampled.bytes(),
            _ => 0,
        }
    }

    /// Makes the levels of a face from its base level, as far as there are any. An error if there is no memory for them.
    pub(crate) fn generate_mipmap(&mut self, face: usize) -> Result<(), u32> {
        let Ok(base) = usize::try_from(self.parameters.base_level) else { return Ok(()) };
        let last = usize::try_from(self.parameters.max_level).unwrap_or(0);
        let dimensions = self.target.dimensions();
        let mut level = base;
        while level < last.min(TEXTURE_LEVELS - 1) {
            let Some(image) = self.image(face, level).map(Arc::clone) else { break };
            if image.is_empty() || image.inner_size(dimensions).iter().all(|side| *side <= 1) {
                break;
            }
            let below = half(&image, dimensions).ok_or(gl::OUT_OF_MEMORY)?;
            level += 1;
            self.set_image(face, level, below);
        }
        Ok(())
    }
}

/// Names of textures, and the textures that have none, of a context and of those that share with it.
#[derive(Debug)]
pub(crate) struct Textures {
    /// A name without texture was generated, but never bound.
    names: BTreeMap<u32, Option<TextureHandle>>,
    defaults: [TextureHandle; 4],
    pub(crate) budget: Budget,
}

impl Default for Textures {
    fn default() -> Self {
        let texture = |target| Arc::new(Mutex::new(Texture::new(0, target)));
        Self {
            names: BTreeMap::new(),
            defaults: Target::ALL.map(texture),
            budget: Budget::default(),
        }
    }
}

impl Textures {
    /// Takes names that nobody has; `None` if there are too many.
    pub(crate) fn generate(&mut self, count: usize) -> Option<Vec<u32>> {
        if self.names.len().saturating_add(count) > TEXTURE_NAMES {
            return None;
        }
        let mut names = Vec::with_capacity(count);
        let mut next = 1;
        while names.len() < count {
            while self.names.contains_key(&next) {
                next += 1;
            }
            self.names.insert(next, None);
            names.push(next);
        }
        Some(names)
    }

    /// The texture of target 0.
    pub(crate) fn default_of(&self, target: Target) -> TextureHandle {
        Arc::clone(&self.defaults[target as usize])
    }

    /// The texture of a name, made if there is none; an error if it has another target.
    pub(crate) fn bind(&mut self, target: Target, name: u32) -> Result<TextureHandle, u32> {
        if name == 0 {
            return Ok(self.default_of(target));
        }
        if let Some(texture) = self.get(name) {
            let same = locked(&texture).target == target;
            return if same { Ok(texture) } else { Err(gl::INVALID_OPERATION) };
        }
        if self.names.len() >= TEXTURE_NAMES && !self.names.contains_key(&name) {
            return Err(gl::OUT_OF_MEMORY);
        }
        let texture = Arc::new(Mutex::new(Texture::new(name, target)));
        self.names.insert(name, Some(Arc::clone(&texture)));
        Ok(texture)
    }

    /// The texture that a name stands for.
    pub(crate) fn get(&self, name: u32) -> Option<TextureHandle> {
        self.names.get(&name)?.as_ref().map(Arc::clone)
    }

    /// Frees a name.
    pub(crate) fn delete(&mut self, name: u32) {
        self.names.remove(&name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::InternalFormat;

    fn image(name: u32, size: [u32; 3]) -> TextureImage {
        TextureImage::new(name, InternalFormat::named(name).unwrap(), size, 0, &Budget::default())
            .unwrap()
    }

    #[test]
    fn section_3_8_10_a_texture_with_mipmaps_is_complete_with_all_levels_of_one_format() {
        let mut texture = Texture::new(1, Target::Two);
        texture.set_image(0, 0, image(gl::RGB, [4, 2, 1]));
        assert!(texture.sampled().is_none(), "the default filter needs levels");
        texture.set_image(0, 1, image(gl::RGB, [2, 1, 1]));
        texture.set_image(0, 2, image(gl::RGB, [1, 1, 1]));
        assert_eq!(texture.sampled().unwrap().faces[0].len(), 3);
        texture.set_image(0, 2, image(gl::RGBA, [1, 1, 1]));
        assert!(texture.sampled().is_none(), "another format");
        texture.parameters_mut().max_level = 1;
        assert_eq!(texture.sampled().unwrap().faces[0].len(), 2);
        texture.parameters_mut().base_level = 2;
        assert!(texture.sampled().is_none(), "the base level lies beyond the last one");
        texture.parameters_mut().base_level = 0;
        texture.parameters_mut().minify = gl::LINEAR;
        texture.set_image(0, 1, image(gl::RGB, [3, 1, 1]));
        assert!(texture.sampled().is_some(), "other levels don't count without mipmaps");
    }

    #[test]
    fn section_3_8_10_a_cube_is_complete_with_six_equal_squares() {
        let mut texture = Texture::new(1, Target::Cube);
        texture.parameters_mut().minify = gl::LINEAR;
        for face in 0..6 {
            assert!(texture.sampled().is_none());
            texture.set_image(face, 0, image(gl::RGB, [4, 4, 1]));
        }
        assert!(texture.sampled().is_some());
        texture.set_image(5, 0, image(gl::RGB, [2, 2, 1]));
        assert!(texture.sampled().is_none());
    }

    #[test]
    fn section_3_8_8_generated_levels_are_means_down_to_one_texel() {
        let mut texture = Texture::new(1, Target::Two);
        let mut base = image(gl::RGBA, [4, 2, 1]);
        for index in 0..8 {
            base.put(index, [if index % 4 < 2 { 1.0 } else { 0.0 }, 0.2, 0.0, 1.0]);
        }
        texture.set_image(0, 0, base);
        texture.generate_mipmap(0).unwrap();
        let level = texture.image(0, 1).unwrap();
        assert_eq!(level.size, [2, 1, 1]);
        assert_eq!([level.get(0)[0], level.get(1)[0]], [1.0, 0.0]);
        assert_eq!(texture.image(0, 2).unwrap().get(0)[0], 128.0 / 255.0);
        assert!(texture.image(0, 3).is_none());
        assert!(texture.sampled().is_some());
    }

    #[test]
    fn section_3_8_12_names_are_free_until_they_are_generated_or_bound() {
        let mut textures = Textures::default();
        textures.bind(Target::Two, 2).unwrap();
        assert_eq!(textures.generate(2), Some(vec![1, 3]));
        assert!(textures.get(1).is_none(), "a name is a texture when it is bound");
        assert_eq!(textures.bind(Target::One, 2).err(), Some(gl::INVALID_OPERATION));
        textures.delete(2);
        assert!(textures.bind(Target::One, 2).is_ok());
    }
}
