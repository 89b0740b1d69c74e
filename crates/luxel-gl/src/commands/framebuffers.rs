//! Framebuffer objects (EXT_framebuffer_object, EXT_framebuffer_blit).
//!
//! What is drawn to lies in tiles, whatever it belongs to. Images of an object are taken into tiles when it is bound for
//! drawing, and put back when it is left.

use super::attachments::ImageKind;
use crate::Context;
use crate::context::{demand, outside_begin};
use crate::depth::DepthKind;
use crate::enums as gl;
use crate::objects::framebuffer::{
    Attachment, COLORS, DEPTH, STENCIL, attachments_named, color_place,
};
use crate::raster::Framebuffer;
use crate::texture::{BaseFormat, ImageTarget, locked};

impl Context {
    /// Whether the framebuffer that is drawn to has depths and stencil values.
    pub(crate) fn has_depth_and_stencil(&self) -> [bool; 2] {
        let configuration = &self.configuration;
        match self.framebuffers.get(self.framebuffers.draw) {
            Some(object) => [DEPTH, STENCIL].map(|place| object.attachments[place].is_some()),
            None => [configuration.depth_bits > 0, configuration.stencil_bits > 0],
        }
    }

    /// Which components colours of the framebuffer that is drawn to have.
    pub(crate) fn color_format(&self) -> BaseFormat {
        self.color_format_of(self.framebuffers.draw, self.framebuffers.color)
    }

    /// Whether these colours have alphas of their own.
    pub(crate) fn has_alpha(&self) -> bool {
        self.color_format().present()[3]
    }

    fn color_format_of(&self, name: u32, place: usize) -> BaseFormat {
        let Some(object) = self.framebuffers.get(name) else {
            return if self.configuration.alpha { BaseFormat::Rgba } else { BaseFormat::Rgb };
        };
        let kind = object.attachments[place].as_ref().and_then(|image| self.image_kind(image));
        kind.and_then(|kind| kind.planes.color).unwrap_or(BaseFormat::Rgba)
    }

    /// Whether the framebuffer that is read has depths.
    pub(super) fn reads_depths(&self) -> bool {
        self.depth_kind_of(self.framebuffers.read).is_some()
    }

    /// Whether the framebuffer that is read has colours.
    pub(super) fn reads_colors(&self) -> bool {
        let Some(object) = self.framebuffers.get(self.framebuffers.read) else { return true };
        let buffer = self.read_buffer_name();
        let place = color_place(buffer).filter(|_| buffer != gl::NONE);
        place.is_some_and(|place| object.attachments[place].is_some())
    }

    pub(super) fn set_read_buffer(&mut self, buffer: u32) {
        let (read, draw) = (self.framebuffers.read, self.framebuffers.draw);
        match self.framebuffers.get_mut(read) {
            _ if read == draw => self.state.read_buffer.0 = buffer,
            Some(object) => object.read_buffer = buffer,
            None => self.framebuffers.default_buffers[1] = buffer,
        }
    }

    /// `GL_READ_BUFFER` of the framebuffer that is bound for reading.
    pub(crate) fn read_buffer_name(&self) -> u32 {
        match self.framebuffers.get(self.framebuffers.read) {
            _ if self.framebuffers.read == self.framebuffers.draw => self.state.read_buffer.0,
            Some(object) => object.read_buffer,
            None => self.framebuffers.default_buffers[1],
        }
    }

    /// Sets an error if what is bound for drawing can't be drawn to.
    pub(crate) fn is_incomplete(&mut self) -> bool {
        let incomplete = self.status(self.framebuffers.draw) != gl::FRAMEBUFFER_COMPLETE;
        if incomplete {
            self.error.set(gl::INVALID_FRAMEBUFFER_OPERATION);
        }
        incomplete
    }

