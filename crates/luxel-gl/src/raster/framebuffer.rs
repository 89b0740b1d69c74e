//! What is drawn to: planes of colours, depths and stencil values.

use crate::depth::{DepthKind, DepthPlane};
use crate::enums as gl;
use crate::plane::{Blocks, Plane, PlaneTile, PlaneValue, TILE_BLOCKS};
use luxel_math::{LANES, Simd};
use luxel_visibility::TILE;

/// A framebuffer with one sample a pixel, or with several. Planes may be larger than it is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Framebuffer {
    pub(crate) size: [u32; 2],
    /// Red in the lowest byte, alpha in the highest.
    pub(crate) color: Option<Plane<u32>>,
    pub(crate) depth: Option<DepthPlane>,
    pub(crate) stencil: Option<Plane<u32>>,
    /// Whether something was drawn since it was made.
    pub(crate) changed: bool,
}

/// A tile of all planes, each with its samples; `None` for planes that aren't there.
#[derive(Debug)]
pub(super) struct TilePlanes<'a> {
    pub(super) color: Option<&'a mut [PlaneTile<u32>]>,
    pub(super) depth: Option<&'a mut [PlaneTile<f32>]>,
    pub(super) depth_kind: DepthKind,
    pub(super) stencil: Option<&'a mut [PlaneTile<u32>]>,
}

/// The planes that something looks at or changes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Uses {
    pub(super) color: bool,
    pub(super) depth: bool,
    pub(super) stencil: bool,
}

/// A tile of one sample.
#[derive(Debug)]
pub(super) struct SamplePlanes<'a> {
    pub(super) color: &'a mut Blocks<u32>,
    pub(super) depth: &'a mut Blocks<f32>,
    pub(super) depth_kind: DepthKind,
    pub(super) stencil: &'a mut Blocks<u32>,
}

/// Stands for planes that aren't there.
#[derive(Debug)]
pub(super) struct NoPlanes {
    color: Box<Blocks<u32>>,
    depth: Box<Blocks<f32>>,
    stencil: Box<Blocks<u32>>,
}

impl Default for NoPlanes {
    fn default() -> Self {
        Self {
            color: Box::new([[0; LANES]; TILE_BLOCKS]),
            depth: Box::new([[0.0; LANES]; TILE_BLOCKS]),
            stencil: Box::new([[0; LANES]; TILE_BLOCKS]),
        }
    }
}

impl TilePlanes<'_> {
    /// The planes of a sample that are used; what `missing` has in the place of others means nothing.
    #[inline(always)]
    pub(super) fn sample<'s, S: Simd>(
        &'s mut self,
        simd: S,
        sample: usize,
        missing: &'s mut NoPlanes,
        uses: Uses,
    ) -> SamplePlanes<'s> {
        SamplePlanes {
            color: used(simd, &mut self.color, sample, uses.color).unwrap_or(&mut missing.color),
            depth: used(simd, &mut self.depth, sample, uses.depth).unwrap_or(&mut missing.depth),
            depth_kind: self.depth_kind,
            stencil: used(simd, &mut self.stencil, sample, uses.stencil)
                .unwrap_or(&mut missing.stencil),
        }
    }

    /// The depths of a sample; what `missing` has in the place of a plane that isn't there means nothing.
    #[inline(always)]
    pub(super) fn depths<'s, S: Simd>(
        &'s mut self,
        simd: S,
        sample: usize,
        missing: &'s mut NoPlanes,
    ) -> &'s mut Blocks<f32> {
        used(simd, &mut self.depth, sample, true).unwrap_or(&mut missing.depth)
    }
}

/// The blocks of a sample's tile, if there is one and it is used.
#[inline(always)]
fn used<'s, S: Simd, T: PlaneValue>(
    simd: S,
    tiles: &'s mut Option<&mut [PlaneTile<T>]>,
    sample: usize,
    uses: bool,
) -> Option<&'s mut Blocks<T>> {
    let tiles = tiles.as_mut().filter(|_| uses)?;
    Some(tiles[sample].blocks_mut(simd))
}

impl Framebuffer {
    /// All planes, black and as far away as possible; `None` if there is no memory for them.
    pub(crate) fn new(size: [u32; 2]) -> Option<Self> {
        Some(Self {
            size,
            color: Some(Plane::new(size, 1, 0)?),
            depth: Some(DepthPlane::new(DepthKind::Steps, size, 1, 1.0)?),
            stencil: Some(Plane::new(size, 1, 0)?),
            changed: false,
        })
    }

