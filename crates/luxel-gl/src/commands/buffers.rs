//! The framebuffer as a whole: clearing, choosing buffers, finishing (OpenGL 1.5, sections 4.2 and 5.5).

use super::fragments::unit;
use super::transforms::clamped;
use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::limits::VIEWPORT;
use crate::objects::framebuffer::color_place;
use crate::objects::list::Command;
use crate::raster::{Clear, Framebuffer};
use crate::state::fragment::PixelBox;

const ALL_BUFFERS: u32 =
    gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT | gl::STENCIL_BUFFER_BIT | gl::ACCUM_BUFFER_BIT;

impl Context {
    /// Gives the default framebuffer another size, black and cleared: OSMesa's buffer of the caller. The first call
    /// also sets viewport and scissor box. Sides beyond `GL_MAX_VIEWPORT_DIMS` are cut.
    pub fn resize_default(&mut self, width: u32, height: u32) {
        let [width, height] = [width, height].map(|side| side.min(VIEWPORT as u32));
        self.has_default = true;
        if !self.sized {
            self.sized = true;
            let whole = PixelBox { x: 0, y: 0, width: width as i32, height: height as i32 };
            self.state.viewport.area = whole;
            self.state.scissor = whole;
        }
        if self.default_size() != [width, height] {
            self.with_default_framebuffer(|context| {
                context.carry_out();
                let framebuffer = Framebuffer::new([width, height]);
                if framebuffer.is_none() {
                    context.error.set(gl::OUT_OF_MEMORY);
                }
                context.framebuffer = framebuffer.unwrap_or_default();
                context.accumulation = Vec::new();
            });
        }
    }

    /// Takes the default framebuffer away, until [`resize_default`](Self::resize_default) gives another one: drawing to
    /// it, or reading, is `GL_INVALID_FRAMEBUFFER_OPERATION`, as for contexts of EGL without a surface.
    pub fn remove_default(&mut self) {
        self.with_default_framebuffer(|context| {
            context.carry_out();
            context.framebuffer = Framebuffer::default();
            context.accumulation = Vec::new();
        });
        self.has_default = false;
    }

    /// Width and height of the default framebuffer.
    #[must_use]
    pub fn default_size(&self) -> [u32; 2] {
        match self.framebuffers.draw {
            0 => self.framebuffer.size(),
            _ => self.parked.size(),
        }
    }

    /// Draws what is in the log.
    pub(crate) fn carry_out(&mut self) {
        if self.stream.is_waiting() {
            self.draw_waiting();
        }
        self.drawn |= !self.log.is_empty();
        self.log.carry_out(&mut self.framebuffer, self.level);
    }

    /// `glClear`, within the scissor box and by the masks.
    pub fn clear(&mut self, mask: u32) {
        compile!(self, Command::Clear(mask));
        outside_begin!(self);
        demand!(self, mask & !ALL_BUFFERS == 0, gl::INVALID_VALUE);
        if self.is_incomplete() || self.render_mode != gl::RENDER {
            return;
        }
        let [has_depth, has_stencil] = self.has_depth_and_stencil();
        let has = |bit: u32| mask & bit != 0;
        let color = has(gl::COLOR_BUFFER_BIT) && self.state.color.draw_buffer != gl::NONE;
        let depth = has(gl::DEPTH_BUFFER_BIT) && self.state.depth.mask && has_depth;
        let stencil = has(gl::STENCIL_BUFFER_BIT) && has_stencil;
        let far = self.framebuffer.depth_kind().kept(self.state.depth.clear);
        let clear = Clear {
            region: self.scissored_region(),
            color: self.state.color.clear,
            color_mask: if color { self.color_bits() } else { 0 },
            depth: depth.then_some(far),
            stencil: stencil.then_some(self.state.stencil.clear as u8),
            stencil_mask: self.state.stencil.write_mask as u8,
        };
        self.log.clear(clear);
        self.limit_log();
        if has(gl::ACCUM_BUFFER_BIT) {
            self.clear_accumulation();
        }
    }