    /// `GL_FRAMEBUFFER_COMPLETE`, or what is missing. A draw or read buffer without an image is not: since OpenGL 4.1,
    /// and so in Mesa, that leaves a framebuffer complete, and programs rely on it.
    fn status(&self, name: u32) -> u32 {
        let Some(object) = self.framebuffers.get(name) else {
            return if self.has_default {
                gl::FRAMEBUFFER_COMPLETE
            } else {
                gl::FRAMEBUFFER_UNDEFINED
            };
        };
        let mut any = false;
        let mut all_samples = None;
        for (place, attachment) in object.attachments.iter().enumerate() {
            let Some(attachment) = attachment else { continue };
            let Some(ImageKind { size, planes, samples }) = self.image_kind(attachment) else {
                return gl::FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
            };
            let fits = match place {
                0..COLORS => planes.color.is_some(),
                DEPTH => planes.depth.is_some(),
                _ => planes.stencil,
            };
            if !fits || size.contains(&0) {
                return gl::FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
            }
            if *all_samples.get_or_insert(samples) != samples {
                return gl::FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
            }
            any = true;
        }
        if !any {
            return gl::FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
        }
        gl::FRAMEBUFFER_COMPLETE
    }

    /// How a framebuffer keeps depths; `None` if it has none.
    fn depth_kind_of(&self, name: u32) -> Option<DepthKind> {
        let Some(object) = self.framebuffers.get(name) else {
            return (self.configuration.depth_bits > 0).then_some(DepthKind::Steps);
        };
        self.image_kind(object.attachments[DEPTH].as_ref()?)?.planes.depth
    }

    /// Samples of a framebuffer's pixels.
    fn samples_of(&self, name: u32) -> usize {
        let images = self.framebuffers.get(name).map(|object| object.attachments.iter().flatten());
        let samples = images.into_iter().flatten();
        samples.filter_map(|of| self.image_kind(of)).map(|of| of.samples).max().unwrap_or(1)
    }

    /// Whether pixels that are read have several samples: they can be resolved alone, not read.
    pub(super) fn reads_samples(&self) -> bool {
        self.samples_of(self.framebuffers.read) > 1
    }

    /// Chooses the colour of the framebuffer that is drawn to.
    fn set_color(&mut self, place: usize) {
        if place == self.framebuffers.color {
            return;
        }
        self.store_attachments();
        self.framebuffers.color = place;
        if let Some(object) = self.framebuffers.get(self.framebuffers.draw).cloned() {
            self.load_attachments(&object);
        }
    }

    /// Chooses the colour that `glDrawBuffer` names.
    pub(super) fn set_drawn_color(&mut self) {
        let place = match self.framebuffers.draw {
            0 => None,
            _ => color_place(self.state.color.draw_buffer),
        };
        self.set_color(place.unwrap_or(0));
    }

    /// Binds a framebuffer for drawing, with its buffers and the colour that is drawn to.
    fn set_draw_framebuffer(&mut self, name: u32) {
        if name != self.framebuffers.draw {
            self.bind_drawn(name);
        }
        self.set_drawn_color();
    }

    fn bind_drawn(&mut self, name: u32) {
        self.store_attachments();
        let buffers = [self.state.color.draw_buffer, self.state.read_buffer.0];
        match self.framebuffers.get_mut(self.framebuffers.draw) {
            Some(object) => [object.draw_buffer, object.read_buffer] = buffers,
            None => self.framebuffers.default_buffers = buffers,
        }
        let object = self.framebuffers.get(name).cloned();
        if self.framebuffers.get(self.framebuffers.draw).is_none() {
            self.parked = std::mem::take(&mut self.framebuffer);
        }
        let [draw, read] = match &object {
            Some(object) => [object.draw_buffer, object.read_buffer],
            None => self.framebuffers.default_buffers,
        };
        self.framebuffers.color = if object.is_some() { color_place(draw).unwrap_or(0) } else { 0 };
        match &object {
            Some(object) => self.load_attachments(object),
            None => self.framebuffer = std::mem::take(&mut self.parked),
        }
        self.state.color.draw_buffer = draw;
        self.state.read_buffer.0 = read;
        self.framebuffers.draw = name;
    }

    /// Puts the framebuffer that is bound for reading, with the colour that is read, in the place of that for drawing.
    fn set_read_framebuffer(&mut self) {
        let read = self.framebuffers.read;
        let place = if read == 0 { None } else { color_place(self.read_buffer_name()) };
        if read != self.framebuffers.draw {
            self.bind_drawn(read);
        }
        self.set_color(place.unwrap_or(0));
    }

    /// Does something with the framebuffer that is bound for reading in the place of that for drawing.
    pub(crate) fn with_read_framebuffer<R>(&mut self, work: impl FnOnce(&mut Self) -> R) -> R {
        let draw = self.framebuffers.draw;
        self.set_read_framebuffer();
        let result = work(self);
        self.set_draw_framebuffer(draw);
        result
    }

