//! Triangles of a few pixels, sixteen at a time to the end: most of a fine mesh's are such.
//!
//! A lane is a triangle here, not a pixel. Triangles wait in queues by size, so that a queue's
//! sixteen go through the samples of their boxes in step. Coverage and depth are those of
//! [`Triangle`](super::setup::Triangle), number by number: edge functions are exact integers, here
//! small enough for i32 without a shift, and the depth plane has its one formula.

use super::buffer::{Plane, Tile};
use super::rules::{self, Rules};
use super::sample_cull::{Corners, SIZES, in_lanes};
use super::transform::ClusterVertices;
use crate::types::{BLOCK, BLOCKS, TILE, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, lanes_of, mask32x16, prelude::*};

/// Triangles that wait to be drawn together.
pub(crate) struct Queues([Queue; SIZES.len()]);

/// Up to sixteen triangles, each a lane.
#[repr(C, align(64))]
struct Queue {
    /// Corners in the window, in steps of 1/256 pixel.
    corners: Corners,
    /// Reversed depths of the corners.
    z: [[f32; LANES]; 3],
    ids: [TriangleId; LANES],
    count: usize,
}

impl Queues {
    pub(crate) fn new() -> Self {
        let queue = || Queue {
            count: 0,
            corners: [[[0; 2]; LANES]; 3],
            z: [[0.0; LANES]; 3],
            ids: [TriangleId::NONE; LANES],
        };
        Self([queue(), queue(), queue(), queue()])
    }

    /// Takes a triangle with area, on a side that is drawn, into the queue of its size; whether that
    /// is full now and has to be drawn.
    #[inline(always)]
    pub(crate) fn push(
        &mut self,
        size: usize,
        vertices: &ClusterVertices,
        corners: [usize; 3],
        id: TriangleId,
    ) -> bool {
        let queue = &mut self.0[size];
        let lane = queue.count & (LANES - 1);
        for (place, corner) in corners.into_iter().enumerate() {
            queue.corners[place][lane] = vertices.xy[corner];
            queue.z[place][lane] = vertices.z[corner];
        }
        queue.ids[lane] = id;
        queue.count += 1;
        queue.count == LANES
    }

    /// Draws what waits in one queue.
    #[inline(always)]
    pub(crate) fn draw<S: Simd>(
        &mut self,
        simd: S,
        size: usize,
        rules: &Rules<'_>,
        tile: &mut Tile,
    ) {
        draw(simd, &mut self.0[size], rules, tile);
    }

    /// Draws what still waits.
    #[inline(always)]
    pub(crate) fn finish<S: Simd>(&mut self, simd: S, rules: &Rules<'_>, tile: &mut Tile) {
        for queue in &mut self.0 {
            if queue.count > 0 {
                draw(simd, queue, rules, tile);
            }
        }
    }
}

/// Draws the triangles of a queue and empties it. Compiled once a level, not into its callers.
#[inline(never)]
fn draw<S: Simd>(simd: S, queue: &mut Queue, rules: &Rules<'_>, tile: &mut Tile) {
    simd.vectorize(
        #[inline(always)]
        || draw_lanes(simd, queue, rules, tile),
    );
    queue.count = 0;
}

/// An edge function in every lane: its value at a sample and its changes from pixel to pixel.
#[derive(Clone, Copy)]
struct Edges<S: Simd> {
    x: i32x16<S>,
    y: i32x16<S>,
    dx: i32x16<S>,
    dy: i32x16<S>,
    /// 1 where a sample on the edge is outside: where the edge is neither a left nor a top one.
    bias: i32x16<S>,
}

impl<S: Simd> Edges<S> {
    #[inline(always)]
    fn new([px, py]: [i32x16<S>; 2], [qx, qy]: [i32x16<S>; 2]) -> Self {
        let (dx, dy) = (qx - px, qy - py);
        let left_or_top = dy.simd_lt(0) | (dy.simd_eq(0) & dx.simd_gt(0));
        let (zero, one) = (i32x16::splat(px.simd, 0), i32x16::splat(px.simd, 1));
        Self { x: px, y: py, dx, dy, bias: left_or_top.select(zero, one) }
    }

