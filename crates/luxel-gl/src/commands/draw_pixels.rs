//! Images at the raster position: `glDrawPixels`, `glCopyPixels`, `glPixelZoom` (OpenGL 1.5, sections 3.6.4, 3.6.5, 4.3.3).

use super::fragments::unit;
use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::image_calls::{DrawPixels, WithPixels};
use crate::objects::list::Command;
use crate::pixels::format::{Components, PixelFormat};
use crate::pixels::unpack::{ImageLayout, image_bytes, without_bits};
use crate::raster::{Batch, ImagePixels, PlacedImage};
use crate::state::pixel::PixelStore;
use crate::state::transfer::Transfer;
use crate::vertex::Processed;
use luxel_pick::{Feedback, FeedbackVertex};
use std::borrow::Cow;

impl DrawPixels {
    /// Sides and format; or the error that the specification has for the arguments.
    fn checked(&self) -> Result<([usize; 2], PixelFormat), u32> {
        let [width, height] = self.size;
        let (Ok(width), Ok(height)) = (usize::try_from(width), usize::try_from(height)) else {
            return Err(gl::INVALID_VALUE);
        };
        Ok(([width, height], PixelFormat::of_source(self.format, self.data_type)?))
    }
}

impl Context {
    /// `glPixelZoom`.
    pub fn pixel_zoom(&mut self, x: f32, y: f32) {
        compile!(self, Command::PixelZoom([x, y]));
        outside_begin!(self);
        self.state.pixel.zoom = [x, y];
    }

    /// Bytes that `glDrawPixels` reads; 0 for arguments that are in error.
    #[must_use]
    pub fn draw_pixels_bytes(&self, size: [i32; 2], format: u32, data_type: u32) -> usize {
        match (DrawPixels { size, format, data_type }).checked() {
            Ok(([width, height], kind)) => {
                image_bytes(&self.client.unpack, [width, height, 1], (kind, data_type), 2)
            }
            Err(_) => 0,
        }
    }

    /// `glDrawPixels`: a fragment for each pixel of the window that the zoomed image covers. Colours have the depth of the
    /// raster position, depths its colours; stencil values are written as they are. An image that the slice doesn't hold
    /// whole isn't drawn.
    pub fn draw_pixels(&mut self, size: [i32; 2], format: u32, data_type: u32, pixels: &[u8]) {
        let call = DrawPixels { size, format, data_type };
        let Some((call, store, pixels)) = self.without_bits(call, pixels) else {
            return self.error.set(gl::OUT_OF_MEMORY);
        };
        if self.is_compiling() {
            let pixels = call.checked().ok().map(|([width, height], kind)| {
                ImageLayout::new(&store, [width, height, 1], kind, 2).tight(&pixels)
            });
            let kept = WithPixels { call, swap: store.swap_bytes, pixels };
            compile!(self, Command::DrawPixels(Box::new(kept)));
        }
        self.draw_image(&call, &pixels, &store);
    }

