//! Images of textures: `glTexImage`, `glTexSubImage`, mipmaps (OpenGL 1.5, sections 3.8.1 to 3.8.3, 3.8.8).

use crate::Context;
use crate::context::{compile, outside_begin};
use crate::enums as gl;
use crate::objects::image_calls::{TexImage, TexSubImage, WithPixels};
use crate::objects::list::Command;
use crate::pixels::format::{Components, PixelFormat};
use crate::pixels::unpack::{ImageLayout, image_bytes, without_bits};
use crate::state::pixel::PixelStore;
use crate::state::transfer::Transfer;
use crate::texture::object::ImageTarget;
use crate::texture::{InternalFormat, Target, Texels, TextureHandle, TextureImage, locked};
use std::borrow::Cow;

/// A target of an image of so many dimensions.
fn image_target(dimensions: usize, name: u32) -> Result<ImageTarget, u32> {
    ImageTarget::named(name)
        .filter(|of| of.target.dimensions() == dimensions)
        .ok_or(gl::INVALID_ENUM)
}

/// A level of a target.
fn level_of(target: Target, level: i32) -> Result<usize, u32> {
    if (0..target.levels()).contains(&level) { Ok(level as usize) } else { Err(gl::INVALID_VALUE) }
}

/// Whether the size of an image, borders included, is one that a level can have.
fn is_size(target: Target, level: usize, size: [i32; 3], border: i32) -> bool {
    let largest = (target.largest_side() >> level) as i32;
    let sides = &size[..target.dimensions()];
    let fits = sides.iter().all(|side| (2 * border..=largest + 2 * border).contains(side));
    fits && (target != Target::Cube || size[0] == size[1])
}

impl TexImage {
    /// Target, level, formats; or the error that the specification has for the arguments.
    pub(super) fn checked(&self) -> Result<(ImageTarget, usize, InternalFormat, PixelFormat), u32> {
        let image = image_target(self.dimensions, self.target)?;
        let level = level_of(image.target, self.level)?;
        let format = InternalFormat::named(self.internal).ok_or(gl::INVALID_VALUE)?;
        let is_border = matches!(self.border, 0 | 1);
        if !is_border || self.size.iter().any(|side| *side < 0) {
            return Err(gl::INVALID_VALUE);
        }
        let fits = is_size(image.target, level, self.size, self.border);
        if !fits && !image.proxy {
            return Err(gl::INVALID_VALUE);
        }
        let kind = texel_format(self.format, self.data_type)?;
        if kind.components.has_depth() != format.is_depth()
            || format.is_depth() && image.target == Target::Three
        {
            return Err(gl::INVALID_OPERATION);
        }
        Ok((image, level, format, kind))
    }
}

/// A format of pixels that become texels.
fn texel_format(format: u32, data_type: u32) -> Result<PixelFormat, u32> {
    let kind = PixelFormat::of_source(format, data_type)?;
    if kind.components == Components::Stencil { Err(gl::INVALID_OPERATION) } else { Ok(kind) }
}

fn sides(size: [i32; 3]) -> [usize; 3] {
    size.map(|side| usize::try_from(side).unwrap_or(0))
}

/// Puts pixels into an image, the first at `offset`, which counts borders.
fn fill(
    image: &mut TextureImage,
    offset: [u32; 3],
    kind: PixelFormat,
    layout: &ImageLayout,
    (swap, transfer): (bool, &Transfer),
    bytes: &[u8],
) {
    let pixel_bytes = kind.bytes();
    let format = image.format;
    let (keeps, is_depth) = (transfer.keeps_colors(), kind.components.has_depth());
    layout.each_row(bytes, |[y, z], row| {
        let [across, up, deep] = offset;
        let first = image.index([across, up + y as u32, deep + z as u32]);
        let pixels = row.chunks_exact(pixel_bytes);
        match &mut image.texels {
            Texels::Bytes(texels) if kind.is_bytes() && keeps => {
                let texels = texels.get_mut(first..).unwrap_or_default();
                for (texel, pixel) in texels.iter_mut().zip(pixels) {
                    *texel = format.canonical(kind.read_bytes(pixel), 0, 255);
                }
            }
            _ => {
                for (x, pixel) in pixels.enumerate() {
                    let values = match kind.components {
                        Components::Index => transfer.indexed(kind.read_index(swap, pixel)),
                        _ => transfer.values(kind.read(swap, pixel), is_depth),
                    };
                    image.put(first + x, values);
                }
            }
        }
    });
}

