//! Queries of what is attached to a framebuffer (ARB_framebuffer_object, section 6.1.3).

use crate::Context;
use crate::context::outside_begin;
use crate::depth::DepthKind;
use crate::enums as gl;
use crate::objects::framebuffer::{Attachment, DEPTH, STENCIL, attachments_named};
use crate::objects::renderbuffer::Planes;
use crate::texture::{BaseFormat, locked};
use crate::values::Values;

/// What is attached at a place.
#[derive(Clone, Copy, Debug, Default)]
struct Attached {
    /// `GL_NONE`, `GL_RENDERBUFFER`, `GL_TEXTURE` or `GL_FRAMEBUFFER_DEFAULT`.
    kind: u32,
    name: u32,
    planes: Planes,
    /// Of a texture: level, face as a target or 0, layer.
    texture: Option<(usize, u32, u32)>,
    srgb: bool,
}

impl Attached {
    /// A parameter of the attachment.
    ///
    /// # Errors
    /// `GL_INVALID_OPERATION` for what nothing has, `GL_INVALID_ENUM` for names that this kind hasn't.
    fn parameter(&self, pname: u32, of_stencil: bool) -> Result<Values, u32> {
        match pname {
            gl::FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE => return Ok(Values::name(self.kind)),
            gl::FRAMEBUFFER_ATTACHMENT_OBJECT_NAME if self.kind != gl::FRAMEBUFFER_DEFAULT => {
                return Ok(Values::name(self.name));
            }
            _ => {}
        }
        let value = match (pname, self.texture) {
            (gl::FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, Some((level, ..))) => Values::count(level),
            (gl::FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE, Some((_, face, _))) => {
                Values::name(face)
            }
            (gl::FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER, Some((.., layer))) => Values::name(layer),
            (gl::FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, _) => {
                Values::name(if self.srgb { gl::SRGB } else { gl::LINEAR })
            }
            (gl::FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, _) => {
                Values::name(match self.planes.depth {
                    _ if of_stencil => gl::INDEX,
                    Some(DepthKind::Floats) => gl::FLOAT,
                    _ => gl::UNSIGNED_NORMALIZED,
                })
            }
            (gl::FRAMEBUFFER_ATTACHMENT_RED_SIZE..=gl::FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, _) => {
                let component = pname - gl::FRAMEBUFFER_ATTACHMENT_RED_SIZE;
                Values::count(self.planes.component_bits()[component as usize])
            }
            _ => return Err(gl::INVALID_ENUM),
        };
        if self.kind == gl::NONE { Err(gl::INVALID_OPERATION) } else { Ok(value) }
    }
}

impl Context {
    /// `glGetFramebufferAttachmentParameter`, also of the default framebuffer. Bits of components are those that are drawn
    /// to: of colours 8, whatever a texture keeps.
    pub fn get_framebuffer_attachment_parameter(
        &mut self,
        target: u32,
        attachment: u32,
        pname: u32,
    ) -> Option<Values> {
        outside_begin!(self, None);
        let found = self
            .attached(target, attachment)
            .and_then(|(attached, place)| attached.parameter(pname, place == STENCIL));
        found.map_err(|error| self.error.set(error)).ok()
    }

    /// What is attached to what is bound, and the first place that the name stands for.
    fn attached(&self, target: u32, attachment: u32) -> Result<(Attached, usize), u32> {
        let bound = self.framebuffers.bound(target).ok_or(gl::INVALID_ENUM)?;
        let Some(object) = self.framebuffers.get(bound) else {
            return self.default_buffer(attachment).ok_or(gl::INVALID_ENUM);
        };
        let places = attachments_named(attachment).ok_or(gl::INVALID_ENUM)?;
        let images: Vec<_> = places.iter().map(|&place| &object.attachments[place]).collect();
        let alike = images.windows(2).all(|pair| match (pair[0], pair[1]) {
            (None, None) => true,
            (Some(one), Some(other)) => one.is_of(other),
            _ => false,
        });
        if !alike {
            return Err(gl::INVALID_OPERATION);
        }
        let Some(image) = images[0] else { return Ok((Attached::default(), places[0])) };
        let (kind, name) = image.object();
        let planes = self.image_kind(image).map(|kind| kind.planes).unwrap_or_default();
        let mut attached = Attached { kind, name, planes, ..Attached::default() };
        match image {
            Attachment::Texture { texture, face, level, layer, .. } => {
                let texture = locked(texture);
                let is_cube = texture.target.faces() > 1;
                let target =
                    if is_cube { gl::TEXTURE_CUBE_MAP_POSITIVE_X + *face as u32 } else { 0 };
                attached.texture = Some((*level, target, *layer));
                let image = texture.image(*face, *level);
                attached.srgb = image.is_some_and(|image| image.format.srgb);
            }
            Attachment::Renderbuffer(name) => {
                let renderbuffers = self.renderbuffers();
                let format = renderbuffers.get(*name).map(|of| of.format);
                attached.srgb = format == Some(gl::SRGB8_ALPHA8);
            }
        }
        Ok((attached, places[0]))
    }

    /// A buffer of the default framebuffer: of colours the left ones, which are one.
    fn default_buffer(&self, name: u32) -> Option<(Attached, usize)> {
        let of = &self.configuration;
        let planes = Planes {
            color: Some(if of.alpha { BaseFormat::Rgba } else { BaseFormat::Rgb }),
            depth: (of.depth_bits > 0).then_some(DepthKind::Steps),
            stencil: of.stencil_bits > 0,
        };
        let (place, there) = match name {
            gl::FRONT_LEFT | gl::BACK_LEFT => (0, true),
            gl::DEPTH => (DEPTH, planes.depth.is_some()),
            gl::STENCIL => (STENCIL, planes.stencil),
            _ => return None,
        };
        let there = there && self.has_default;
        let kind = if there { gl::FRAMEBUFFER_DEFAULT } else { gl::NONE };
        Some((Attached { kind, planes, ..Attached::default() }, place))
    }
}
