//! Renderbuffers (EXT_framebuffer_object, section 4.4.2.1).

use crate::depth::{DepthKind, DepthPlane};
use crate::enums as gl;
use crate::limits::RENDERBUFFER_NAMES;
use crate::plane::Plane;
use std::collections::BTreeMap;

/// The planes that a format has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Planes {
    pub(crate) color: bool,
    /// Whether colours have alphas.
    pub(crate) alpha: bool,
    pub(crate) depth: Option<DepthKind>,
    pub(crate) stencil: bool,
}

impl Planes {
    /// The planes of a format of renderbuffers; `None` for one that isn't one.
    pub(crate) fn of_format(format: u32) -> Option<Self> {
        let colors = |alpha| Some(Self { color: true, alpha, depth: None, stencil: false });
        let depths = |depth, stencil| Some(Self { color: false, alpha: false, depth, stencil });
        let (steps, floats) = (Some(DepthKind::Steps), Some(DepthKind::Floats));
        match format {
            gl::RGB
            | gl::R3_G3_B2
            | gl::RGB4
            | gl::RGB5
            | gl::RGB8
            | gl::RGB10
            | gl::RGB12
            | gl::RGB16 => colors(false),
            gl::RGBA
            | gl::RGBA2
            | gl::RGBA4
            | gl::RGB5_A1
            | gl::RGBA8
            | gl::RGB10_A2
            | gl::RGBA12
            | gl::RGBA16
            | gl::SRGB8_ALPHA8 => colors(true),
            gl::DEPTH_COMPONENT
            | gl::DEPTH_COMPONENT16
            | gl::DEPTH_COMPONENT24
            | gl::DEPTH_COMPONENT32 => depths(steps, false),
            gl::DEPTH_STENCIL | gl::DEPTH24_STENCIL8 => depths(steps, true),
            gl::DEPTH_COMPONENT32F => depths(floats, false),
            gl::DEPTH32F_STENCIL8 => depths(floats, true),
            gl::STENCIL_INDEX
            | gl::STENCIL_INDEX1
            | gl::STENCIL_INDEX4
            | gl::STENCIL_INDEX8
            | gl::STENCIL_INDEX16 => depths(None, true),
            _ => None,
        }
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
            color: whole_numbers(planes.color)?,
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
