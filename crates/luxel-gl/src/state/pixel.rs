//! How pixels lie in the program's memory (OpenGL 1.5, section 3.6.1, table 3.1).

use super::arrays::Arrays;
use super::transfer::PixelTransfer;

/// One direction of transfers: packing, or unpacking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PixelStore {
    pub(crate) swap_bytes: bool,
    pub(crate) lsb_first: bool,
    pub(crate) row_length: usize,
    pub(crate) image_height: usize,
    pub(crate) skip_rows: usize,
    pub(crate) skip_pixels: usize,
    pub(crate) skip_images: usize,
    pub(crate) alignment: usize,
}

impl Default for PixelStore {
    fn default() -> Self {
        Self {
            swap_bytes: false,
            lsb_first: false,
            row_length: 0,
            image_height: 0,
            skip_rows: 0,
            skip_pixels: 0,
            skip_images: 0,
            alignment: 4,
        }
    }
}

impl PixelStore {
    /// Rows without gaps.
    pub(crate) fn tight(swap_bytes: bool) -> Self {
        Self { alignment: 1, swap_bytes, ..Self::default() }
    }
}

/// How pixels change on their way (`GL_PIXEL_MODE_BIT`, table 6.22).
#[derive(Clone, Debug)]
pub(crate) struct PixelMode {
    /// What a pixel of an image becomes as large as, to the right and upwards.
    pub(crate) zoom: [f32; 2],
    pub(crate) transfer: PixelTransfer,
}

impl Default for PixelMode {
    fn default() -> Self {
        Self { zoom: [1.0; 2], transfer: PixelTransfer::default() }
    }
}

/// The client's state, saved by `glPushClientAttrib`: storage in both directions, vertex arrays.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Client {
    pub(crate) arrays: Arrays,
    pub(crate) pack: PixelStore,
    pub(crate) unpack: PixelStore,
}
