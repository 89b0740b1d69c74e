//! A triangle's edge functions and depth plane, from its snapped corners.
//!
//! E(s) = (q_x - p_x)(s_y - p_y) - (q_y - p_y)(s_x - p_x) is twice the signed area of the edge
//! p -> q with a sample s: not negative on the inner side (Pineda 1988). With positions in steps of
//! 1/256 pixel and samples a whole number of pixels apart, E changes by multiples of 256 from pixel
//! to pixel, so `floor(E / 256)` keeps its sign exactly. Setup is in i64; within the guard band of
//! 2^14 pixels |dx|, |dy| <= 2^23, and an edge that crosses a region of 64 pixels a side has
//! |E / 256| <= 64 (|dx| + |dy|) <= 2^30 there: the inner loop is in i32.
//!
//! A sample on an edge belongs to the triangle if the edge is a left or a top one.

use crate::types::{BLOCK, CullFaces, Region, WindowVertex};
use luxel_math::{Lanes, SUBPIXELS, Simd, f32x16, i32x16, prelude::*};

/// A triangle ready to be rasterized.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Corners in an order that makes the inside positive.
    x: [i32; 3],
    y: [i32; 3],
    /// Its depths.
    pub depth: DepthPlane,
}

/// Depth over the window: z = z_a + (x - x_a) dz/dx + (y - y_a) dz/dy, clamped to the
/// range of the corners, so that bounds of corners bound every sample.
///
/// This is the one formula of the depth test, whatever the corners' depths are: reversed ones in luxel's frames, of any
/// other encoding for whoever sets triangles up. Differences of snapped positions are exact in f32,
/// so every path that reaches a sample computes the same bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthPlane {
    /// x_a, in steps of 1/256 pixel.
    pub x: i32,
    /// y_a
    pub y: i32,
    /// z_a
    pub z: f32,
    /// dz/dx, a step of 1/256 pixel.
    pub dz_dx: f32,
    /// dz/dy
    pub dz_dy: f32,
    /// The least depth of a corner.
    pub low: f32,
    /// The greatest.
    pub high: f32,
}

impl DepthPlane {
    /// The same plane, farther away by the [steps](rank_step) of a rank.
    fn behind(self, rank: u8) -> Self {
        let slope = [self.dz_dx, self.dz_dy].map(f64::from);
        let by = (f64::from(rank) * rank_step(slope, f64::from(self.high))) as f32;
        // Within the far plane: what lies beyond isn't drawn.
        let farther = |z: f32| Lanes::maximum(z - by, z * 0.5);
        Self { z: self.z - by, low: farther(self.low), high: farther(self.high), ..self }
    }

    /// The depth at a position in steps of 1/256 pixel.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, position: [i32; 2]) -> f32 {
        let row_z = (position[1] - self.y) as f32 * self.dz_dy;
        self.depth((position[0] - self.x) as f32, row_z)
    }

    /// The depths at sixteen positions.
    #[inline(always)]
    #[must_use]
    pub fn at_lanes<S: Simd>(&self, [x, y]: [i32x16<S>; 2]) -> f32x16<S> {
        let row_z = f32x16::float_from(y - self.y) * self.dz_dy;
        self.depth(f32x16::float_from(x - self.x), row_z)
    }

    /// The depth `dx` to the right of the first corner, where (y - y_a) dz/dy is `row_z`.
    #[inline(always)]
    pub(super) fn depth<N: Lanes>(&self, dx: N, row_z: N) -> N {
        let z = dx * dx.constant(self.dz_dx) + dx.constant(self.z) + row_z;
        z.maximum(dx.constant(self.low)).minimum(dx.constant(self.high))
    }

    /// The same plane, with positions counted from `origin`.
    #[must_use]
    pub fn from_origin(self, origin: [i32; 2]) -> Self {
        Self { x: self.x - origin[0], y: self.y - origin[1], ..self }
    }
}

/// The difference in depth from one [rank](luxel_scene::CoplanarRanks) to the next: more than snapping
/// and rounding tell triangles in one plane apart by.
///
/// Snapping moves each corner by half a step of 1/256 pixel across and down: `slope` is how much depth
/// changes with these. A transform rounds in proportion to the reversed depth, `nearest` at most, a few bits
/// more where the mesh reaches far beyond what is seen.
#[must_use]
pub fn rank_step(slope: [f64; 2], nearest: f64) -> f64 {
    const ROUNDING: f64 = 1.0 / (1 << 18) as f64;
    2.0 * (slope[0].abs() + slope[1].abs()) + nearest * ROUNDING
}

/// An edge function over a region: E / 256 at the region's first pixel, and its change from one
/// pixel to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Edge {
    pub(crate) start: i32,
    pub(crate) step_x: i32,
    pub(crate) step_y: i32,
}

impl Edge {
    /// How much more than at a block's first pixel the value is at another one of it, at most.
    #[inline(always)]
    pub(crate) fn rise_in_block(&self) -> i32 {
        (BLOCK - 1) * (self.step_x.max(0) + self.step_y.max(0))
    }

    /// The value at a pixel of the region.
    #[inline(always)]
    pub(crate) fn at(&self, x: i32, y: i32) -> i32 {
        self.start + self.step_x * x + self.step_y * y
    }
}

/// How much of a region's samples a triangle covers, as far as its box and each of its edges alone show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlap {
    /// No sample.
    None,
    /// Maybe some.
    Part,
    /// All samples.
    Whole,
}

