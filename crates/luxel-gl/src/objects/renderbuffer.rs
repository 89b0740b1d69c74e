//! Renderbuffers (EXT_framebuffer_object, section 4.4.2.1).

use crate::depth::{DepthKind, DepthPlane};
use crate::enums as gl;
use crate::limits::RENDERBUFFER_NAMES;
use crate::plane::Plane;
use crate::texture::{BaseFormat, InternalFormat, is_compressed};
use std::collections::BTreeMap;

/// The planes that a format has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Planes {
    /// Which components colours have.
    pub(crate) color: Option<BaseFormat>,
    pub(crate) depth: Option<DepthKind>,
    pub(crate) stencil: bool,
}

impl Planes {
    /// The planes of a format of renderbuffers; `None` for one that isn't one: those that textures have, but numbers of
    /// components and compressed ones; and stencil values.
    pub(crate) fn of_format(name: u32) -> Option<Self> {
        match name {
            gl::STENCIL_INDEX
            | gl::STENCIL_INDEX1
            | gl::STENCIL_INDEX4
            | gl::STENCIL_INDEX8
            | gl::STENCIL_INDEX16 => Some(Self { stencil: true, ..Self::default() }),
            1..=4 => None,
            _ => {
                let format = InternalFormat::named(name).filter(|_| !is_compressed(name))?;
                let draws = !format.srgb || format.base == BaseFormat::Rgba;
                draws.then(|| Self::of_texels(format))
            }
        }
    }

    /// The planes of a texture's image.
    pub(crate) fn of_texels(format: InternalFormat) -> Self {
        let is_depth = format.is_depth();
        Self {
            color: (!is_depth).then_some(format.base),
            depth: is_depth.then(|| format.depth_kind()),
            stencil: format.stencil,
        }
    }

    /// Bits of red, green, blue and alpha as they are drawn to, depth, stencil.
    pub(crate) fn component_bits(self) -> [usize; 6] {
        let [r, g, b, a] =
            self.color.map_or([false; 4], BaseFormat::present).map(|there| match there {
                true => 8,
                false => 0,
            });
        let stencil = if self.stencil { 8 } else { 0 };
        [r, g, b, a, self.depth.map_or(0, DepthKind::bits), stencil]
    }
}

/// One renderbuffer.
#[derive(Clone, Debug, Default)]
pub(crate) struct Renderbuffer {
    pub(crate) format: u32,
    /// Samples of a pixel, 0 for one that isn't several.
    pub(crate) samples: usize,
    pub(crate) size: [u32; 2],
    pub(crate) planes: Planes,
    /// Nothing while it is drawn to, as the others.
    pub(crate) color: Option<Plane<u32>>,
    pub(crate) depth: Option<DepthPlane>,
    pub(crate) stencil: Option<Plane<u32>>,
}

impl Renderbuffer {
    /// Storage for `format`; `None` if there is no memory for it.
    pub(crate) fn new(format: u32, planes: Planes, samples: usize, size: [u32; 2]) -> Option<Self> {
        let count = samples.max(1);
        let whole_numbers = |there: bool| match there {
            true => Plane::new(size, count, 0).map(Some),
            false => Some(None),
        };
        let depth = match planes.depth {
            Some(kind) => Some(DepthPlane::new(kind, size, count, 0.0)?),
            None => None,
        };
        Some(Self {
            format,
            samples,
            size,
            planes,
            color: whole_numbers(planes.color.is_some())?,
            depth,
            stencil: whole_numbers(planes.stencil)?,
        })
    }
}

/// The renderbuffers of a context, and of those that share with it.
#[derive(Debug, Default)]
pub(crate) struct Renderbuffers {
    names: BTreeMap<u32, Option<Renderbuffer>>,
}

impl Renderbuffers {
    /// So many names that nobody has; fewer if there are too many.
    pub(crate) fn generate(&mut self, count: usize) -> Vec<u32> {
        super::names::generate(&mut self.names, count, RENDERBUFFER_NAMES)
    }

    /// Makes a renderbuffer of a name that is bound; whether there can be one more.
    pub(crate) fn bind(&mut self, name: u32) -> bool {
        super::names::bind(&mut self.names, name, RENDERBUFFER_NAMES)
    }

    pub(crate) fn get(&self, name: u32) -> Option<&Renderbuffer> {
        self.names.get(&name)?.as_ref()
    }

    pub(crate) fn get_mut(&mut self, name: u32) -> Option<&mut Renderbuffer> {
        self.names.get_mut(&name)?.as_mut()
    }

    pub(crate) fn delete(&mut self, name: u32) {
        self.names.remove(&name);
    }
}
