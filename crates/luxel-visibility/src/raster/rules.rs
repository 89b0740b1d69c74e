//! What decides between triangles at a sample.
//!
//! Among the triangles that cover a sample the nearest wins, and of equally near ones the one that
//! was submitted first. This is a total order, so the outcome depends neither on the order of
//! drawing nor on what was culled on the way. A hole is not covered, nor what lies before the last
//! layer peeled off.

use super::buffer::{Plane, Tile};
use crate::types::{Asked, BLOCKS, Holes, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, prelude::*};

/// What decides beyond geometry.
pub(crate) struct Rules<'a> {
    /// The sample positions.
    pub(crate) offsets: &'a [[i32; 2]],
    /// The order in which triangles were submitted.
    pub(crate) submitted: &'a dyn Fn(TriangleId) -> u64,
    /// Holes in triangles, if there are any.
    pub(crate) holes: Option<&'a dyn Holes>,
    /// Only what lies behind these samples counts: the last layer peeled off.
    pub(crate) behind: Option<&'a [Plane]>,
}

/// Whether one sample of a triangle wins in its block and lane, but for holes.
#[inline(always)]
pub(crate) fn wins(
    id: TriangleId,
    z: f32,
    place: (usize, usize),
    rules: &Rules<'_>,
    tile: &Tile,
    sample: usize,
) -> bool {
    let (block, lane) = within_plane(place);
    let target = &tile.planes[sample];
    let depth = target.depth[block][lane];
    let nearer =
        depth < z || depth == z && comes_first(id, TriangleId(target.ids[block][lane]), rules);
    nearer && rules.behind.is_none_or(|behind| passed(&behind[sample], block, lane, id, z, rules))
}

/// Puts one sample of a triangle into its block and lane.
#[inline(always)]
pub(crate) fn put(id: TriangleId, z: f32, place: (usize, usize), tile: &mut Tile, sample: usize) {
    let (block, lane) = within_plane(place);
    let target = &mut tile.planes[sample];
    target.depth[block][lane] = z;
    target.ids[block][lane] = id.0;
}

/// Block and lane, as the compiler can see them to be within a plane.
#[inline(always)]
fn within_plane((block, lane): (usize, usize)) -> (usize, usize) {
    (block & (BLOCKS * BLOCKS - 1) as usize, lane & (LANES - 1))
}

/// Which of some samples, at positions in steps of 1/256 pixel, lie in holes of their triangles.
#[inline(always)]
pub(crate) fn ask<S: Simd>(
    holes: &dyn Holes,
    ids: [TriangleId; LANES],
    position: [i32x16<S>; 2],
    lanes: u32,
) -> u32 {
    let [mut x, mut y] = [[0.0; LANES]; 2];
    let [across, down] = position;
    let step = 1.0 / SUBPIXELS as f32;
    (f32x16::float_from(across) * step).store_slice(&mut x);
    (f32x16::float_from(down) * step).store_slice(&mut y);
    holes.holes(&Asked { ids, x, y, lanes })
}

/// Whether a triangle wins over an equally near one.
pub(super) fn comes_first(id: TriangleId, other: TriangleId, rules: &Rules<'_>) -> bool {
    other == TriangleId::NONE || (rules.submitted)(id) < (rules.submitted)(other)
}

/// Whether a triangle comes after the last layer peeled off, in one lane of a block.
pub(super) fn passed(
    behind: &Plane,
    block: usize,
    lane: usize,
    id: TriangleId,
    z: f32,
    rules: &Rules<'_>,
) -> bool {
    let (depth, other) = (behind.depth[block][lane], TriangleId(behind.ids[block][lane]));
    z < depth
        || z == depth
            && other != TriangleId::NONE
            && (rules.submitted)(id) > (rules.submitted)(other)
}