impl Context {
    /// Bytes that `glTexImage` of so many dimensions reads; 0 where it reads none: for a proxy, and for arguments that are
    /// in error.
    #[must_use]
    #[expect(clippy::too_many_arguments, reason = "glTexImage3D has as many")]
    pub fn tex_image_bytes(
        &self,
        dimensions: u32,
        target: u32,
        level: i32,
        internal: i32,
        size: [i32; 3],
        border: i32,
        format: u32,
        data_type: u32,
    ) -> usize {
        let (internal, dimensions) = (internal as u32, dimensions as usize);
        let call =
            TexImage { dimensions, target, level, internal, size, border, format, data_type };
        match call.checked() {
            Ok((image, .., kind)) if !image.proxy => {
                image_bytes(&self.client.unpack, sides(size), (kind, data_type), dimensions)
            }
            _ => 0,
        }
    }

    /// Bytes that `glTexSubImage` of so many dimensions reads; 0 for arguments that are in error. While a list is compiled
    /// these are found as far as they don't depend on the texture that is bound.
    #[must_use]
    #[expect(clippy::too_many_arguments, reason = "glTexSubImage3D has as many")]
    pub fn tex_sub_image_bytes(
        &self,
        dimensions: u32,
        target: u32,
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
        format: u32,
        data_type: u32,
    ) -> usize {
        let dimensions = dimensions as usize;
        let reads = if self.is_compiling() {
            image_target(dimensions, target).is_ok_and(|image| {
                let sides = 0..=image.target.largest_side() as i32 + 2;
                !image.proxy && size.iter().all(|side| sides.contains(side))
            })
        } else {
            self.checked_part((dimensions, target), level, offset, size).is_ok()
        };
        match texel_format(format, data_type) {
            Ok(kind) if reads => {
                image_bytes(&self.client.unpack, sides(size), (kind, data_type), dimensions)
            }
            _ => 0,
        }
    }

    /// `glTexImage1D`; without pixels the image is black.
    #[expect(clippy::too_many_arguments, reason = "glTexImage1D has as many")]
    pub fn tex_image_1d(
        &mut self,
        target: u32,
        level: i32,
        internal: i32,
        width: i32,
        border: i32,
        format: u32,
        data_type: u32,
        pixels: Option<&[u8]>,
    ) {
        let (internal, size) = (internal as u32, [width, 1, 1]);
        let dimensions = 1;
        self.tex_image(
            TexImage { dimensions, target, level, internal, size, border, format, data_type },
            pixels,
        );
    }

    /// `glTexImage2D`; without pixels the image is black.
    #[expect(clippy::too_many_arguments, reason = "glTexImage2D has as many")]
    pub fn tex_image_2d(
        &mut self,
        target: u32,
        level: i32,
        internal: i32,
        [width, height]: [i32; 2],
        border: i32,
        format: u32,
        data_type: u32,
        pixels: Option<&[u8]>,
    ) {
        let (internal, size) = (internal as u32, [width, height, 1]);
        let dimensions = 2;
        self.tex_image(
            TexImage { dimensions, target, level, internal, size, border, format, data_type },
            pixels,
        );
    }

    /// `glTexImage3D`; without pixels the image is black.
    #[expect(clippy::too_many_arguments, reason = "glTexImage3D has as many")]
    pub fn tex_image_3d(
        &mut self,
        target: u32,
        level: i32,
        internal: i32,
        size: [i32; 3],
        border: i32,
        format: u32,
        data_type: u32,
        pixels: Option<&[u8]>,
    ) {
        let internal = internal as u32;
        let dimensions = 3;
        self.tex_image(
            TexImage { dimensions, target, level, internal, size, border, format, data_type },
            pixels,
        );
    }

    fn tex_image(&mut self, mut call: TexImage, pixels: Option<&[u8]>) {
        let mut store = self.client.unpack;
        let bytes;
        let mut pixels = pixels;
        if call.data_type == gl::BITMAP && call.checked().is_ok() {
            let given = pixels.unwrap_or_default();
            let Some(unpacked) = without_bits(&store, sides(call.size), call.data_type, given)
            else {
                return self.error.set(gl::OUT_OF_MEMORY);
            };
            (store, call.data_type, bytes) = unpacked;
            pixels = pixels.map(|_| &*bytes);
        }
        // Proxies aren't compiled (section 5.4).
        let is_proxy = ImageTarget::named(call.target).is_some_and(|image| image.proxy);
        if self.is_compiling() && !is_proxy {
            let kept = pixels.and_then(|pixels| {
                let kind = texel_format(call.format, call.data_type).ok()?;
                let layout = ImageLayout::new(&store, sides(call.size), kind, call.dimensions);
                Some(layout.tight(pixels))
            });
            let kept = WithPixels { call, swap: store.swap_bytes, pixels: kept };
            compile!(self, Command::TexImage(Box::new(kept)));
        }
        self.specify(&call, pixels, &store);
    }

