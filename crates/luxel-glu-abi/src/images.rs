//! Images and mipmaps (GLU 1.3, chapter 3).

use crate::gl;
use crate::object::{INVALID_ENUM, INVALID_OPERATION, INVALID_VALUE, OUT_OF_MEMORY, caught};
use luxel_glu::{
    Image, ImageError, Layout, Level, PixelFormat, mipmap_count, mipmaps, nearest_power,
};
use std::ffi::c_void;
use std::{ptr, slice};

const TEXTURE_WIDTH: u32 = 0x1000;
const MAX_TEXTURE_SIZE: u32 = 0x0D33;
const MAX_3D_TEXTURE_SIZE: u32 = 0x8073;

/// The states of `glPixelStore` for unpacking: swap bytes, lowest bit first, row length, skipped rows and pixels, alignment,
/// skipped images, image height.
const UNPACK: [u32; 8] = [0x0CF0, 0x0CF1, 0x0CF2, 0x0CF3, 0x0CF4, 0x0CF5, 0x806D, 0x806E];
/// The same for packing.
const PACK: [u32; 8] = [0x0D00, 0x0D01, 0x0D02, 0x0D03, 0x0D04, 0x0D05, 0x806B, 0x806C];

/// The values of `glPixelStore`, in the order of [`UNPACK`].
#[derive(Clone, Copy)]
struct PixelStore([i32; 8]);

impl PixelStore {
    /// Rows one after another.
    const TIGHT: Self = Self([0, 0, 0, 0, 0, 1, 0, 0]);

    fn of(names: [u32; 8]) -> Self {
        Self(names.map(gl::integer))
    }

    fn layout(self, volume: bool) -> Layout {
        let size = |at: usize| usize::try_from(self.0[at]).unwrap_or(0);
        Layout {
            alignment: size(5).max(1),
            row_length: size(2),
            image_height: if volume { size(7) } else { 0 },
            skip: [size(4), size(3), if volume { size(6) } else { 0 }],
            swap_bytes: self.0[0] != 0,
            lsb_first: self.0[1] != 0,
        }
    }

    /// Makes OpenGL unpack like this. Only what differs is set, since versions before 1.2 know no images.
    fn unpack(self, before: Self) {
        for at in (0..8).filter(|&at| self.0[at] != before.0[at]) {
            // SAFETY: the function takes no pointer.
            unsafe { gl::glPixelStorei(UNPACK[at], self.0[at]) };
        }
    }
}

/// 0, or the error of GLU. A panic is one, too.
fn outcome(work: impl FnOnce() -> Result<(), ImageError>) -> u32 {
    match caught(work) {
        Some(Ok(())) => 0,
        Some(Err(ImageError::Enum)) => INVALID_ENUM,
        Some(Err(ImageError::Value)) => INVALID_VALUE,
        Some(Err(ImageError::Operation)) => INVALID_OPERATION,
        Some(Err(ImageError::Memory)) | None => OUT_OF_MEMORY,
    }
}

/// Sizes that an image can have.
fn sizes<const N: usize>(sizes: [i32; N]) -> Result<[usize; N], ImageError> {
    let mut made = [1; N];
    for (made, size) in made.iter_mut().zip(sizes) {
        *made = usize::try_from(size).map_err(|_| ImageError::Value)?;
    }
    Ok(made)
}

/// The image at an address, as OpenGL unpacks it.
///
/// # Safety
///
/// The address is null, or an image of this size and format can be read there.
unsafe fn read(
    data: *const c_void,
    format: PixelFormat,
    size: [usize; 3],
    layout: &Layout,
) -> Result<Image, ImageError> {
    let length = layout.span(format, size)?;
    if data.is_null() {
        return Err(ImageError::Value);
    }
    // SAFETY: the caller of this function promises as many bytes as `span` counts.
    let memory = unsafe { slice::from_raw_parts(data.cast(), length) };
    Image::read(memory, layout, format, size)
}

