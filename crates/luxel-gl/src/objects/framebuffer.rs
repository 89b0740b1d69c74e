//! Framebuffer objects (EXT_framebuffer_object, ARB_framebuffer_object): which images are drawn to.

use crate::enums as gl;
use crate::limits::FRAMEBUFFER_NAMES;
use crate::texture::TextureHandle;
use std::collections::BTreeMap;
use std::sync::Arc;

/// An image that is attached.
#[derive(Clone, Debug)]
pub(crate) enum Attachment {
    Renderbuffer(u32),
    Texture { name: u32, texture: TextureHandle, face: usize, level: usize, layer: u32 },
}

impl Attachment {
    /// Whether two are the same object's, of which a texture has several images.
    pub(crate) fn is_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Renderbuffer(own), Self::Renderbuffer(others)) => own == others,
            (Self::Texture { texture, .. }, Self::Texture { texture: other, .. }) => {
                Arc::ptr_eq(texture, other)
            }
            _ => false,
        }
    }

    /// Type and name, as queries return them.
    pub(crate) fn object(&self) -> (u32, u32) {
        match self {
            Self::Renderbuffer(name) => (gl::RENDERBUFFER, *name),
            Self::Texture { name, .. } => (gl::TEXTURE, *name),
        }
    }
}

/// A framebuffer object: colours, of which one is drawn to and one is read, depth, stencil.
#[derive(Clone, Debug)]
pub(crate) struct FramebufferObject {
    pub(crate) attachments: [Option<Attachment>; COLORS + 2],
    pub(crate) draw_buffer: u32,
    pub(crate) read_buffer: u32,
}

/// How many colours can be attached, at the first places (`GL_MAX_COLOR_ATTACHMENTS`).
pub(crate) const COLORS: usize = 8;
/// Places of the other attachments.
pub(crate) const DEPTH: usize = COLORS;
pub(crate) const STENCIL: usize = COLORS + 1;

/// The place of a colour by the buffer's name, 0 for `GL_NONE`; `None` for names that aren't an attachment's.
pub(crate) fn color_place(buffer: u32) -> Option<usize> {
    match buffer {
        gl::NONE => Some(0),
        _ => {
            let place = buffer.wrapping_sub(gl::COLOR_ATTACHMENT0) as usize;
            (place < COLORS).then_some(place)
        }
    }
}

/// The attachments that a name stands for; `None` for one that isn't one.
pub(crate) fn attachments_named(name: u32) -> Option<&'static [usize]> {
    const PLACES: [usize; COLORS] = [0, 1, 2, 3, 4, 5, 6, 7];
    let color = (name != gl::NONE).then(|| color_place(name)).flatten();
    if let Some(place) = color {
        return PLACES.get(place..=place);
    }
    Some(match name {
        gl::DEPTH_ATTACHMENT => &[DEPTH],
        gl::STENCIL_ATTACHMENT => &[STENCIL],
        gl::DEPTH_STENCIL_ATTACHMENT => &[DEPTH, STENCIL],
        _ => return None,
    })
}

impl Default for FramebufferObject {
    fn default() -> Self {
        Self {
            attachments: std::array::from_fn(|_| None),
            draw_buffer: gl::COLOR_ATTACHMENT0,
            read_buffer: gl::COLOR_ATTACHMENT0,
        }
    }
}

/// The framebuffer objects of a context, and what is bound; 0 is the default framebuffer.
#[derive(Debug, Default)]
pub(crate) struct FramebufferObjects {
    names: BTreeMap<u32, Option<FramebufferObject>>,
    pub(crate) draw: u32,
    pub(crate) read: u32,
    pub(crate) renderbuffer: u32,
    /// The place of the colour that is drawn to, or read for a moment.
    pub(crate) color: usize,
    /// The buffers of the default framebuffer, while an object is bound for drawing.
    pub(crate) default_buffers: [u32; 2],
}

impl FramebufferObjects {
    pub(crate) fn generate(&mut self, count: usize) -> Vec<u32> {
        super::names::generate(&mut self.names, count, FRAMEBUFFER_NAMES)
    }

    pub(crate) fn bind(&mut self, name: u32) -> bool {
        super::names::bind(&mut self.names, name, FRAMEBUFFER_NAMES)
    }

    pub(crate) fn get(&self, name: u32) -> Option<&FramebufferObject> {
        self.names.get(&name)?.as_ref()
    }

    pub(crate) fn get_mut(&mut self, name: u32) -> Option<&mut FramebufferObject> {
        self.names.get_mut(&name)?.as_mut()
    }

    pub(crate) fn delete(&mut self, name: u32) {
        self.names.remove(&name);
    }

    /// Whether two framebuffers are one, or draw to the same image.
    pub(crate) fn share_images(&self, one: u32, other: u32) -> bool {
        let images = |name: u32| {
            self.get(name).into_iter().flat_map(|object| object.attachments.iter().flatten())
        };
        one == other || images(one).any(|image| images(other).any(|of| image.is_of(of)))
    }

    /// Detaches images from what is bound.
    pub(crate) fn detach(&mut self, is_image: impl Fn(&Attachment) -> bool) {
        for bound in [self.draw, self.read] {
            if let Some(object) = self.get_mut(bound) {
                for image in &mut object.attachments {
                    if image.as_ref().is_some_and(&is_image) {
                        *image = None;
                    }
                }
            }
        }
    }

    /// What is bound to a target; `None` for a target that isn't one.
    pub(crate) fn bound(&self, target: u32) -> Option<u32> {
        match target {
            gl::FRAMEBUFFER | gl::DRAW_FRAMEBUFFER => Some(self.draw),
            gl::READ_FRAMEBUFFER => Some(self.read),
            _ => None,
        }
    }
}