    /// Carries out what a list kept.
    pub(super) fn tex_image_from_list(&mut self, kept: &WithPixels<TexImage>) {
        compile!(self, Command::TexImage(Box::new(kept.clone())));
        self.specify(&kept.call, kept.pixels.as_deref(), &PixelStore::tight(kept.swap));
    }

    fn specify(&mut self, call: &TexImage, pixels: Option<&[u8]>, store: &PixelStore) {
        outside_begin!(self);
        let (of, level, format, kind) = match call.checked() {
            Ok(checked) => checked,
            Err(error) => return self.error.set(error),
        };
        let budget = self.textures().budget.clone();
        let size = call.size.map(|side| side as u32);
        let border = call.border as u32;
        if of.proxy {
            let key = (of.target as usize, level);
            let fits = is_size(of.target, level, call.size, call.border)
                && size.iter().map(|side| u64::from(*side)).product::<u64>()
                    <= crate::limits::TEXELS as u64;
            // A proxy has a shape and no texels.
            match TextureImage::new(call.internal, format, [0; 3], border, &budget).filter(|_| fits)
            {
                Some(mut image) => {
                    image.size = size;
                    self.proxies.insert(key, image);
                }
                None => {
                    self.proxies.remove(&key);
                }
            }
            return;
        }
        // What the image takes the place of is no longer needed, but by draws.
        let replaced = self.active_texture_of(of.target);
        self.leave_images(&replaced);
        let Some(mut image) = TextureImage::new(call.internal, format, size, border, &budget)
        else {
            return self.error.set(gl::OUT_OF_MEMORY);
        };
        if let Some(pixels) = pixels {
            let transfer = self.transfer();
            let layout = ImageLayout::new(store, sides(call.size), kind, call.dimensions);
            fill(&mut image, [0; 3], kind, &layout, (store.swap_bytes, &transfer), pixels);
        }
        self.put_image(of, level, image);
    }

    /// Puts an image into the bound texture, and makes the levels below if they are to follow.
    pub(super) fn put_image(&mut self, of: ImageTarget, level: usize, image: TextureImage) {
        let texture = self.active_texture_of(of.target);
        self.with_texture_at_rest(&texture, |context| {
            locked(&texture).set_image(of.face, level, image);
            context.image_changed(of, level);
        });
    }

    /// `GL_GENERATE_MIPMAP`: a change of the base level makes the levels below.
    pub(super) fn image_changed(&mut self, of: ImageTarget, level: usize) {
        let texture = self.active_texture_of(of.target);
        let mut texture = locked(&texture);
        let parameters = texture.parameters();
        if parameters.generate_mipmap
            && parameters.base_level == level as i32
            && let Err(error) = texture.generate_mipmap(of.face)
        {
            self.error.set(error);
        }
    }

    /// `glCompressedTexImage`: there is no compressed format that a program could have data of (section 3.8.3), so each
    /// is `GL_INVALID_ENUM`.
    pub fn compressed_tex_image(&mut self) {
        outside_begin!(self);
        self.error.set(gl::INVALID_ENUM);
    }

    /// `glCompressedTexSubImage`: the same.
    pub fn compressed_tex_sub_image(&mut self) {
        self.compressed_tex_image();
    }

    /// `glGetCompressedTexImage`: no image is compressed, so a level that can be has `GL_INVALID_OPERATION`.
    pub fn get_compressed_tex_image(&mut self, target: u32, level: i32) {
        outside_begin!(self);
        let of = ImageTarget::named(target).filter(|image| !image.proxy);
        let checked = of.ok_or(gl::INVALID_ENUM).and_then(|of| level_of(of.target, level));
        self.error.set(checked.err().unwrap_or(gl::INVALID_OPERATION));
    }

    /// `glGenerateMipmap`: the levels below the base level of the bound texture.
    pub fn generate_mipmap(&mut self, target: u32) {
        outside_begin!(self);
        let Some(target) = Target::named(target) else {
            return self.error.set(gl::INVALID_ENUM);
        };
        let texture = self.active_texture_of(target);
        self.with_texture_at_rest(&texture, |context| {
            if let Err(error) = generated(&texture, target) {
                context.error.set(error);
            }
        });
    }