    /// Does something with the default framebuffer in the place of what is bound.
    pub(crate) fn with_default_framebuffer<R>(&mut self, work: impl FnOnce(&mut Self) -> R) -> R {
        if self.stream.is_waiting() {
            self.draw_waiting();
        }
        let draw = self.framebuffers.draw;
        self.set_draw_framebuffer(0);
        let result = work(self);
        self.set_draw_framebuffer(draw);
        result
    }

    /// `glGenFramebuffers`.
    pub fn gen_framebuffers(&mut self, count: i32) -> Vec<u32> {
        outside_begin!(self, Vec::new());
        let Ok(count) = usize::try_from(count) else {
            self.error.set(gl::INVALID_VALUE);
            return Vec::new();
        };
        let names = self.framebuffers.generate(count);
        if names.len() < count {
            self.error.set(gl::OUT_OF_MEMORY);
        }
        names
    }

    /// `glDeleteFramebuffers`; one that is bound is left for the default framebuffer.
    pub fn delete_framebuffers(&mut self, names: &[u32]) {
        outside_begin!(self);
        for &name in names.iter().filter(|name| **name != 0) {
            if self.framebuffers.draw == name {
                self.set_draw_framebuffer(0);
            }
            if self.framebuffers.read == name {
                self.framebuffers.read = 0;
            }
            self.framebuffers.delete(name);
        }
    }

    /// `glIsFramebuffer`.
    pub fn is_framebuffer(&mut self, name: u32) -> bool {
        outside_begin!(self, false);
        self.framebuffers.get(name).is_some()
    }

    /// `glBindFramebuffer`.
    pub fn bind_framebuffer(&mut self, target: u32, name: u32) {
        outside_begin!(self);
        demand!(self, self.framebuffers.bound(target).is_some(), gl::INVALID_ENUM);
        let there = name == 0 || self.framebuffers.bind(name);
        demand!(self, there, gl::OUT_OF_MEMORY);
        if target != gl::READ_FRAMEBUFFER {
            self.set_draw_framebuffer(name);
        }
        if target != gl::DRAW_FRAMEBUFFER {
            self.framebuffers.read = name;
        }
    }

    /// `glCheckFramebufferStatus`; 0 after an error.
    pub fn check_framebuffer_status(&mut self, target: u32) -> u32 {
        outside_begin!(self, 0);
        let Some(name) = self.framebuffers.bound(target) else {
            self.error.set(gl::INVALID_ENUM);
            return 0;
        };
        self.status(name)
    }

    /// Attaches an image, or nothing, to what is bound.
    fn attach(&mut self, target: u32, attachment: u32, image: Option<Attachment>) {
        let (bound, places) = (self.framebuffers.bound(target), attachments_named(attachment));
        let (Some(bound), Some(places)) = (bound, places) else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        demand!(self, self.framebuffers.get(bound).is_some(), gl::INVALID_OPERATION);
        let is_drawn = bound == self.framebuffers.draw;
        if is_drawn {
            self.store_attachments();
        }
        if let Some(object) = self.framebuffers.get_mut(bound) {
            for &place in places {
                object.attachments[place] = image.clone();
            }
        }
        if is_drawn && let Some(object) = self.framebuffers.get(bound).cloned() {
            self.load_attachments(&object);
        }
    }

    /// `glFramebufferRenderbuffer`; name 0 detaches.
    pub fn framebuffer_renderbuffer(
        &mut self,
        target: u32,
        attachment: u32,
        renderbuffer_target: u32,
        name: u32,
    ) {
        outside_begin!(self);
        demand!(self, renderbuffer_target == gl::RENDERBUFFER, gl::INVALID_ENUM);
        let there = name == 0 || self.renderbuffers().get(name).is_some();
        demand!(self, there, gl::INVALID_OPERATION);
        let image = (name != 0).then_some(Attachment::Renderbuffer(name));
        self.attach(target, attachment, image);
    }

