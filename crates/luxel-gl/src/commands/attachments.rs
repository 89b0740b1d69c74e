//! Images of framebuffer objects: their planes are taken when an object is bound for drawing, and given back when it is
//! left, or when a command is about to look at one of them.
//!
//! Planes of renderbuffers and of textures of depth are moved; colours of textures are copied, since textures keep them
//! in rows.

use crate::Context;
use crate::limits::VIEWPORT;
use crate::objects::framebuffer::{Attachment, COLORS, DEPTH, FramebufferObject, STENCIL};
use crate::objects::renderbuffer::Planes;
use crate::plane::Plane;
use crate::raster::Framebuffer;
use crate::texture::{Texels, TextureHandle, TextureImage, locked};
use std::sync::Arc;

/// What is known of an attached image.
#[derive(Clone, Copy, Debug)]
pub(super) struct ImageKind {
    pub(super) size: [u32; 2],
    pub(super) planes: Planes,
    /// Samples of a pixel.
    pub(super) samples: usize,
}

impl Context {
    /// An attached image; `None` if it isn't there any more.
    pub(super) fn image_kind(&self, of: &Attachment) -> Option<ImageKind> {
        match of {
            Attachment::Renderbuffer(name) => {
                let renderbuffers = self.renderbuffers();
                let of = renderbuffers.get(*name)?;
                Some(ImageKind { size: of.size, planes: of.planes, samples: of.samples.max(1) })
            }
            Attachment::Texture { texture, face, level, layer, .. } => {
                let texture = locked(texture);
                let image = texture.image(*face, *level).filter(|image| *layer < image.size[2])?;
                let planes = Planes::of_texels(image.format);
                Some(ImageKind { size: [image.size[0], image.size[1]], planes, samples: 1 })
            }
        }
    }

