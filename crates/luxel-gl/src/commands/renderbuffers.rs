//! Renderbuffers (EXT_framebuffer_object, section 4.4.2.1).

use crate::Context;
use crate::context::{demand, outside_begin};
use crate::enums as gl;
use crate::limits::{MOST_SAMPLES, VIEWPORT};
use crate::objects::framebuffer::Attachment;
use crate::objects::renderbuffer::{Planes, Renderbuffer};
use crate::raster::SAMPLES;
use crate::values::Values;

impl Context {
    /// `glGenRenderbuffers`.
    pub fn gen_renderbuffers(&mut self, count: i32) -> Vec<u32> {
        outside_begin!(self, Vec::new());
        let Ok(count) = usize::try_from(count) else {
            self.error.set(gl::INVALID_VALUE);
            return Vec::new();
        };
        let names = self.renderbuffers().generate(count);
        if names.len() < count {
            self.error.set(gl::OUT_OF_MEMORY);
        }
        names
    }

    /// `glDeleteRenderbuffers`; they are detached from what is bound.
    pub fn delete_renderbuffers(&mut self, names: &[u32]) {
        outside_begin!(self);
        for &name in names.iter().filter(|name| **name != 0) {
            self.with_images_at_rest(is_renderbuffer(name), |context| {
                context.framebuffers.detach(is_renderbuffer(name));
                context.renderbuffers().delete(name);
            });
            if self.framebuffers.renderbuffer == name {
                self.framebuffers.renderbuffer = 0;
            }
        }
    }

    /// `glIsRenderbuffer`.
    pub fn is_renderbuffer(&mut self, name: u32) -> bool {
        outside_begin!(self, false);
        self.renderbuffers().get(name).is_some()
    }

    /// `glBindRenderbuffer`.
    pub fn bind_renderbuffer(&mut self, target: u32, name: u32) {
        outside_begin!(self);
        demand!(self, target == gl::RENDERBUFFER, gl::INVALID_ENUM);
        let there = name == 0 || self.renderbuffers().bind(name);
        demand!(self, there, gl::OUT_OF_MEMORY);
        self.framebuffers.renderbuffer = name;
    }

    /// `glRenderbufferStorage` (0 samples), and `glRenderbufferStorageMultisample`: four samples (`GL_MAX_SAMPLES`), also
    /// for fewer.
    pub fn renderbuffer_storage(
        &mut self,
        target: u32,
        samples: i32,
        format: u32,
        width: i32,
        height: i32,
    ) {
        outside_begin!(self);
        demand!(self, target == gl::RENDERBUFFER, gl::INVALID_ENUM);
        let Some(planes) = Planes::of_format(format) else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        let sides = 0..=VIEWPORT;
        let sound = sides.contains(&width) && sides.contains(&height);
        let sound = sound && (0..=MOST_SAMPLES).contains(&samples);
        demand!(self, sound, gl::INVALID_VALUE);
        let name = self.framebuffers.renderbuffer;
        demand!(self, name != 0, gl::INVALID_OPERATION);
        let samples = if samples > 0 { SAMPLES } else { 0 };
        let size = [width as u32, height as u32];
        let Some(storage) = Renderbuffer::new(format, planes, samples, size) else {
            self.error.set(gl::OUT_OF_MEMORY);
            return;
        };
        self.with_images_at_rest(is_renderbuffer(name), |context| {
            if let Some(renderbuffer) = context.renderbuffers().get_mut(name) {
                *renderbuffer = storage;
            }
        });
    }

    /// `glGetRenderbufferParameter`.
    pub fn get_renderbuffer_parameter(&mut self, target: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        if target != gl::RENDERBUFFER {
            self.error.set(gl::INVALID_ENUM);
            return None;
        }
        let name = self.framebuffers.renderbuffer;
        let found = self.renderbuffers().get(name).map(|of| {
            let bits = of.planes.component_bits();
            match pname {
                gl::RENDERBUFFER_WIDTH => Some(Values::name(of.size[0])),
                gl::RENDERBUFFER_HEIGHT => Some(Values::name(of.size[1])),
                gl::RENDERBUFFER_INTERNAL_FORMAT => {
                    Some(Values::name(if of.format == 0 { gl::RGBA } else { of.format }))
                }
                gl::RENDERBUFFER_SAMPLES => Some(Values::count(of.samples)),
                gl::RENDERBUFFER_RED_SIZE..=gl::RENDERBUFFER_STENCIL_SIZE => {
                    Some(Values::count(bits[(pname - gl::RENDERBUFFER_RED_SIZE) as usize]))
                }
                _ => None,
            }
        });
        match found {
            Some(Some(values)) => return Some(values),
            Some(None) => self.error.set(gl::INVALID_ENUM),
            None => self.error.set(gl::INVALID_OPERATION),
        }
        None
    }
}

/// Whether an attached image is that renderbuffer.
fn is_renderbuffer(name: u32) -> impl Fn(&Attachment) -> bool {
    move |image| matches!(image, Attachment::Renderbuffer(of) if *of == name)
}