    /// `glFramebufferTexture1D`, `2D`, `3D`: a level of a texture, of a cube a face, of a volume a layer. Name 0 detaches.
    pub fn framebuffer_texture(
        &mut self,
        target: u32,
        attachment: u32,
        texture_target: u32,
        name: u32,
        level: i32,
        layer: i32,
    ) {
        outside_begin!(self);
        if name == 0 {
            self.attach(target, attachment, None);
            return;
        }
        let image = ImageTarget::named(texture_target).filter(|image| !image.proxy);
        let Some(image) = image else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        let texture = self.textures().get(name);
        let Some(texture) = texture.filter(|of| locked(of).target == image.target) else {
            self.error.set(gl::INVALID_OPERATION);
            return;
        };
        let within = (0..image.target.levels()).contains(&level) && layer >= 0;
        demand!(self, within, gl::INVALID_VALUE);
        let (level, layer) = (level as usize, layer as u32);
        let attached = Attachment::Texture { name, texture, face: image.face, level, layer };
        self.attach(target, attachment, Some(attached));
    }

    /// `glBlitFramebuffer`: copies a rectangle, given by two corners each, stretched and mirrored as they say. Depth and
    /// stencil by the nearest pixel, colour also linearly.
    pub fn blit_framebuffer(
        &mut self,
        source: [i32; 4],
        destination: [i32; 4],
        mask: u32,
        filter: u32,
    ) {
        outside_begin!(self);
        let all = gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT | gl::STENCIL_BUFFER_BIT;
        demand!(self, mask & !all == 0, gl::INVALID_VALUE);
        demand!(self, matches!(filter, gl::NEAREST | gl::LINEAR), gl::INVALID_ENUM);
        let exact = mask & !gl::COLOR_BUFFER_BIT == 0 || filter == gl::NEAREST;
        demand!(self, exact, gl::INVALID_OPERATION);
        let complete = self.status(self.framebuffers.read) == gl::FRAMEBUFFER_COMPLETE
            && self.status(self.framebuffers.draw) == gl::FRAMEBUFFER_COMPLETE;
        demand!(self, complete, gl::INVALID_FRAMEBUFFER_OPERATION);
        let kinds =
            [self.framebuffers.read, self.framebuffers.draw].map(|of| self.depth_kind_of(of));
        let alike = matches!(kinds, [None, _] | [_, None]) || kinds[0] == kinds[1];
        demand!(self, alike || mask & gl::DEPTH_BUFFER_BIT == 0, gl::INVALID_OPERATION);
        // Samples are copied or resolved pixel by pixel, not scaled.
        let side = |corners: [i32; 4], axis: usize| {
            i64::from(corners[axis + 2]).abs_diff(i64::from(corners[axis]))
        };
        let as_large = (0..2).all(|axis| side(source, axis) == side(destination, axis));
        let has_samples = self.reads_samples() || self.framebuffer.samples() > 1;
        demand!(self, as_large || !has_samples, gl::INVALID_OPERATION);
        let from = color_place(self.read_buffer_name()).unwrap_or(0);
        let opaque = !self.color_format_of(self.framebuffers.read, from).present()[3];
        self.with_read_planes(mask, |context, from| {
            context.carry_out();
            let region = context.scissored_region();
            context.drawn = true;
            let corners = (source, destination);
            let present = context.color_format().present();
            let adapt = |mut color: [u8; 4]| {
                if opaque {
                    color[3] = 255;
                }
                std::array::from_fn(|at| if present[at] { color[at] } else { 0 })
            };
            context.framebuffer.blit(from, corners, mask, (filter == gl::LINEAR, &adapt), region);
        });
    }

    /// Does something with the planes of a mask that are read, beside those that are drawn to: the images themselves
    /// where both have their own, else copies.
    fn with_read_planes(&mut self, mask: u32, work: impl FnOnce(&mut Self, &Framebuffer)) {
        let (draw, read) = (self.framebuffers.draw, self.framebuffers.read);
        if self.framebuffers.share_images(draw, read) {
            let from = self.with_read_framebuffer(|context| {
                context.carry_out();
                context.framebuffer.planes_of(mask)
            });
            return work(self, &from);
        }
        self.set_read_framebuffer();
        self.carry_out();
        let from = std::mem::take(&mut self.framebuffer);
        self.set_draw_framebuffer(draw);
        work(self, &from);
        self.set_read_framebuffer();
        self.framebuffer = from;
        self.set_draw_framebuffer(draw);
    }
}
