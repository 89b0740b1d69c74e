//! Pixels to the program's memory (OpenGL 1.5, sections 3.6.1 and 4.3.2), and OSMesa's buffers.

use super::frame_pixels::{PixelWriter, write_bytes};
use crate::Context;
use crate::context::outside_begin;
use crate::enums as gl;
use crate::pixels::format::{Components, PixelFormat};
use crate::pixels::store::Layout;

/// How the caller's colour buffer is laid out: `OSMesaCreateContext`, `OSMesaMakeCurrent`, `OSMesaPixelStore`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColorLayout {
    /// `OSMESA_RGBA`, `_BGRA`, `_ARGB`, `_RGB`, `_BGR` or `_RGB_565`.
    pub format: u32,
    /// `GL_UNSIGNED_BYTE`, `GL_UNSIGNED_SHORT`, `GL_FLOAT`, or `GL_UNSIGNED_SHORT_5_6_5` for the last format.
    pub data_type: u32,
    /// Pixels from one row to the next; 0 for the width.
    pub row_length: usize,
    /// Whether the first row is the bottom one.
    pub y_up: bool,
}

/// OSMesa's names of formats that aren't GL's.
const OSMESA_BGRA: u32 = 1;
const OSMESA_ARGB: u32 = 2;
const OSMESA_BGR: u32 = 4;
const OSMESA_RGB_565: u32 = 5;

/// Rows that one thread writes at a time.
const BAND: usize = 16;

impl Context {
    /// `glPixelStore`; switches come as 0 or another value.
    pub fn pixel_store(&mut self, pname: u32, value: f32) {
        outside_begin!(self);
        let client = &mut self.client;
        let (first, store) = match pname {
            gl::UNPACK_SWAP_BYTES..=gl::UNPACK_ALIGNMENT
            | gl::UNPACK_SKIP_IMAGES
            | gl::UNPACK_IMAGE_HEIGHT => (gl::UNPACK_SWAP_BYTES, &mut client.unpack),
            gl::PACK_SWAP_BYTES..=gl::PACK_ALIGNMENT
            | gl::PACK_SKIP_IMAGES
            | gl::PACK_IMAGE_HEIGHT => (gl::PACK_SWAP_BYTES, &mut client.pack),
            _ => {
                self.error.set(gl::INVALID_ENUM);
                return;
            }
        };
        let whole = value.round();
        let size =
            if (0.0..=2_147_483_647.0).contains(&whole) { Some(whole as usize) } else { None };
        let field = match pname - first {
            0 => {
                store.swap_bytes = value != 0.0;
                return;
            }
            1 => {
                store.lsb_first = value != 0.0;
                return;
            }
            2 => &mut store.row_length,
            3 => &mut store.skip_rows,
            4 => &mut store.skip_pixels,
            5 => &mut store.alignment,
            _ if matches!(pname, gl::UNPACK_SKIP_IMAGES | gl::PACK_SKIP_IMAGES) => {
                &mut store.skip_images
            }
            _ => &mut store.image_height,
        };
        let is_alignment = matches!(pname, gl::UNPACK_ALIGNMENT | gl::PACK_ALIGNMENT);
        match size {
            Some(1 | 2 | 4 | 8) if is_alignment => *field = whole as usize,
            Some(size) if !is_alignment => *field = size,
            _ => self.error.set(gl::INVALID_VALUE),
        }
    }

    /// What `glReadPixels` would write: format, and where; or an error.
    fn readable(
        &self,
        [width, height]: [i32; 2],
        format: u32,
        data_type: u32,
    ) -> Result<(PixelFormat, Layout), u32> {
        let kind = PixelFormat::named(format, data_type)?;
        let (Ok(width), Ok(height)) = (usize::try_from(width), usize::try_from(height)) else {
            return Err(gl::INVALID_VALUE);
        };
        let [has_depth, has_stencil] = self.has_depth_and_stencil();
        let there = match kind.components {
            Components::Depth => has_depth,
            Components::Stencil => has_stencil,
            Components::DepthStencil => has_depth && has_stencil,
            _ => self.reads_colors(),
        };
        if !there || self.reads_samples() {
            return Err(gl::INVALID_OPERATION);
        }
        let store = &self.client.pack;
        let layout = Layout::new(store, [width, height], kind.bytes(), kind.elements.bytes());
        Ok((kind, layout))
    }