    /// E at a sample, below 0 outside. A pixel to the right it is 256 dy less, a pixel below 256 dx
    /// more.
    #[inline(always)]
    fn at(&self, x: i32x16<S>, y: i32x16<S>) -> i32x16<S> {
        self.dx * (y - self.y) - self.dy * (x - self.x) - self.bias
    }
}

#[inline(always)]
fn draw_lanes<S: Simd>(simd: S, queue: &Queue, rules: &Rules<'_>, tile: &mut Tile) {
    let [(ax, ay), (bx, by), (cx, cy)] = in_lanes(simd, &queue.corners);
    let [az, bz, cz] = &queue.z;
    let az = f32x16::simd_from(simd, *az);
    let bz = f32x16::simd_from(simd, *bz);
    let cz = f32x16::simd_from(simd, *cz);
    let used = mask32x16::from_bitmask(simd, (1 << queue.count) - 1);

    // The depth plane, as in `Triangle::new`.
    let (ab_x, ab_y, ac_x, ac_y) = (bx - ax, by - ay, cx - ax, cy - ay);
    let area = ab_x * ac_y - ac_x * ab_y;
    let (ab_z, ac_z) = (bz - az, cz - az);
    let scale = f32x16::float_from(area);
    let dz_dx = (ab_z * f32x16::float_from(ac_y) - ac_z * f32x16::float_from(ab_y)) / scale;
    let dz_dy = (ac_z * f32x16::float_from(ab_x) - ab_z * f32x16::float_from(ac_x)) / scale;
    let low_z = az.minimum(bz).minimum(cz);
    let high_z = az.maximum(bz).maximum(cz);

    // Corners in an order that makes the inside positive.
    let turned = area.simd_lt(0);
    let second = [turned.select(cx, bx), turned.select(cy, by)];
    let third = [turned.select(bx, cx), turned.select(by, cy)];
    let edges =
        [Edges::new([ax, ay], second), Edges::new(second, third), Edges::new(third, [ax, ay])];

    let steps_x = [edges[0].dy * SUBPIXELS, edges[1].dy * SUBPIXELS, edges[2].dy * SUBPIXELS];
    let steps_y = [edges[0].dx * SUBPIXELS, edges[1].dx * SUBPIXELS, edges[2].dx * SUBPIXELS];

    let (left, right) = (ax.min(bx).min(cx), ax.max(bx).max(cx));
    let (top, bottom) = (ay.min(by).min(cy), ay.max(by).max(cy));
    let region = tile.region;
    let shift = SUBPIXELS.ilog2();
    for (sample, &[offset_x, offset_y]) in rules.offsets.iter().enumerate() {
        // The pixels whose sample lies in the box: left <= 256 pixel + offset <= right.
        let first_x = ((left + (SUBPIXELS - 1 - offset_x)) >> shift).max(region.x);
        let first_y = ((top + (SUBPIXELS - 1 - offset_y)) >> shift).max(region.y);
        let last_x = ((right - offset_x) >> shift).min(region.x + region.width - 1);
        let last_y = ((bottom - offset_y) >> shift).min(region.y + region.height - 1);
        let boxed = used & first_x.simd_le(last_x) & first_y.simd_le(last_y);
        let [first_sample_x, first_sample_y] =
            [first_x * SUBPIXELS + offset_x, first_y * SUBPIXELS + offset_y];
        // Whole numbers: steps added one by one give what a multiplication would.
        let [mut row_e0, mut row_e1, mut row_e2] = [
            edges[0].at(first_sample_x, first_sample_y),
            edges[1].at(first_sample_x, first_sample_y),
            edges[2].at(first_sample_x, first_sample_y),
        ];
        let mut y = first_y;
        let mut rows = boxed;
        while rows.any_true() {
            let (mut e0, mut e1, mut e2) = (row_e0, row_e1, row_e2);
            let mut x = first_x;
            let mut inside = rows;
            while inside.any_true() {
                let covered = (inside & (e0 | e1 | e2).simd_ge(0)).to_bitmask() as u32;
                if covered != 0 {
                    let row_z = f32x16::float_from(y * SUBPIXELS + offset_y - ay) * dz_dy;
                    let dx = f32x16::float_from(x * SUBPIXELS + offset_x - ax);
                    let z = dx * dz_dx + az + row_z;
                    let z = z.maximum(low_z).minimum(high_z);
                    put(queue, covered, [x, y], z, rules, tile, sample);
                }
                x += 1;
                e0 -= steps_x[0];
                e1 -= steps_x[1];
                e2 -= steps_x[2];
                inside &= x.simd_le(last_x);
            }
            row_e0 += steps_y[0];
            row_e1 += steps_y[1];
            row_e2 += steps_y[2];
            y += 1;
            rows &= y.simd_le(last_y);
        }
    }
}