/// Scales an image. Returns 0 or an error.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
unsafe extern "C" fn gluScaleImage(
    format: u32,
    width_in: i32,
    height_in: i32,
    type_in: u32,
    data_in: *const c_void,
    width_out: i32,
    height_out: i32,
    type_out: u32,
    data_out: *mut c_void,
) -> u32 {
    outcome(|| {
        let [w_in, h_in, w_out, h_out] = sizes([width_in, height_in, width_out, height_out])?;
        let from = PixelFormat::new(format, type_in)?;
        let to = PixelFormat::new(format, type_out)?;
        if [w_in, h_in, w_out, h_out].contains(&0) {
            return Ok(());
        }
        let (size_in, size_out) = ([w_in, h_in, 1], [w_out, h_out, 1]);
        let store = PixelStore::of(UNPACK).layout(false);
        // SAFETY: the caller passes an image that OpenGL would unpack.
        let image = unsafe { read(data_in, from, size_in, &store) }?.scaled(size_out)?;
        let layout = PixelStore::of(PACK).layout(false);
        let length = layout.span(to, size_out)?;
        if data_out.is_null() {
            return Err(ImageError::Value);
        }
        // SAFETY: the caller passes room for the image as OpenGL would pack it.
        let memory = unsafe { slice::from_raw_parts_mut(data_out.cast(), length) };
        image.write(memory, &layout, to);
        Ok(())
    })
}

/// A texture to be built: what the functions for one, two and three dimensions have in common.
struct Build {
    dimensions: usize,
    target: u32,
    internal: i32,
    size: [i32; 3],
    format: u32,
    kind: u32,
    data: *const c_void,
}

impl Build {
    /// The proxy target, by which a program asks whether a texture fits.
    fn proxy(&self) -> u32 {
        match (self.dimensions, self.target) {
            (1, _) => 0x8063,               // GL_PROXY_TEXTURE_1D
            (2, 0x8515..=0x851A) => 0x851B, // GL_PROXY_TEXTURE_CUBE_MAP
            (2, _) => 0x8064,               // GL_PROXY_TEXTURE_2D
            _ => 0x8070,                    // GL_PROXY_TEXTURE_3D
        }
    }

    /// Sets a level of a texture; without pixels if the address is null.
    fn set(&self, target: u32, level: i32, size: [usize; 3], pixels: *const c_void) {
        let [w, h, d] = size.map(|side| i32::try_from(side).unwrap_or(i32::MAX));
        let (internal, format, kind) = (self.internal, self.format, self.kind);
        // SAFETY: the pixels are null, or of this size with rows one after another, as OpenGL then unpacks them.
        unsafe {
            match self.dimensions {
                1 => gl::glTexImage1D(target, level, internal, w, 0, format, kind, pixels),
                2 => gl::glTexImage2D(target, level, internal, w, h, 0, format, kind, pixels),
                _ => gl::glTexImage3D(target, level, internal, w, h, d, 0, format, kind, pixels),
            }
        }
    }

    /// The powers of two next to a size, or less if OpenGL can't have a texture so large.
    fn fitting(&self, size: [usize; 3]) -> [usize; 3] {
        let limit = if self.dimensions == 3 { MAX_3D_TEXTURE_SIZE } else { MAX_TEXTURE_SIZE };
        // The least that OpenGL 1.5 allows, where a query fails.
        let limit = usize::try_from(gl::integer(limit)).unwrap_or(0).max(16);
        let mut size = size.map(|side| nearest_power(side).min(nearest_power(limit)));
        loop {
            let mut width = 0;
            self.set(self.proxy(), 0, size, ptr::null());
            // SAFETY: the width of a texture is one value.
            unsafe {
                gl::glGetTexLevelParameteriv(self.proxy(), 0, TEXTURE_WIDTH, &raw mut width);
            }
            if width != 0 || size == [1; 3] {
                return size;
            }
            size = size.map(|side| (side / 2).max(1));
        }
    }