    /// Bytes that `glReadPixels` writes to, from its pointer to the last pixel's end, and skipped ones among them;
    /// 0 after an error.
    pub fn pack_bytes(&mut self, width: i32, height: i32, format: u32, data_type: u32) -> usize {
        outside_begin!(self, 0);
        let found = self
            .with_read_framebuffer(|context| context.readable([width, height], format, data_type));
        match found {
            Ok((_, layout)) => layout.end,
            Err(error) => {
                self.error.set(error);
                0
            }
        }
    }

    /// `glReadPixels`. Pixels outside of the framebuffer are left as they are; so is what a slice shorter than
    /// [`pack_bytes`](Self::pack_bytes) has no room for.
    #[expect(clippy::too_many_arguments, reason = "glReadPixels has as many")]
    pub fn read_pixels(
        &mut self,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        format: u32,
        data_type: u32,
        destination: &mut [u8],
    ) {
        outside_begin!(self);
        self.with_read_framebuffer(|context| {
            if !context.is_incomplete() {
                context.read(x, y, [width, height], (format, data_type), destination);
            }
        });
    }

    fn read(
        &mut self,
        x: i32,
        y: i32,
        [width, height]: [i32; 2],
        (format, data_type): (u32, u32),
        destination: &mut [u8],
    ) {
        let (kind, layout) = match self.readable([width, height], format, data_type) {
            Ok(readable) => readable,
            Err(error) => {
                self.error.set(error);
                return;
            }
        };
        self.carry_out();
        let [frame_width, frame_height] = self.framebuffer.size().map(i64::from);
        let (x, y) = (i64::from(x), i64::from(y));
        let rows = (-y).max(0)..i64::from(height).min(frame_height - y);
        let columns = (-x).max(0)..i64::from(width).min(frame_width - x);
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        let writer = PixelWriter {
            colors: self.frame_colors(),
            transfer: self.transfer(),
            kind,
            swap: self.client.pack.swap_bytes,
        };
        let within = (x + columns.start) as u32..(x + columns.end) as u32;
        let first = columns.start as usize * layout.pixel;
        let bytes = within.len() * layout.pixel;
        let start = layout.start + rows.start as usize * layout.stride + first;
        let Some(destination) = destination.get_mut(start..) else { return };
        let (first_y, count) = ((y + rows.start) as u32, (rows.end - rows.start) as usize);
        let write = |row: usize, words: &mut Vec<u32>, out: &mut [u8]| {
            let out = out.split_at_mut(bytes.min(out.len())).0;
            writer.write_row(first_y + row as u32, within.clone(), words, out);
        };
        if layout.stride < bytes {
            // Rows overlap: the last one counts.
            let mut words = Vec::new();
            for row in 0..count {
                let Some(out) = destination.get_mut(row * layout.stride..) else { return };
                write(row, &mut words, out);
            }
            return;
        }
        let bands = destination.chunks_mut(layout.stride.saturating_mul(BAND));
        let bands = bands.take(count.div_ceil(BAND)).enumerate();
        luxel_parallel::each(bands, &|(band, out)| {
            let mut words = Vec::new();
            for (row, out) in (band * BAND..count).zip(out.chunks_mut(layout.stride)) {
                write(row, &mut words, out);
            }
        });
    }

    /// Writes the colour buffer to the caller's memory as OSMesa does at `glFlush`, `glFinish` and when a context is
    /// left: if something was drawn since the last time. What a slice has no room for is left out.
    pub fn color_plane(&mut self, layout: ColorLayout, destination: &mut [u8]) {
        self.with_default_framebuffer(|context| context.write_color_plane(layout, destination));
    }