/// Sixteen values in a line of the cache. What lies in one also makes the compiler lay what finds no
/// register into such lines, not across two.
#[repr(align(64))]
struct Line<T>([T; LANES]);

/// Puts one sample of each of some triangles where it wins.
#[inline(always)]
fn put<S: Simd>(
    queue: &Queue,
    covered: u32,
    [x, y]: [i32x16<S>; 2],
    z: f32x16<S>,
    rules: &Rules<'_>,
    tile: &mut Tile,
    sample: usize,
) {
    let (column, row) = (x - tile.region.x, y - tile.region.y);
    const SHIFT: u32 = BLOCK.ilog2();
    let block = (row >> SHIFT) * BLOCKS + (column >> SHIFT);
    let within = (row & (BLOCK - 1)) * BLOCK + (column & (BLOCK - 1));
    let (mut places, mut depths) = (Line([0; LANES]), Line([0.0; LANES]));
    (block * LANES as i32 + within).store_slice(&mut places.0);
    z.store_slice(&mut depths.0);
    let (Line(places), Line(depths)) = (&places, &depths);
    let mut left = covered;
    if rules.behind.is_none() && rules.holes.is_none() {
        // Nearly always. Only of equally near ones more is asked.
        left = 0;
        let Plane { depth, ids } = &mut tile.planes[sample];
        let (depth, ids) = (depth.as_flattened_mut(), ids.as_flattened_mut());
        for number in lanes_of(covered) {
            let place = places[number] as usize & (SAMPLES - 1);
            let (z, before) = (depths[number], depth[place]);
            let nearer = before < z;
            depth[place] = if nearer { z } else { before };
            ids[place] = if nearer { queue.ids[number].0 } else { ids[place] };
            left |= u32::from(before == z) << number;
        }
    }
    let place = |number: usize| {
        let place = places[number] as usize;
        (place / LANES, place % LANES)
    };
    if let Some(holes) = rules.holes {
        for number in lanes_of(left) {
            let id = queue.ids[number];
            let wins = rules::wins(id, depths[number], place(number), rules, tile, sample);
            left &= !(u32::from(!wins) << number);
        }
        if left != 0 {
            let [offset_x, offset_y] = rules.offsets[sample];
            let position = [x * SUBPIXELS + offset_x, y * SUBPIXELS + offset_y];
            left &= !rules::ask(holes, queue.ids, position, left);
        }
    }
    // Two of them may want the same sample.
    for number in lanes_of(left) {
        let (id, z) = (queue.ids[number], depths[number]);
        if rules::wins(id, z, place(number), rules, tile, sample) {
            rules::put(id, z, place(number), tile, sample);
        }
    }
}

/// Samples of a plane.
const SAMPLES: usize = (TILE * TILE) as usize;