    /// `glTexSubImage1D`, `2D`, `3D`: replaces a part of an image.
    #[expect(clippy::too_many_arguments, reason = "glTexSubImage3D has more")]
    pub fn tex_sub_image(
        &mut self,
        dimensions: u32,
        target: u32,
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
        format: u32,
        data_type: u32,
        pixels: &[u8],
    ) {
        let dimensions = dimensions as usize;
        let store = &self.client.unpack;
        let unpacked = match texel_format(format, data_type) {
            Ok(_) => without_bits(store, sides(size), data_type, pixels),
            Err(_) => Some((*store, data_type, Cow::Borrowed(pixels))),
        };
        let Some((store, data_type, pixels)) = unpacked else {
            return self.error.set(gl::OUT_OF_MEMORY);
        };
        let call = TexSubImage { dimensions, target, level, offset, size, format, data_type };
        if self.is_compiling() {
            let kept = texel_format(format, data_type).ok().map(|kind| {
                let layout = ImageLayout::new(&store, sides(size), kind, dimensions);
                layout.tight(&pixels)
            });
            let kept = WithPixels { call, swap: store.swap_bytes, pixels: kept };
            compile!(self, Command::TexSubImage(Box::new(kept)));
        }
        self.replace(&call, &pixels, &store);
    }

    /// Carries out what a list kept.
    pub(super) fn tex_sub_image_from_list(&mut self, kept: &WithPixels<TexSubImage>) {
        compile!(self, Command::TexSubImage(Box::new(kept.clone())));
        self.replace(
            &kept.call,
            kept.pixels.as_deref().unwrap_or_default(),
            &PixelStore::tight(kept.swap),
        );
    }

    fn replace(&mut self, call: &TexSubImage, pixels: &[u8], store: &PixelStore) {
        outside_begin!(self);
        let checked =
            self.checked_part((call.dimensions, call.target), call.level, call.offset, call.size);
        let (of, level, offset, is_depth) = match checked {
            Ok(checked) => checked,
            Err(error) => return self.error.set(error),
        };
        let kind = match texel_format(call.format, call.data_type) {
            Ok(kind) if kind.components.has_depth() == is_depth => kind,
            Ok(_) => return self.error.set(gl::INVALID_OPERATION),
            Err(error) => return self.error.set(error),
        };
        let layout = ImageLayout::new(store, sides(call.size), kind, call.dimensions);
        let texture = self.active_texture_of(of.target);
        let transfer = self.transfer();
        self.leave_images(&texture);
        self.with_texture_at_rest(&texture, |context| {
            if let Some(image) = locked(&texture).image_mut(of.face, level) {
                fill(image, offset, kind, &layout, (store.swap_bytes, &transfer), pixels);
            }
            context.image_changed(of, level);
        });
    }

    /// A part of an image that is there: the image, where the part begins with borders counted, whether texels are
    /// depths; or an error.
    pub(super) fn checked_part(
        &self,
        (dimensions, target): (usize, u32),
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
    ) -> Result<(ImageTarget, usize, [u32; 3], bool), u32> {
        let of = image_target(dimensions, target)?;
        if of.proxy {
            return Err(gl::INVALID_ENUM);
        }
        let level = level_of(of.target, level)?;
        if size.iter().any(|side| *side < 0) {
            return Err(gl::INVALID_VALUE);
        }
        let texture = self.active_texture_of(of.target);
        let texture = locked(&texture);
        let image = texture.image(of.face, level).ok_or(gl::INVALID_OPERATION)?;
        let mut first = [0; 3];
        for axis in 0..dimensions {
            let at = i64::from(offset[axis]) + i64::from(image.border);
            let end = at + i64::from(size[axis]);
            if at < 0 || end > i64::from(image.size[axis]) {
                return Err(gl::INVALID_VALUE);
            }
            first[axis] = at as u32;
        }
        Ok((of, level, first, image.format.is_depth()))
    }
}

/// Makes the levels below the base level of all faces, which have to be alike.
fn generated(texture: &TextureHandle, target: Target) -> Result<(), u32> {
    let mut texture = locked(texture);
    let base = usize::try_from(texture.parameters().base_level).unwrap_or(0);
    let sizes: Vec<_> = (0..target.faces())
        .map(|face| texture.image(face, base).map(|image| (image.size, image.name)))
        .collect();
    let with_stencil = texture.image(0, base).is_some_and(|image| image.format.stencil);
    if with_stencil || sizes.iter().any(|size| *size != sizes[0]) {
        return Err(gl::INVALID_OPERATION);
    }
    (0..target.faces()).try_for_each(|face| texture.generate_mipmap(face))
}