impl Triangle {
    /// `None` for a triangle without area or on a side that is culled.
    ///
    /// Corners lie within the guard band, 2^14 pixels about the window's middle.
    #[inline(always)]
    #[must_use]
    pub fn new([a, b, c]: [WindowVertex; 3], cull: CullFaces) -> Option<Self> {
        let (ab_x, ab_y) = (b.x - a.x, b.y - a.y);
        let (ac_x, ac_y) = (c.x - a.x, c.y - a.y);
        let area = i64::from(ab_x) * i64::from(ac_y) - i64::from(ac_x) * i64::from(ab_y);
        // With y down, a positive area is clockwise.
        let culled = match cull {
            CullFaces::None => area == 0,
            CullFaces::Clockwise => area >= 0,
            CullFaces::CounterClockwise => area <= 0,
        };
        if culled {
            return None;
        }
        let (ab_z, ac_z) = (b.z - a.z, c.z - a.z);
        let [ab_x, ab_y, ac_x, ac_y] = [ab_x, ab_y, ac_x, ac_y].map(|d| d as f32);
        let scale = area as f32;
        let depth = DepthPlane {
            x: a.x,
            y: a.y,
            z: a.z,
            dz_dx: (ab_z * ac_y - ac_z * ab_y) / scale,
            dz_dy: (ac_z * ab_x - ab_z * ac_x) / scale,
            low: a.z.min(b.z).min(c.z),
            high: a.z.max(b.z).max(c.z),
        };
        let (b, c) = if area > 0 { (b, c) } else { (c, b) };
        Some(Self { x: [a.x, b.x, c.x], y: [a.y, b.y, c.y], depth })
    }

    /// The same triangle with a [rank](luxel_scene::CoplanarRanks) among those in its plane.
    #[inline(always)]
    pub(crate) fn with_rank(self, rank: u8) -> Self {
        match rank {
            0 => self,
            _ => Self { depth: self.depth.behind(rank), ..self },
        }
    }

    /// The least and the greatest coordinates of its corners, in steps of 1/256 pixel.
    #[must_use]
    pub fn bounds(&self) -> [[i32; 2]; 2] {
        let least = |of: &[i32; 3]| of[0].min(of[1]).min(of[2]);
        let greatest = |of: &[i32; 3]| of[0].max(of[1]).max(of[2]);
        [[least(&self.x), least(&self.y)], [greatest(&self.x), greatest(&self.y)]]
    }

    /// The pixels of a region whose sample at `offset` lies in the triangle's box; `None` if there
    /// are none.
    #[inline(always)]
    #[must_use]
    pub fn pixels(&self, tile: Region, offset: [i32; 2]) -> Option<Region> {
        let (left, right) = range(self.x, offset[0], tile.x, tile.width)?;
        let (top, bottom) = range(self.y, offset[1], tile.y, tile.height)?;
        Some(Region { x: left, y: top, width: right - left + 1, height: bottom - top + 1 })
    }

    /// How much of a region's samples at `offset` it covers.
    #[inline(always)]
    #[must_use]
    pub fn overlap(&self, region: Region, offset: [i32; 2]) -> Overlap {
        let in_box = self.pixels(region, offset).is_some();
        match self.edges(region, offset).filter(|_| in_box) {
            None => Overlap::None,
            Some(edges) if edges == [Edge::default(); 3] => Overlap::Whole,
            Some(_) => Overlap::Part,
        }
    }

    /// The edge functions over a region for the samples at `offset`; an edge that the region lies
    /// wholly inside of is 0 everywhere, which passes. `None` if the region lies outside of one.
    #[inline(always)]
    pub(crate) fn edges(&self, region: Region, offset: [i32; 2]) -> Option<[Edge; 3]> {
        let sample_x = i64::from(region.x * SUBPIXELS + offset[0]);
        let sample_y = i64::from(region.y * SUBPIXELS + offset[1]);
        let mut edges = [Edge::default(); 3];
        for (corner, edge) in edges.iter_mut().enumerate() {
            let next = if corner == 2 { 0 } else { corner + 1 };
            let (px, py) = (self.x[corner], self.y[corner]);
            let (dx, dy) = (self.x[next] - px, self.y[next] - py);
            // Left edges run upwards with the inside to their right, top edges to the right.
            let left_or_top = dy < 0 || dy == 0 && dx > 0;
            let value = i64::from(dx) * (sample_y - i64::from(py))
                - i64::from(dy) * (sample_x - i64::from(px))
                - i64::from(!left_or_top);
            let start = value >> SUBPIXELS.ilog2();
            let across = i64::from(-dy) * i64::from(region.width - 1);
            let down = i64::from(dx) * i64::from(region.height - 1);
            if start + across.max(0) + down.max(0) < 0 {
                return None;
            }
            if start + across.min(0) + down.min(0) < 0 {
                *edge = Edge { start: start as i32, step_x: -dy, step_y: dx };
            }
        }
        Some(edges)
    }
}

/// The pixels from `first`, `count` of them at most, whose sample lies between the corners.
#[inline(always)]
fn range(corners: [i32; 3], offset: i32, first: i32, count: i32) -> Option<(i32, i32)> {
    let low = corners[0].min(corners[1]).min(corners[2]);
    let high = corners[0].max(corners[1]).max(corners[2]);
    let shift = SUBPIXELS.ilog2();
    // low <= 256 pixel + offset <= high
    let from = ((low - offset + SUBPIXELS - 1) >> shift).max(first);
    let to = ((high - offset) >> shift).min(first + count - 1);
    (from <= to).then_some((from, to))
}