    /// Attachments with their places: of colours the one that is drawn to.
    fn used<'o>(
        &self,
        object: &'o FramebufferObject,
    ) -> impl Iterator<Item = (usize, &'o Option<Attachment>)> + use<'o> {
        [self.framebuffers.color, DEPTH, STENCIL]
            .into_iter()
            .map(|place| (place, &object.attachments[place]))
    }

    /// Gives the planes of what is drawn to back to the images of the object that is bound for drawing.
    pub(crate) fn store_attachments(&mut self) {
        self.carry_out();
        let Some(object) = self.framebuffers.get(self.framebuffers.draw).cloned() else { return };
        let mut framebuffer = std::mem::take(&mut self.framebuffer);
        let size = framebuffer.size;
        for (place, attachment) in self.used(&object) {
            match attachment {
                Some(Attachment::Renderbuffer(name)) => {
                    let mut renderbuffers = self.renderbuffers();
                    let Some(of) = renderbuffers.get_mut(*name) else { continue };
                    match place {
                        0..COLORS => give(&mut of.color, framebuffer.color.take()),
                        DEPTH => give(&mut of.depth, framebuffer.depth.take()),
                        _ => give(&mut of.stencil, framebuffer.stencil.take()),
                    }
                }
                Some(Attachment::Texture { texture, face, level, layer, .. }) => {
                    if place < COLORS && !framebuffer.changed {
                        continue;
                    }
                    let mut texture = locked(texture);
                    let Some(image) = texture.image_mut(*face, *level) else { continue };
                    match (place, &mut image.texels) {
                        (0..COLORS, _) => {
                            if let Some(colors) = &framebuffer.color {
                                store_colors(image, *layer, colors, size);
                            }
                        }
                        (DEPTH, Texels::Depth(depths)) => give(depths, framebuffer.depth.take()),
                        (STENCIL, _) => give(&mut image.stencil, framebuffer.stencil.take()),
                        _ => {}
                    }
                }
                None => {}
            }
        }
    }

    /// Takes the planes of an object's images. An image that has no plane for its place gives none.
    pub(super) fn load_attachments(&mut self, object: &FramebufferObject) {
        let kinds = object.attachments.iter().flatten().filter_map(|of| self.image_kind(of));
        let smaller = |a: [u32; 2], b: [u32; 2]| [a[0].min(b[0]), a[1].min(b[1])];
        let size = kinds.map(|kind| kind.size).reduce(smaller).unwrap_or([0; 2]);
        let size = size.map(|side| side.min(VIEWPORT as u32));
        let mut framebuffer = Framebuffer { size, ..Framebuffer::default() };
        for (place, attachment) in self.used(object) {
            match attachment {
                Some(Attachment::Renderbuffer(name)) => {
                    let mut renderbuffers = self.renderbuffers();
                    let Some(of) = renderbuffers.get_mut(*name) else { continue };
                    match place {
                        0..COLORS => framebuffer.color = of.color.take(),
                        DEPTH => framebuffer.depth = of.depth.take(),
                        _ => framebuffer.stencil = of.stencil.take(),
                    }
                }
                Some(Attachment::Texture { texture, face, level, layer, .. }) => {
                    let mut texture = locked(texture);
                    if place < COLORS {
                        let image = texture.image(*face, *level).map(Arc::clone);
                        framebuffer.color = image.and_then(|image| load_colors(&image, *layer));
                        continue;
                    }
                    let Some(image) = texture.image_mut(*face, *level) else { continue };
                    match (place, &mut image.texels) {
                        (DEPTH, Texels::Depth(depths)) => framebuffer.depth = depths.take(),
                        (STENCIL, _) => framebuffer.stencil = image.stencil.take(),
                        _ => {}
                    }
                }
                None => {}
            }
        }
        self.framebuffer = framebuffer;
    }

    /// Does something with images of which one may be drawn to, while each has its own planes.
    pub(super) fn with_images_at_rest<R>(
        &mut self,
        is_image: impl Fn(&Attachment) -> bool,
        work: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let draw = self.framebuffers.draw;
        let object = self.framebuffers.get(draw);
        let is_drawn =
            object.is_some_and(|object| object.attachments.iter().flatten().any(is_image));
        if !is_drawn {
            return work(self);
        }
        self.store_attachments();
        let result = work(self);
        if let Some(object) = self.framebuffers.get(draw).cloned() {
            self.load_attachments(&object);
        }
        result
    }

    /// Leaves a texture's images, which are about to change or to go, to draws that wait; if these hold too much by then,
    /// they are carried out.
    pub(super) fn leave_images(&mut self, texture: &TextureHandle) {
        self.log.inherit(locked(texture).bytes_in_use());
        self.limit_log();
    }

    /// The same for a texture.
    pub(super) fn with_texture_at_rest<R>(
        &mut self,
        texture: &TextureHandle,
        work: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let is_image = |image: &Attachment| matches!(image, Attachment::Texture { texture: of, .. } if Arc::ptr_eq(of, texture));
        self.with_images_at_rest(is_image, work)
    }
}

/// Puts a plane back, unless it was never taken.
fn give<P>(place: &mut Option<P>, plane: Option<P>) {
    if plane.is_some() {
        *place = plane;
    }
}

/// Writes colours into a layer of an image, as far as both have them.
fn store_colors(image: &mut TextureImage, layer: u32, colors: &Plane<u32>, size: [u32; 2]) {
    let mut row = vec![0; size[0] as usize];
    for y in 0..size[1] {
        colors.read_row(y, 0, &mut row);
        let first = image.index([0, y, layer]);
        for (x, word) in row.iter().enumerate() {
            image.put(first + x, word.to_le_bytes().map(|byte| f32::from(byte) / 255.0));
        }
    }
}

/// The colours of a layer of an image; `None` if it has no colours, or there is no memory for them.
fn load_colors(image: &TextureImage, layer: u32) -> Option<Plane<u32>> {
    if image.format.is_depth() {
        return None;
    }
    let size = [image.size[0], image.size[1]];
    let mut colors = Plane::new(size, 1, 0)?;
    for y in 0..size[1] {
        let first = image.index([0, y, layer]);
        for x in 0..size[0] {
            let texel = image.format.base.returned(image.get(first + x as usize), 0.0, 1.0);
            let color = texel.map(|value| (value * 255.0 + 0.5) as u8);
            colors.set([x, y], 0, u32::from_le_bytes(color));
        }
    }
    Some(colors)
}