    fn write_color_plane(&mut self, layout: ColorLayout, destination: &mut [u8]) {
        self.carry_out();
        if !std::mem::take(&mut self.drawn) {
            return;
        }
        let order: &[usize] = match layout.format {
            gl::RGBA => &[0, 1, 2, 3],
            OSMESA_BGRA => &[2, 1, 0, 3],
            OSMESA_ARGB => &[3, 0, 1, 2],
            gl::RGB | OSMESA_RGB_565 => &[0, 1, 2],
            OSMESA_BGR => &[2, 1, 0],
            _ => return,
        };
        let format = if order.len() == 4 { gl::RGBA } else { gl::RGB };
        let Ok(kind) = PixelFormat::named(format, layout.data_type) else { return };
        let [width, height] = self.framebuffer.size().map(|side| side as usize);
        let row_length = if layout.row_length > 0 { layout.row_length } else { width };
        let stride = row_length.saturating_mul(kind.bytes());
        if stride == 0 {
            return;
        }
        let bytes = layout.data_type == gl::UNSIGNED_BYTE;
        let framebuffer = &self.framebuffer;
        let write_row = |row: usize, out: &mut [u8], words: &mut [u32]| {
            let y = if layout.y_up { row } else { height - 1 - row };
            framebuffer.color_row(y as u32, 0, words);
            if bytes {
                write_bytes(words, order, out);
                return;
            }
            for (out, word) in out.chunks_exact_mut(kind.bytes()).zip(&*words) {
                let color = word.to_le_bytes().map(|byte| f32::from(byte) / 255.0);
                let mut values = [0.0; 4];
                for (value, &place) in values.iter_mut().zip(order) {
                    *value = color[place];
                }
                kind.write(&values[..order.len()], false, out);
            }
        };
        let bands = destination.chunks_mut(stride.saturating_mul(BAND));
        let bands = bands.take(height.div_ceil(BAND)).enumerate();
        luxel_parallel::each(bands, &|(band, out)| {
            let mut words = vec![0; width];
            for (row, out) in (band * BAND..height).zip(out.chunks_mut(stride)) {
                write_row(row, out, &mut words);
            }
        });
    }

    /// Writes depths of 24 bits, the bottom row first, as `OSMesaGetDepthBuffer` shows them.
    pub fn depth_plane(&mut self, destination: &mut [u32]) {
        self.with_default_framebuffer(|context| context.write_depth_plane(destination));
    }

    fn write_depth_plane(&mut self, destination: &mut [u32]) {
        self.carry_out();
        let [width, height] = self.framebuffer.size();
        let mut out = destination.iter_mut();
        for y in 0..height {
            for x in 0..width {
                let Some(out) = out.next() else { return };
                *out = self.framebuffer.kept_depth([x, y], 0) as u32;
            }
        }
    }

    /// The pixels that may be drawn to: the window's, within the scissor box if that is enabled.
    pub(crate) fn scissored_region(&self) -> [i32; 4] {
        let [width, height] = self.framebuffer.size().map(|side| side as i32);
        if !self.state.enables.has(gl::SCISSOR_TEST) {
            return [0, 0, width, height];
        }
        let scissor = self.state.scissor;
        let end =
            |start: i32, length: i32, limit: i32| start.saturating_add(length).clamp(0, limit);
        [
            scissor.x.clamp(0, width),
            scissor.y.clamp(0, height),
            end(scissor.x, scissor.width, width),
            end(scissor.y, scissor.height, height),
        ]
    }

    /// The bits of colours that masks let through: of components that the framebuffer lacks none, so that they stay 0,
    /// but of alphas, which nobody reads then.
    pub(crate) fn color_bits(&self) -> u32 {
        let [r, g, b, _] = self.color_format().present();
        let there = [r, g, b, true];
        let mask = self.state.color.mask;
        u32::from_le_bytes(
            [0, 1, 2, 3].map(|at: usize| if mask[at] && there[at] { 0xff } else { 0 }),
        )
    }
}