    /// A copy of the planes of a mask, as `glClear` has them.
    pub(crate) fn planes_of(&self, mask: u32) -> Self {
        fn copied<P: Clone>(plane: &Option<P>, wanted: bool) -> Option<P> {
            if wanted { plane.clone() } else { None }
        }
        Self {
            color: copied(&self.color, mask & gl::COLOR_BUFFER_BIT != 0),
            depth: copied(&self.depth, mask & gl::DEPTH_BUFFER_BIT != 0),
            stencil: copied(&self.stencil, mask & gl::STENCIL_BUFFER_BIT != 0),
            ..*self
        }
    }

    /// Width and height.
    pub(crate) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Samples of a pixel.
    pub(crate) fn samples(&self) -> usize {
        let color = self.color.as_ref().map(Plane::samples);
        let depth = || self.depth.as_ref().map(|plane| plane.values.samples());
        let stencil = || self.stencil.as_ref().map(Plane::samples);
        color.or_else(depth).or_else(stencil).unwrap_or(1)
    }

    /// Whether its planes end where it does.
    pub(super) fn is_exact(&self) -> bool {
        let fits = |size: Option<[u32; 2]>| size.is_none_or(|size| size == self.size);
        fits(self.color.as_ref().map(Plane::size))
            && fits(self.depth.as_ref().map(|plane| plane.values.size()))
            && fits(self.stencil.as_ref().map(Plane::size))
    }

    /// How many tiles lie side by side, and how many one above the other.
    pub(super) fn tiles_across_and_up(&self) -> [usize; 2] {
        self.size.map(|side| side.div_ceil(TILE as u32) as usize)
    }

    /// All tiles, row by row.
    pub(super) fn tiles_mut(&mut self) -> Vec<TilePlanes<'_>> {
        let sides = self.tiles_across_and_up();
        let depth_kind = self.depth_kind();
        let mut color = self.color.as_mut().map(|plane| plane.tiles_mut(sides));
        let mut depth = self.depth.as_mut().map(|plane| plane.values.tiles_mut(sides));
        let mut stencil = self.stencil.as_mut().map(|plane| plane.tiles_mut(sides));
        (0..sides[0] * sides[1])
            .map(|_| TilePlanes {
                color: color.as_mut().and_then(Iterator::next),
                depth: depth.as_mut().and_then(Iterator::next),
                depth_kind,
                stencil: stencil.as_mut().and_then(Iterator::next),
            })
            .collect()
    }

    pub(crate) fn set_color(&mut self, at: [u32; 2], color: [u8; 4]) {
        self.changed = true;
        if let Some(plane) = &mut self.color {
            plane.set(at, 0, u32::from_le_bytes(color));
        }
    }

    /// Red, green, blue and alpha of a pixel's first sample.
    pub(crate) fn color(&self, at: [u32; 2]) -> [u8; 4] {
        let word = self.color.as_ref().and_then(|plane| plane.get(at, 0));
        word.unwrap_or(0).to_le_bytes()
    }

    /// The colours of a row of pixels at one sample as words, red in the lowest byte.
    pub(crate) fn color_row(&self, y: u32, sample: usize, row: &mut [u32]) {
        match &self.color {
            Some(plane) => plane.read_row(y, sample, row),
            None => row.fill(0),
        }
    }

    /// How depths are kept.
    pub(crate) fn depth_kind(&self) -> DepthKind {
        self.depth.as_ref().map_or(DepthKind::default(), |plane| plane.kind)
    }

    /// A depth as it is kept.
    pub(crate) fn kept_depth(&self, at: [u32; 2], sample: usize) -> f32 {
        self.depth.as_ref().and_then(|plane| plane.values.get(at, sample)).unwrap_or(0.0)
    }

    /// A pixel's depth from 0 to 1 at its first sample.
    pub(crate) fn unit_depth(&self, at: [u32; 2]) -> f32 {
        self.depth.as_ref().and_then(|plane| plane.unit(at, 0)).unwrap_or(0.0)
    }

    /// A pixel's depth and stencil value at its first sample, from 0 to 1, in the place of red and green.
    pub(crate) fn unit_depth_stencil(&self, at: [u32; 2]) -> [f32; 4] {
        [self.unit_depth(at), f32::from(self.stencil(at)) / 255.0, 0.0, 1.0]
    }

    /// A pixel's stencil value at its first sample.
    pub(crate) fn stencil(&self, at: [u32; 2]) -> u8 {
        self.stencil.as_ref().and_then(|plane| plane.get(at, 0)).unwrap_or(0) as u8
    }
}
