//! Images of framebuffer objects between their owners and the tiles that are drawn to.

use crate::Context;
use crate::limits::VIEWPORT;
use crate::objects::framebuffer::{Attachment, COLOR, DEPTH, FramebufferObject, STENCIL};
use crate::objects::renderbuffer::{Planes, Renderbuffer};
use crate::raster::{Framebuffer, LARGEST_DEPTH};
use crate::texture::{TextureImage, locked};
use std::sync::Arc;

/// An attached image, to be looked at.
pub(super) enum Source<'a> {
    Renderbuffer(&'a Renderbuffer),
    Texture(Arc<TextureImage>, u32),
}

impl Source<'_> {
    pub(super) fn size(&self) -> [u32; 2] {
        match self {
            Self::Renderbuffer(of) => of.size,
            Self::Texture(image, _) => [image.size[0], image.size[1]],
        }
    }

    /// Samples of a pixel.
    pub(super) fn samples(&self) -> usize {
        match self {
            Self::Renderbuffer(of) => of.layers(),
            Self::Texture(..) => 1,
        }
    }

    pub(super) fn planes(&self) -> Planes {
        match self {
            Self::Renderbuffer(of) => of.planes,
            // Textures of depth and stencil have no stencil that is kept.
            Self::Texture(image, _) if image.format.is_depth() => {
                Planes { color: false, depth: true, stencil: true }
            }
            Self::Texture(..) => Planes { color: true, depth: false, stencil: false },
        }
    }
}

impl Context {
    /// An attached image; `None` if it isn't there any more.
    pub(super) fn with_source<R>(
        &self,
        of: &Attachment,
        work: impl FnOnce(Source<'_>) -> R,
    ) -> Option<R> {
        match of {
            Attachment::Renderbuffer(name) => {
                let renderbuffers = self.renderbuffers();
                renderbuffers.get(*name).map(|of| work(Source::Renderbuffer(of)))
            }
            Attachment::Texture { texture, face, level, layer, .. } => {
                let image = locked(texture).image(*face, *level).map(Arc::clone);
                image.map(|image| work(Source::Texture(image, *layer)))
            }
        }
    }

    /// Puts what was drawn back into the images of the object that is bound for drawing.
    pub(crate) fn store_attachments(&mut self) {
        self.carry_out();
        let Some(object) = self.framebuffers.get(self.framebuffers.draw).cloned() else { return };
        let [width, height] = self.framebuffer.size();
        for (place, attachment) in object.attachments.iter().enumerate() {
            match attachment {
                Some(Attachment::Renderbuffer(name)) => {
                    let mut renderbuffers = self.renderbuffers();
                    let Some(of) = renderbuffers.get_mut(*name) else { continue };
                    // Of images of several sizes what all have is drawn to.
                    if of.size[0] < width || of.size[1] < height {
                        continue;
                    }
                    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
                    let from = &self.framebuffer;
                    let samples = 0..from.samples();
                    for (at, sample) in
                        pixels.flat_map(|at| samples.clone().map(move |sample| (at, sample)))
                    {
                        let index = of.index(at, sample);
                        match place {
                            COLOR => put(&mut of.color, index, from.sample_color(at, sample)),
                            DEPTH => put(&mut of.depth, index, from.sample_depth(at, sample)),
                            _ => put(&mut of.stencil, index, from.sample_stencil(at, sample)),
                        }
                    }
                }
                Some(Attachment::Texture { texture, face, level, layer, .. })
                    if place != STENCIL =>
                {
                    let mut texture = locked(texture);
                    let Some(image) = texture.image_mut(*face, *level) else { continue };
                    if image.size[0] < width || image.size[1] < height {
                        continue;
                    }
                    for y in 0..height {
                        for x in 0..width {
                            let value = if place == DEPTH {
                                [self.framebuffer.unit_depth([x, y]), 0.0, 0.0, 1.0]
                            } else {
                                self.framebuffer.color([x, y]).map(|byte| f32::from(byte) / 255.0)
                            };
                            let index = image.index([x, y, *layer]);
                            image.put(index, value);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// The images of an object, in tiles.
    pub(super) fn loaded(&self, object: &FramebufferObject) -> Framebuffer {
        let images = || object.attachments.iter().flatten();
        let samples = images().filter_map(|of| self.with_source(of, |source| source.samples()));
        let samples = samples.max().unwrap_or(1);
        let sizes = images().filter_map(|of| self.with_source(of, |source| source.size()));
        let smaller = |a: [u32; 2], b: [u32; 2]| [a[0].min(b[0]), a[1].min(b[1])];
        let [width, height] = sizes.reduce(smaller).unwrap_or([0; 2]);
        let [width, height] = [width, height].map(|side| side.min(VIEWPORT as u32));
        let mut framebuffer = Framebuffer::new(width, height, samples);
        for (place, attachment) in object.attachments.iter().enumerate() {
            let Some(attachment) = attachment else { continue };
            let _ = self.with_source(attachment, |source| {
                for y in 0..height {
                    for x in 0..width {
                        for sample in 0..samples {
                            load_sample(&mut framebuffer, &source, place, ([x, y], sample));
                        }
                    }
                }
            });
        }
        framebuffer
    }
}

/// Overwrites a value of a plane, if it is there.
fn put<T>(plane: &mut [T], index: usize, value: T) {
    if let Some(place) = plane.get_mut(index) {
        *place = value;
    }
}

/// Takes one sample of an attached image into the tiles.
fn load_sample(
    framebuffer: &mut Framebuffer,
    source: &Source<'_>,
    place: usize,
    (at, sample): ([u32; 2], usize),
) {
    match source {
        Source::Renderbuffer(of) => {
            let index = of.index(at, sample);
            match place {
                COLOR => {
                    framebuffer.set_color(
                        at,
                        sample,
                        of.color.get(index).copied().unwrap_or_default(),
                    );
                }
                DEPTH => {
                    let depth = of.depth.get(index).copied().unwrap_or(0);
                    framebuffer.set_depth(at, sample, depth);
                }
                _ => {
                    let value = of.stencil.get(index).copied().unwrap_or(0);
                    framebuffer.set_stencil(at, sample, value);
                }
            }
        }
        Source::Texture(image, layer) => {
            let value = image.get(image.index([at[0], at[1], *layer]));
            match place {
                COLOR => {
                    framebuffer.set_color(
                        at,
                        sample,
                        value.map(|value| (value * 255.0 + 0.5) as u8),
                    );
                }
                DEPTH => {
                    let depth = (f64::from(value[0]) * f64::from(LARGEST_DEPTH)).round() as u32;
                    framebuffer.set_depth(at, sample, depth);
                }
                _ => {}
            }
        }
    }
}
