//! The caller's memory that OSMesa draws to, and the copy of depths that it gives out.

use crate::memory;
use luxel_gl::{ColorLayout, Context};
use std::ffi::c_void;

/// The widest and highest buffer.
pub(crate) const MOST: i32 = 16384;

/// A format of the caller's colours: `OSMESA_RGBA` and its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Format(u32);

impl Format {
    const RGBA: u32 = 0x1908;
    const BGRA: u32 = 1;
    const ARGB: u32 = 2;
    const RGB: u32 = 0x1907;
    const BGR: u32 = 4;
    const RGB_565: u32 = 5;
    const COLOR_INDEX: u32 = 0x1900;
    const UNSIGNED_BYTE: u32 = 0x1401;
    const UNSIGNED_SHORT: u32 = 0x1403;
    const FLOAT: u32 = 0x1406;
    const UNSIGNED_SHORT_5_6_5: u32 = 0x8363;

    /// The format of a new context.
    pub(crate) const DEFAULT: Self = Self(Self::RGBA);

    /// The format that a context may be created with; `BGR` and colour indices can be named but not drawn to.
    pub(crate) fn new(value: u32) -> Option<Self> {
        let known = [
            Self::RGBA,
            Self::BGRA,
            Self::ARGB,
            Self::RGB,
            Self::BGR,
            Self::RGB_565,
            Self::COLOR_INDEX,
        ];
        known.contains(&value).then_some(Self(value))
    }

    /// OSMesa's number of it.
    pub(crate) fn value(self) -> u32 {
        self.0
    }

    /// Whether colours have an alpha.
    pub(crate) fn has_alpha(self) -> bool {
        matches!(self.0, Self::RGBA | Self::BGRA | Self::ARGB)
    }

    /// The bytes of a pixel of components of the type `kind`; `None` if colours are not written like that.
    fn pixel_bytes(self, kind: u32) -> Option<usize> {
        let components = match self.0 {
            Self::RGBA | Self::BGRA | Self::ARGB => 4,
            Self::RGB => 3,
            Self::RGB_565 => return (kind == Self::UNSIGNED_SHORT_5_6_5).then_some(2),
            _ => return None,
        };
        match kind {
            Self::UNSIGNED_BYTE => Some(components),
            Self::UNSIGNED_SHORT => Some(2 * components),
            Self::FLOAT => Some(4 * components),
            _ => None,
        }
    }
}

/// The buffer that the context was made current with.
#[derive(Clone, Copy)]
pub(crate) struct Buffer {
    /// Its first byte.
    pub(crate) address: *mut c_void,
    /// The type of its components.
    pub(crate) kind: u32,
    /// Pixels in a row.
    pub(crate) width: i32,
    /// Rows.
    pub(crate) height: i32,
    pixel_bytes: usize,
}

impl Buffer {
    /// A buffer of `format`; `None` if OSMesa can't draw to it.
    pub(crate) fn new(
        format: Format,
        address: *mut c_void,
        kind: u32,
        width: i32,
        height: i32,
    ) -> Option<Self> {
        let sizes = 1..=MOST;
        if address.is_null() || !sizes.contains(&width) || !sizes.contains(&height) {
            return None;
        }
        let pixel_bytes = format.pixel_bytes(kind)?;
        Some(Self { address, kind, width, height, pixel_bytes })
    }
}

/// The default framebuffer's counterpart in the caller's memory.
pub(crate) struct Window {
    /// The format of colours.
    pub(crate) format: Format,
    /// The bits of depth of the context: 0 or 24.
    pub(crate) depth_bits: u32,
    /// The caller's buffer, once there is one.
    pub(crate) buffer: Option<Buffer>,
    /// `OSMESA_ROW_LENGTH`: pixels from a row to the next; 0 is the width.
    pub(crate) row_length: i32,
    /// `OSMESA_Y_UP`: whether the bottom row is the first.
    pub(crate) y_up: bool,
    depths: Vec<u32>,
}

impl Window {
    /// Without a buffer.
    pub(crate) fn new(format: Format, depth_bits: u32) -> Self {
        Self { format, depth_bits, buffer: None, row_length: 0, y_up: true, depths: Vec::new() }
    }

    /// Writes the colours to the caller's buffer, if something was drawn since the last time.
    ///
    /// A row length below the width would make rows overlap: then nothing is written.
    pub(crate) fn present(&mut self, gl: &mut Context) {
        let Some(buffer) = self.buffer else { return };
        let width = buffer.width.unsigned_abs() as usize;
        let row = match usize::try_from(self.row_length) {
            Ok(0) | Err(_) => width,
            Ok(row) => row,
        };
        if row < width {
            return;
        }
        let pixels = (buffer.height.unsigned_abs() as usize - 1) * row + width;
        let layout = ColorLayout {
            format: self.format.value(),
            data_type: buffer.kind,
            row_length: row,
            y_up: self.y_up,
        };
        // SAFETY: OSMesaMakeCurrent's caller keeps the buffer of this size while the context is current with it,
        // rows `OSMESA_ROW_LENGTH` apart.
        let plane = unsafe { memory::bytes_mut(buffer.address, pixels * buffer.pixel_bytes) };
        if let Some(plane) = plane {
            gl.color_plane(layout, plane);
        }
    }

    /// The depths, bottom row first: 24 bits in the low bits of four bytes. `None` without depths.
    pub(crate) fn depths(&mut self, gl: &mut Context) -> Option<(Buffer, *mut c_void)> {
        let buffer = self.buffer.filter(|_| self.depth_bits > 0)?;
        let count = buffer.width.unsigned_abs() as usize * buffer.height.unsigned_abs() as usize;
        self.depths.resize(count, 0);
        gl.depth_plane(&mut self.depths);
        Some((buffer, self.depths.as_mut_ptr().cast()))
    }
}
