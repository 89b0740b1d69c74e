//! Filled triangles, sixteen at a time: which of them are drawn, which have to be clipped, and which tiles they reach
//! (OpenGL 1.5, sections 2.11 and 3.5.1).

use super::batch::Batch;
use super::draw_state::DrawState;
use super::placement::spanned_area;
use crate::vertex::codes;
use luxel_math::{
    F64Lanes, F64x16, LANES, Lanes, Mask, SUBPIXELS, Simd, f32x16, i32x16, prelude::*,
};
use luxel_visibility::TILE;

/// Up to sixteen triangles as they were given.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct TriangleGroup {
    corners: [[u32; 3]; LANES],
    /// The vertices whose colours flat shading takes.
    provoking: [u32; LANES],
    /// Those whose side is known, a bit each; and those among them that show their back.
    known: u32,
    known_backs: u32,
    count: usize,
}

/// What becomes of the triangles of a group.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    /// Those of which something may be drawn, a bit each.
    pub(super) drawn: u32,
    /// Those among them that planes may cut; the others are drawn as they lie in the window.
    pub(super) clipped: u32,
    /// Those that show their back.
    backs: u32,
    /// The first and the last column and row of tiles.
    tiles: [[i32; LANES]; 4],
}

impl Placed {
    /// The side that a triangle shows: 0 is the front, 1 the back.
    #[inline(always)]
    pub(super) fn side(&self, lane: usize) -> usize {
        (self.backs >> lane & 1) as usize
    }

    /// The tiles that a triangle may reach: the first and the last column and row.
    #[inline(always)]
    pub(super) fn tiles(&self, lane: usize) -> [u8; 4] {
        // A side of a framebuffer is 256 tiles at most.
        let [left, bottom, right, top] = &self.tiles;
        [left[lane] as u8, bottom[lane] as u8, right[lane] as u8, top[lane] as u8]
    }
}

impl TriangleGroup {
    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    pub(super) fn clear(&mut self) {
        (self.known, self.known_backs, self.count) = (0, 0, 0);
    }

    /// A triangle's vertices, and the one whose colour flat shading takes.
    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> ([u32; 3], u32) {
        let lane = lane & (LANES - 1);
        (self.corners[lane], self.provoking[lane])
    }

    /// A triangle's side, if it is known.
    pub(super) fn facing(&self, lane: usize) -> Option<usize> {
        (self.known >> lane & 1 == 1).then_some((self.known_backs >> lane & 1) as usize)
    }

    /// Takes a triangle, with its side if that is known; whether the group is full now.
    #[inline(always)]
    pub(super) fn push(
        &mut self,
        corners: [u32; 3],
        provoking: u32,
        facing: Option<usize>,
    ) -> bool {
        let lane = self.count & (LANES - 1);
        self.corners[lane] = corners;
        self.provoking[lane] = provoking;
        if let Some(side) = facing {
            self.known |= 1 << lane;
            self.known_backs |= (side as u32) << lane;
        }
        self.count = lane + 1;
        self.count == LANES
    }

    /// Finds out what becomes of them.
    #[inline(always)]
    pub(super) fn placed<S: Simd>(&self, simd: S, state: &DrawState, batch: &Batch) -> Placed {
        let vertices = &batch.vertices;
        let [mut xs, mut ys] = [[[0; LANES]; 3]; 2];
        // Codes that any corner has, and those that all have.
        let (mut any, mut all) = ([0; LANES], [0; LANES]);
        let Self { known, known_backs, .. } = *self;
        for (lane, corners) in self.corners[..self.count].iter().enumerate() {
            let [mut any_of, mut all_of] = [0, u16::MAX];
            for (corner, &vertex) in corners.iter().enumerate() {
                let place = &vertices.window[vertex as usize];
                let code = vertices.codes[vertex as usize];
                (xs[corner][lane], ys[corner][lane]) = (place.x, place.y);
                (any_of, all_of) = (any_of | code, all_of & code);
            }
            (any[lane], all[lane]) = (i32::from(any_of), i32::from(all_of));
        }
        let any = i32x16::from_slice(simd, &any);
        let all = i32x16::from_slice(simd, &all);
        let has =
            |of: i32x16<S>, codes: u16| !(of & i32::from(codes)).simd_eq(0).to_bitmask() as u32;
        let given = (1_u32 << self.count) - 1;
        let in_sight = given & !has(all, codes::OUTSIDE) & !has(any, codes::NOT_FINITE);
        let clipped = in_sight & has(any, codes::OUTSIDE & !codes::SIDES | codes::NOT_HELD);

        let [ax, bx, cx] = in_lanes(simd, &xs);
        let [ay, by, cy] = in_lanes(simd, &ys);
        let (ab, ac) = ([exact(bx - ax), exact(by - ay)], [exact(cx - ax), exact(cy - ay)]);
        let area = spanned_area(ab, ac);
        let counter_clockwise = area.is_positive().bits();
        let has_area = counter_clockwise | (-area).is_positive().bits();
        let front =
            if state.front_is_counter_clockwise { counter_clockwise } else { !counter_clockwise };
        let backs = known & known_backs | !known & !front;
        let mut drawn = has_area;
        for (side, of_side) in [!backs, backs].into_iter().enumerate() {
            if state.is_culled(side) {
                drawn &= !of_side;
            }
        }

        let [low, high] = batch.reach_of_centres();
        let tile = TILE.ilog2();
        let pixel = SUBPIXELS.ilog2();
        let region = batch.polygon_region;
        let left = ((ax.min(bx).min(cx) + low) >> pixel).max(region[0]);
        let bottom = ((ay.min(by).min(cy) + low) >> pixel).max(region[1]);
        let right = ((ax.max(bx).max(cx) + high) >> pixel).min(region[2] - 1);
        let top = ((ay.max(by).max(cy) + high) >> pixel).min(region[3] - 1);
        drawn &= (left.simd_le(right) & bottom.simd_le(top)).to_bitmask() as u32;
        let mut tiles = [[0; LANES]; 4];
        for (of, pixels) in tiles.iter_mut().zip([left, bottom, right, top]) {
            (pixels >> tile).store_slice(of);
        }
        let drawn = in_sight & drawn & !clipped | clipped;
        Placed { drawn, clipped, backs, tiles }
    }
}

#[inline(always)]
fn in_lanes<S: Simd>(simd: S, of: &[[i32; LANES]; 3]) -> [i32x16<S>; 3] {
    let [a, b, c] = of;
    [i32x16::from_slice(simd, a), i32x16::from_slice(simd, b), i32x16::from_slice(simd, c)]
}

/// How far two places of the guard band are apart: less than 2^24 steps of 1/256 pixel.
#[inline(always)]
fn exact<S: Simd>(steps: i32x16<S>) -> F64x16<S> {
    f32x16::float_from(steps).to_f64()
}