    /// `glClearColor`, clamped to 0..1.
    pub fn clear_color(&mut self, color: [f32; 4]) {
        compile!(self, Command::ClearColor(color));
        outside_begin!(self);
        self.state.color.clear = color.map(unit);
    }

    /// `glClearDepth`, clamped to 0..1.
    pub fn clear_depth(&mut self, depth: f64) {
        compile!(self, Command::ClearDepth(depth));
        outside_begin!(self);
        self.state.depth.clear = clamped(depth);
    }

    /// `glClearStencil`.
    pub fn clear_stencil(&mut self, value: i32) {
        compile!(self, Command::ClearStencil(value));
        outside_begin!(self);
        self.state.stencil.clear = value;
    }

    /// `glClearAccum`, clamped to -1..1.
    pub fn clear_accum(&mut self, color: [f32; 4]) {
        compile!(self, Command::ClearAccum(color));
        outside_begin!(self);
        self.state.clear_accum =
            color.map(|value| if value.is_nan() { 0.0 } else { value.clamp(-1.0, 1.0) });
    }

    /// `glClearIndex`: state only.
    pub fn clear_index(&mut self, index: f32) {
        compile!(self, Command::ClearIndex(index));
        outside_begin!(self);
        self.state.color.clear_index = index;
    }

    /// `glDrawBuffer`: there is one colour buffer, whatever its name is; or none is drawn to.
    pub fn draw_buffer(&mut self, buffer: u32) {
        compile!(self, Command::DrawBuffer(buffer));
        outside_begin!(self);
        match buffer_of(self.framebuffers.draw, buffer) {
            Ok(()) => {
                self.state.color.draw_buffer = buffer;
                self.set_drawn_color();
            }
            Err(error) => self.error.set(error),
        }
    }

    /// `glReadBuffer`.
    pub fn read_buffer(&mut self, buffer: u32) {
        compile!(self, Command::ReadBuffer(buffer));
        outside_begin!(self);
        // An object may be without any colour to read.
        let read = self.framebuffers.read;
        let single = buffer != gl::FRONT_AND_BACK && (buffer != gl::NONE || read != 0);
        match buffer_of(read, buffer) {
            Ok(()) if single => self.set_read_buffer(buffer),
            Ok(()) => self.error.set(gl::INVALID_ENUM),
            Err(error) => self.error.set(error),
        }
    }

    /// `glFlush`: draws everything so far.
    pub fn flush(&mut self) {
        outside_begin!(self);
        self.carry_out();
    }

    /// `glFinish`.
    pub fn finish(&mut self) {
        self.flush();
    }
}

/// Whether a framebuffer can have a buffer of that name.
fn buffer_of(framebuffer: u32, buffer: u32) -> Result<(), u32> {
    let of_object = framebuffer != 0;
    match buffer {
        gl::NONE => Ok(()),
        gl::COLOR_ATTACHMENT0..=gl::COLOR_ATTACHMENT15 => {
            let there = of_object && color_place(buffer).is_some();
            if there { Ok(()) } else { Err(gl::INVALID_OPERATION) }
        }
        _ => buffer_named(buffer).and(if of_object { Err(gl::INVALID_OPERATION) } else { Ok(()) }),
    }
}

/// Whether there is a colour buffer of that name: `GL_INVALID_OPERATION` for those that this framebuffer hasn't.
fn buffer_named(buffer: u32) -> Result<(), u32> {
    match buffer {
        gl::NONE | gl::FRONT | gl::BACK | gl::LEFT | gl::FRONT_LEFT | gl::BACK_LEFT => Ok(()),
        gl::FRONT_AND_BACK => Ok(()),
        gl::RIGHT | gl::FRONT_RIGHT | gl::BACK_RIGHT => Err(gl::INVALID_OPERATION),
        _ if (gl::AUX0..gl::AUX0 + 4).contains(&buffer) => Err(gl::INVALID_OPERATION),
        _ => Err(gl::INVALID_ENUM),
    }
}
