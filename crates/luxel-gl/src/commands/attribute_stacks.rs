//! `glPushAttrib`, `glPopAttrib` and the client's (OpenGL 1.5, section 6.1.13).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::limits::ATTRIBUTE_DEPTH;
use crate::objects::list::Command;

impl Context {
    /// `glPushAttrib`. `GL_STACK_OVERFLOW` if the stack is full.
    pub fn push_attrib(&mut self, mask: u32) {
        compile!(self, Command::PushAttrib(mask));
        outside_begin!(self);
        demand!(self, self.attribute_stack.len() < ATTRIBUTE_DEPTH, gl::STACK_OVERFLOW);
        let mut saved = Box::new(self.state.clone());
        if mask & gl::TEXTURE_BIT != 0 {
            let textures = self.textures();
            saved.texture.note_parameters(|target| textures.default_of(target));
        }
        self.attribute_stack.push((mask, saved));
    }

    /// `glPopAttrib`. `GL_STACK_UNDERFLOW` if nothing was pushed.
    pub fn pop_attrib(&mut self) {
        compile!(self, Command::PopAttrib);
        outside_begin!(self);
        match self.attribute_stack.pop() {
            Some((mask, saved)) => {
                self.state.restore(&saved, mask);
                self.set_drawn_color();
            }
            None => self.error.set(gl::STACK_UNDERFLOW),
        }
    }

    /// `glPushClientAttrib`.
    pub fn push_client_attrib(&mut self, mask: u32) {
        outside_begin!(self);
        demand!(self, self.client_stack.len() < ATTRIBUTE_DEPTH, gl::STACK_OVERFLOW);
        self.client_stack.push((mask, self.client));
    }

    /// `glPopClientAttrib`.
    pub fn pop_client_attrib(&mut self) {
        outside_begin!(self);
        match self.client_stack.pop() {
            Some((mask, saved)) => {
                if mask & gl::CLIENT_PIXEL_STORE_BIT != 0 {
                    (self.client.pack, self.client.unpack) = (saved.pack, saved.unpack);
                }
                if mask & gl::CLIENT_VERTEX_ARRAY_BIT != 0 {
                    self.client.arrays = saved.arrays;
                }
            }
            None => self.error.set(gl::STACK_UNDERFLOW),
        }
    }
}