    /// Builds all levels, from an image of any size.
    ///
    /// # Safety
    ///
    /// `data` leads to an image that OpenGL would unpack.
    unsafe fn all(&self) -> u32 {
        outcome(|| {
            let (format, size) = self.checked()?;
            let before = PixelStore::of(UNPACK);
            let layout = before.layout(self.dimensions == 3);
            // SAFETY: the caller of this function promises it.
            let image = unsafe { read(self.data, format, size, &layout) }?;
            let image = image.scaled(self.fitting(size))?;
            let levels = mipmaps(&image, format, 0, mipmap_count(image.size))?;
            self.upload(&levels, 0, before);
            Ok(())
        })
    }

    /// Builds the levels from `base` to `last`, where the image is level `user`.
    ///
    /// # Safety
    ///
    /// `data` leads to an image that OpenGL would unpack.
    unsafe fn levels(&self, [user, base, last]: [i32; 3]) -> u32 {
        outcome(|| {
            let (format, size) = self.checked()?;
            let deepest = i64::from(user) + i64::from(mipmap_count(size));
            let ordered = 0 <= user && user <= base && base <= last && i64::from(last) <= deepest;
            if !ordered || size.iter().any(|side| !side.is_power_of_two()) {
                return Err(ImageError::Value);
            }
            let before = PixelStore::of(UNPACK);
            let layout = before.layout(self.dimensions == 3);
            // SAFETY: the caller of this function promises it.
            let image = unsafe { read(self.data, format, size, &layout) }?;
            let below = |level: i32| (level - user).unsigned_abs();
            let levels = mipmaps(&image, format, below(base), below(last))?;
            self.upload(&levels, base, before);
            Ok(())
        })
    }

    /// Format and size, if they are any.
    fn checked(&self) -> Result<(PixelFormat, [usize; 3]), ImageError> {
        let size = sizes(self.size)?;
        if size.contains(&0) {
            return Err(ImageError::Value);
        }
        Ok((PixelFormat::new(self.format, self.kind)?, size))
    }

    fn upload(&self, levels: &[Level], base: i32, before: PixelStore) {
        PixelStore::TIGHT.unpack(before);
        for (level, number) in levels.iter().zip(base..) {
            self.set(self.target, number, level.size, level.pixels.as_ptr().cast());
        }
        before.unpack(PixelStore::TIGHT);
    }
}

/// The functions for one, two and three dimensions, which differ by their sizes.
macro_rules! builders {
    ($($dimensions:literal $all:ident $levels:ident ($($side:ident),*) $size:expr;)*) => {$(
        #[doc = concat!("Builds a texture with all its levels (`", stringify!($all), "`). Returns 0 or an error.")]
        #[unsafe(no_mangle)]
        #[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
        unsafe extern "C" fn $all(
            target: u32,
            internal: i32,
            $($side: i32,)*
            format: u32,
            kind: u32,
            data: *const c_void,
        ) -> u32 {
            let build = Build { dimensions: $dimensions, target, internal, size: $size, format, kind, data };
            // SAFETY: the caller passes an image that OpenGL would unpack.
            unsafe { build.all() }
        }

        #[doc = concat!("Builds some levels of a texture (`", stringify!($levels), "`). Returns 0 or an error.")]
        #[unsafe(no_mangle)]
        #[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
        unsafe extern "C" fn $levels(
            target: u32,
            internal: i32,
            $($side: i32,)*
            format: u32,
            kind: u32,
            level: i32,
            base: i32,
            last: i32,
            data: *const c_void,
        ) -> u32 {
            let build = Build { dimensions: $dimensions, target, internal, size: $size, format, kind, data };
            // SAFETY: the caller passes an image that OpenGL would unpack.
            unsafe { build.levels([level, base, last]) }
        }
    )*};
}

builders! {
    1 gluBuild1DMipmaps gluBuild1DMipmapLevels (width) [width, 1, 1];
    2 gluBuild2DMipmaps gluBuild2DMipmapLevels (width, height) [width, height, 1];
    3 gluBuild3DMipmaps gluBuild3DMipmapLevels (width, height, depth) [width, height, depth];
}