    /// The call with bytes in the place of bits, and how they are stored.
    fn without_bits<'b>(
        &self,
        call: DrawPixels,
        pixels: &'b [u8],
    ) -> Option<(DrawPixels, PixelStore, Cow<'b, [u8]>)> {
        let Ok(([width, height], _)) = call.checked() else {
            return Some((call, self.client.unpack, Cow::Borrowed(&[])));
        };
        let size = [width, height, 1];
        let (store, data_type, pixels) =
            without_bits(&self.client.unpack, size, call.data_type, pixels)?;
        Some((DrawPixels { data_type, ..call }, store, pixels))
    }

    /// Carries out what a list kept.
    pub(super) fn draw_pixels_from_list(&mut self, kept: &WithPixels<DrawPixels>) {
        compile!(self, Command::DrawPixels(Box::new(kept.clone())));
        let pixels = kept.pixels.as_deref().unwrap_or_default();
        self.draw_image(&kept.call, pixels, &PixelStore::tight(kept.swap));
    }

    fn draw_image(&mut self, call: &DrawPixels, bytes: &[u8], store: &PixelStore) {
        outside_begin!(self);
        let (size, kind) = match call.checked() {
            Ok(checked) => checked,
            Err(error) => return self.error.set(error),
        };
        if self.is_incomplete() {
            return;
        }
        let there = self.has_buffers_of(kind.components);
        demand!(self, there, gl::INVALID_OPERATION);
        if !self.state.current.raster.valid {
            return;
        }
        match self.render_mode {
            gl::RENDER => {}
            gl::FEEDBACK => return self.feed_image_back(|of| Feedback::DrawPixels(of)),
            _ => return,
        }
        let layout = ImageLayout::new(store, [size[0], size[1], 1], kind, 2);
        if layout.end == 0 || bytes.len() < layout.end {
            return;
        }
        let swap = store.swap_bytes;
        let pixel_bytes = kind.bytes();
        let mut pixels = self.no_pixels(kind.components);
        let transfer = self.transfer();
        layout.each_row(bytes, |_, row| {
            for pixel in row.chunks_exact(pixel_bytes) {
                let index = match kind.components {
                    Components::Stencil | Components::Index => kind.read_index(swap, pixel),
                    _ => 0,
                };
                match &mut pixels {
                    ImagePixels::Colors(colors) if kind.components == Components::Index => {
                        colors.push(transfer.indexed(index).map(unit));
                    }
                    _ => pixels.push(&transfer, kind.read(swap, pixel), index),
                }
            }
        });
        let window = self.state.current.raster.window;
        self.render_image(pixels, size, [window[0], window[1]]);
    }

    /// Whether the framebuffer has what pixels of a format are written to, or read from.
    pub(super) fn has_buffers_of(&self, components: Components) -> bool {
        let [has_depth, has_stencil] = self.has_depth_and_stencil();
        match components {
            Components::Depth => has_depth,
            Components::Stencil => has_stencil,
            Components::DepthStencil => has_depth && has_stencil,
            _ => true,
        }
    }

    /// Pixels of a format, as yet none.
    fn no_pixels(&self, components: Components) -> ImagePixels {
        let mask = self.state.stencil.write_mask & 255;
        match components {
            Components::Depth => ImagePixels::Depths(Vec::new()),
            Components::Stencil => ImagePixels::Stencil(Vec::new(), mask),
            Components::DepthStencil => {
                ImagePixels::DepthStencil(Vec::new(), self.state.depth.mask, mask)
            }
            _ => ImagePixels::Colors(Vec::new()),
        }
    }

    /// Draws pixels of an image, the first one's corner at a place of the window.
    fn render_image(&mut self, mut pixels: ImagePixels, size: [usize; 2], place: [f32; 2]) {
        let scale = self.window_scale();
        let Some((pipeline, viewport)) = self.begin_draw() else { return };
        let raster = &self.state.current.raster;
        let depth = scale.kind.kept(raster.window[2].into());
        let vertices = Box::new(Processed::at_raster(raster, self.state.enables.sums_colors()));
        if let (None, ImagePixels::Colors(colors)) = (&pipeline.textures, &mut pixels) {
            let secondary = vertices.secondary(0, 0);
            for color in colors.iter_mut() {
                for (value, more) in color.iter_mut().zip(secondary) {
                    *value += more;
                }
            }
        }
        let image = PlacedImage::new(pixels, size, place, self.state.pixel.zoom, pipeline.region);
        let mut batch = Batch::new(pipeline, viewport, scale, vertices);
        let piece = batch.put_image(image, depth);
        self.finish_draw(batch, vec![piece]);
    }

    fn feed_image_back(&mut self, token: for<'v> fn(&'v FeedbackVertex) -> Feedback<'v>) {
        let raster = &self.state.current.raster;
        let [x, y, depth, w] = raster.window.map(f64::from);
        let (color, texture) = (raster.color, raster.tex_coords[0]);
        let vertex = FeedbackVertex { x, y, depth, w, color, texture };
        self.feedback.put(&token(&vertex));
    }

    /// `glCopyPixels`: pixels of the framebuffer as by [`draw_pixels`](Self::draw_pixels). Those outside of it aren't drawn.
    pub fn copy_pixels(&mut self, [x, y]: [i32; 2], size: [i32; 2], buffer: u32) {
        compile!(self, Command::CopyPixels(Box::new([x, y, size[0], size[1]]), buffer));
        outside_begin!(self);
        demand!(self, size[0] >= 0 && size[1] >= 0, gl::INVALID_VALUE);
        let components = match buffer {
            gl::COLOR => Components::Colors(&[0, 1, 2, 3]),
            gl::DEPTH => Components::Depth,
            gl::STENCIL => Components::Stencil,
            gl::DEPTH_STENCIL => Components::DepthStencil,
            _ => return self.error.set(gl::INVALID_ENUM),
        };
        if self.is_incomplete() {
            return;
        }
        let there = self.has_buffers_of(components)
            && self.with_read_framebuffer(|context| context.has_buffers_of(components))
            && (buffer != gl::COLOR || self.reads_colors());
        demand!(self, there && !self.reads_samples(), gl::INVALID_OPERATION);
        if !self.state.current.raster.valid {
            return;
        }
        match self.render_mode {
            gl::RENDER => {}
            gl::FEEDBACK => return self.feed_image_back(|of| Feedback::CopyPixels(of)),
            _ => return,
        }
        let mut pixels = self.no_pixels(components);
        let read = self.with_read_framebuffer(|context| {
            if context.is_incomplete() {
                return None;
            }
            context.carry_out();
            Some(context.read_part([x, y], size, &mut pixels))
        });
        let Some([columns, rows]) = read else { return };
        let (window, zoom) = (self.state.current.raster.window, self.state.pixel.zoom);
        let place =
            [(columns.start, x), (rows.start, y)].map(|(at, from)| i64::from(at) - i64::from(from));
        let place = [0, 1].map(|axis: usize| window[axis] + place[axis] as f32 * zoom[axis]);
        self.render_image(pixels, [columns.len(), rows.len()], place);
    }

    /// Reads the part of a rectangle that lies in the framebuffer: its columns and rows.
    fn read_part(
        &self,
        from: [i32; 2],
        size: [i32; 2],
        pixels: &mut ImagePixels,
    ) -> [std::ops::Range<u32>; 2] {
        let transfer = self.transfer();
        let frame = self.framebuffer.size();
        let [columns, rows] = [0, 1].map(|axis: usize| {
            let within = |at: i64| at.clamp(0, i64::from(frame[axis])) as u32;
            let start = i64::from(from[axis]);
            within(start)..within(start + i64::from(size[axis]))
        });
        let colors = self.frame_colors();
        for y in rows.clone() {
            for x in columns.clone() {
                let at = [x, y];
                let values = match pixels {
                    ImagePixels::Colors(_) => colors.color(at),
                    _ => self.framebuffer.unit_depth_stencil(at),
                };
                pixels.push(&transfer, values, i32::from(self.framebuffer.stencil(at)));
            }
        }
        [columns, rows]
    }
}

impl ImagePixels {
    /// Appends a pixel as the transfer leaves it: its colour, or depth and stencil value from 0 to 1; and its value as a
    /// number.
    fn push(&mut self, transfer: &Transfer, values: [f32; 4], index: i32) {
        match self {
            Self::Colors(colors) => colors.push(transfer.color(values).map(unit)),
            Self::Depths(depths) => depths.push(unit(transfer.depth(values[0]))),
            Self::Stencil(all, _) => all.push(transfer.stencil(index) as u8),
            Self::DepthStencil(all, ..) => {
                let [depth, stencil, ..] = transfer.values(values, true).map(unit);
                all.push((depth, (stencil * 255.0).round() as u8));
            }
        }
    }
}
