//! Arguments of the commands that take or copy images, as lists keep them (OpenGL 1.5, sections 3.6.4, 3.7, 3.8.1 and 3.8.2).

use crate::raster::Bitmap;
use std::sync::Arc;

/// A call with its pixels in tight rows.
#[derive(Clone, Debug)]
pub(crate) struct WithPixels<C> {
    pub(crate) call: C,
    /// Whether the bytes of elements are swapped.
    pub(crate) swap: bool,
    /// `None` for a null pointer.
    pub(crate) pixels: Option<Box<[u8]>>,
}

/// The arguments of `glTexImage1D`, `2D` or `3D` but for the pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TexImage {
    pub(crate) dimensions: usize,
    pub(crate) target: u32,
    pub(crate) level: i32,
    pub(crate) internal: u32,
    pub(crate) size: [i32; 3],
    pub(crate) border: i32,
    pub(crate) format: u32,
    pub(crate) data_type: u32,
}

/// The arguments of `glTexSubImage` but for the pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TexSubImage {
    pub(crate) dimensions: usize,
    pub(crate) target: u32,
    pub(crate) level: i32,
    pub(crate) offset: [i32; 3],
    pub(crate) size: [i32; 3],
    pub(crate) format: u32,
    pub(crate) data_type: u32,
}

/// The arguments of `glCopyTexImage`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CopyTexImage {
    pub(crate) dimensions: usize,
    pub(crate) target: u32,
    pub(crate) level: i32,
    pub(crate) internal: u32,
    /// In the framebuffer.
    pub(crate) from: [i32; 2],
    pub(crate) size: [i32; 2],
    pub(crate) border: i32,
}

/// The arguments of `glCopyTexSubImage`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CopyTexSubImage {
    pub(crate) dimensions: usize,
    pub(crate) target: u32,
    pub(crate) level: i32,
    pub(crate) offset: [i32; 3],
    pub(crate) from: [i32; 2],
    pub(crate) size: [i32; 2],
}

/// The arguments of `glDrawPixels` but for the pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrawPixels {
    pub(crate) size: [i32; 2],
    pub(crate) format: u32,
    pub(crate) data_type: u32,
}

/// A bitmap, its origin within it, and how the raster position moves.
#[derive(Clone, Debug)]
pub(crate) struct BitmapCall {
    pub(crate) bitmap: Arc<Bitmap>,
    pub(crate) origin: [f32; 2],
    pub(crate) step: [f32; 2],
}
