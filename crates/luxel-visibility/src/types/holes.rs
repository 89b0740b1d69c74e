//! Where a covered sample is nevertheless not hit: who tells, and how it is asked.

use super::TriangleId;
use luxel_math::{LANES, SUBPIXELS};

/// Tells where triangles have holes. The answer for a sample hangs on nothing but its triangle and its
/// place.
pub trait Holes {
    /// Which of the samples asked about lie in a hole, as bits.
    fn holes(&self, asked: &Asked) -> u32;
}

/// Up to sixteen samples, each of a triangle that covers it.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// The triangles.
    pub ids: [TriangleId; LANES],
    /// Where the samples lie in the window, in pixels: whole steps of 1/256, which `f32` holds.
    pub x: [f32; LANES],
    /// The same downwards.
    pub y: [f32; LANES],
    /// The samples that are asked about, as bits; of others nothing is known.
    pub lanes: u32,
}

impl Asked {
    /// One sample, in the first lane, at a position in steps of 1/256 pixel.
    #[must_use]
    pub fn one(id: TriangleId, position: [i32; 2]) -> Self {
        let [x, y] = position.map(|steps| [steps as f32 / SUBPIXELS as f32; LANES]);
        Self { ids: [id; LANES], x, y, lanes: 1 }
    }

    /// The position of a lane's sample in steps of 1/256 pixel.
    #[must_use]
    pub fn position(&self, lane: usize) -> [i32; 2] {
        [self.x[lane], self.y[lane]].map(|pixels| (pixels * SUBPIXELS as f32) as i32)
    }
}

/// Whoever tells of one sample, by its triangle and its position in steps of 1/256 pixel, tells of
/// sixteen.
impl<F: Fn(TriangleId, [i32; 2]) -> bool> Holes for F {
    fn holes(&self, asked: &Asked) -> u32 {
        let is_hole = |lane: usize| self(asked.ids[lane], asked.position(lane));
        let lanes = (0..LANES).filter(|&lane| asked.lanes >> lane & 1 == 1 && is_hole(lane));
        lanes.fold(0, |holes, lane| holes | 1 << lane)
    }
}
