//! Triangles of a few pixels, sixteen at a time to the end: most of a fine mesh's are such.
//!
//! A lane is a triangle here, not a pixel. Triangles wait in queues by size, so that a queue's
//! sixteen go through the samples of their boxes in step. Coverage and depth are those of
//! [`Triangle`](super::setup::Triangle), number by number: edge functions are exact integers, here
//! small enough for products of 16 bits, and the depth plane has its one formula.

use super::buffer::{Plane, Tile};
use super::rules::{self, Rules};
use super::sample_cull::{Corners, SIZES};
use super::tile_points::{self, SamplePixels, turned, x_of, y_of};

use crate::types::{BLOCK, BLOCKS, TILE, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i16x32, i32x16, lanes_of, prelude::*};

/// Triangles that wait to be drawn together.
pub(crate) struct Queues([Queue; SIZES]);

/// Up to sixteen triangles, each a lane.
#[repr(C, align(64))]
struct Queue {
    corners: Corners,
    ids: [TriangleId; LANES],
    count: usize,
}

impl Queue {
    const EMPTY: Self =
        Self { corners: [[[0; 2]; LANES]; 3], ids: [TriangleId::NONE; LANES], count: 0 };
}

impl Queues {
    pub(crate) fn new() -> Self {
        Self([const { Queue::EMPTY }; SIZES])
    }

    /// Takes a triangle, on a side that is drawn, into the queue of its size; whether that is full now
    /// and has to be drawn.
    #[inline(always)]
    pub(crate) fn push(
        &mut self,
        size: usize,
        corners: &Corners,
        lane: usize,
        id: TriangleId,
    ) -> bool {
        let queue = &mut self.0[size];
        let place = queue.count & (LANES - 1);
        queue.corners[0][place] = corners[0][lane];
        queue.corners[1][place] = corners[1][lane];
        queue.corners[2][place] = corners[2][lane];
        queue.ids[place] = id;
        queue.count = place + 1;
        place + 1 == LANES
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

/// An edge function in every lane.
#[derive(Clone, Copy)]
struct Edges<S: Simd> {
    corner: i16x32<S>,
    /// What a sample's distance from the corner is multiplied with.
    normal: i16x32<S>,
    /// -1 where a sample on the edge is outside: where the edge is neither a left nor a top one.
    bias: i32x16<S>,
}

impl<S: Simd> Edges<S> {
    #[inline(always)]
    fn new(from: i16x32<S>, to: i16x32<S>) -> Self {
        let along = to - from;
        // Left edges run upwards, dy < 0, and top ones to the right, dy = 0 and dx > 0: as one number,
        // dy above dx, these are below 2^15, and above 0 if they aren't below it. 0 is an edge without
        // length, of a triangle without area.
        let words: i32x16<S> = along.bitcast();
        let bias = (i32x16::splat(words.simd, (1 << 15) - 1) - words) >> 31;
        Self { corner: from, normal: turned(along), bias }
    }

    /// E at a sample, below 0 outside.
    #[inline(always)]
    fn at(&self, sample: i16x32<S>) -> i32x16<S> {
        tile_points::dot(self.normal, sample - self.corner) + self.bias
    }

    /// How it changes from one pixel to the next: across and down.
    #[inline(always)]
    fn steps(&self) -> [i32x16<S>; 2] {
        const SHIFT: u32 = SUBPIXELS.ilog2();
        [x_of(self.normal) << SHIFT, y_of(self.normal) << SHIFT]
    }
}

#[inline(always)]
fn draw_lanes<S: Simd>(simd: S, queue: &Queue, rules: &Rules<'_>, tile: &mut Tile) {
    let [a, b, c] = &queue.corners;
    let (a, az) = tile_points::with_depths(simd, a);
    let (b, bz) = tile_points::with_depths(simd, b);
    let (c, cz) = tile_points::with_depths(simd, c);

    // The depth plane, as in `Triangle::new`.
    let (ab, ac) = (b - a, c - a);
    let (ab_x, ab_y) = (f32x16::float_from(x_of(ab)), f32x16::float_from(y_of(ab)));
    let (ac_x, ac_y) = (f32x16::float_from(x_of(ac)), f32x16::float_from(y_of(ac)));
    let area = tile_points::dot(turned(ab), ac);
    let (ab_z, ac_z) = (bz - az, cz - az);
    let scale = f32x16::float_from(area);
    let dz_dx = (ab_z * ac_y - ac_z * ab_y) / scale;
    let dz_dy = (ac_z * ab_x - ab_z * ac_x) / scale;
    let low_z = az.minimum(bz).minimum(cz);
    let high_z = az.maximum(bz).maximum(cz);

    // Corners in an order that makes the inside positive.
    let is_turned = area.simd_lt(0);
    let (b_words, c_words): (i32x16<S>, i32x16<S>) = (b.bitcast(), c.bitcast());
    let second: i16x32<S> = is_turned.select(c_words, b_words).bitcast();
    let third: i16x32<S> = is_turned.select(b_words, c_words).bitcast();
    let edges = [Edges::new(a, second), Edges::new(second, third), Edges::new(third, a)];
    let [step_x0, step_y0] = edges[0].steps();
    let [step_x1, step_y1] = edges[1].steps();
    let [step_x2, step_y2] = edges[2].steps();

    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    // Without area, nothing is covered.
    let used = !area.simd_eq(0).to_bitmask() as u32 & ((1 << queue.count) - 1);
    let (right, down) = (tile_points::splat(simd, [1, 0]), tile_points::splat(simd, [0, 1]));
    for (sample, &offset) in rules.offsets.iter().enumerate() {
        let SamplePixels { first, last } = SamplePixels::new(low, high, offset, tile.region);
        let count = last - first;
        let mut rows = used & !tile_points::negative(count);
        let (columns, mut rows_left) = (x_of(count), y_of(count));
        let first_sample = (first << SUBPIXELS.ilog2()) + tile_points::splat(simd, offset);
        // Whole numbers: steps added one by one give what a multiplication would.
        let mut row_e0 = edges[0].at(first_sample);
        let mut row_e1 = edges[1].at(first_sample);
        let mut row_e2 = edges[2].at(first_sample);
        let from_a = first_sample - a;
        let first_dx = f32x16::float_from(x_of(from_a));
        let mut dy = f32x16::float_from(y_of(from_a));
        let mut row_pixels = first;
        while rows != 0 {
            let (mut e0, mut e1, mut e2) = (row_e0, row_e1, row_e2);
            let (mut pixels, mut dx) = (row_pixels, first_dx);
            let mut inside = rows;
            let mut columns_left = columns;
            loop {
                let covered = inside & !(e0 | e1 | e2).simd_lt(0).to_bitmask() as u32;
                if covered != 0 {
                    let z = dx * dz_dx + az + dy * dz_dy;
                    let z = z.maximum(low_z).minimum(high_z);
                    put(queue, covered, pixels, z, rules, tile, sample);
                }
                columns_left -= 1;
                inside &= !columns_left.simd_lt(0).to_bitmask() as u32;
                if inside == 0 {
                    break;
                }
                pixels += right;
                dx += SUBPIXELS as f32;
                e0 += step_x0;
                e1 += step_x1;
                e2 += step_x2;
            }
            rows_left -= 1;
            rows &= !rows_left.simd_lt(0).to_bitmask() as u32;
            row_pixels += down;
            dy += SUBPIXELS as f32;
            row_e0 += step_y0;
            row_e1 += step_y1;
            row_e2 += step_y2;
        }
    }
}

/// Sixteen values in a line of the cache. What lies in one also makes the compiler lay what finds no
/// register into such lines, not across two.
#[repr(align(64))]
struct Line<T>([T; LANES]);

/// Puts one sample of each of some triangles where it wins. `pixels` are about the tile's middle.
#[inline(always)]
fn put<S: Simd>(
    queue: &Queue,
    covered: u32,
    pixels: i16x32<S>,
    z: f32x16<S>,
    rules: &Rules<'_>,
    tile: &mut Tile,
    sample: usize,
) {
    // Row by row within a block, and block by block: whole numbers of pixels, and of blocks.
    let within_tile = pixels + tile_points::splat(z.simd, [TILE / 2; 2]);
    let blocks = within_tile >> BLOCK.ilog2();
    let place = tile_points::dot(within_tile, tile_points::splat(z.simd, [1, BLOCK]))
        + tile_points::dot(blocks, tile_points::splat(z.simd, BLOCK_STEPS));
    let (mut places, mut depths) = (Line([0; LANES]), Line([0.0; LANES]));
    place.store_slice(&mut places.0);
    z.store_slice(&mut depths.0);
    let (Line(places), Line(depths)) = (&places, &depths);
    let mut left = covered;
    if rules.behind.is_none() && rules.holes.is_none() {
        // Nearly always. Only of equally near ones more is asked.
        let mut rest = covered;
        left = 0;
        let Plane { depth, ids } = &mut tile.planes[sample];
        let (depth, ids) = (depth.as_flattened_mut(), ids.as_flattened_mut());
        while rest != 0 {
            let number = rest.trailing_zeros() as usize & (LANES - 1);
            rest &= rest - 1;
            let place = places[number] as usize & (SAMPLES - 1);
            let (z, before) = (depths[number], depth[place]);
            if before < z {
                depth[place] = z;
                ids[place] = queue.ids[number].0;
            } else if before == z {
                left |= 1 << number;
            }
        }
        if left == 0 {
            return;
        }
    }
    put_rest(queue, left, pixels, places, depths, rules, tile, sample);
}

/// Puts those of which more has to be asked: a function of its own, as it is rarely called.
#[inline(never)]
#[expect(clippy::too_many_arguments, reason = "the state of a loop, which has one caller")]
fn put_rest<S: Simd>(
    queue: &Queue,
    mut left: u32,
    pixels: i16x32<S>,
    places: &[i32; LANES],
    depths: &[f32; LANES],
    rules: &Rules<'_>,
    tile: &mut Tile,
    sample: usize,
) {
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
            let [x, y] = tile_points::middle_of(tile.region);
            left &= !pixels.simd.vectorize(
                #[inline(always)]
                || {
                    let across = (x_of(pixels) + x) * SUBPIXELS + offset_x;
                    let down = (y_of(pixels) + y) * SUBPIXELS + offset_y;
                    rules::ask(holes, queue.ids, [across, down], left)
                },
            );
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

/// How much farther the first place of the next block to the right, and of the next one below, is than
/// steps from pixel to pixel lead.
const BLOCK_STEPS: [i32; 2] = [LANES as i32 - BLOCK, BLOCKS * LANES as i32 - BLOCK * BLOCK];
/// Samples of a plane.
const SAMPLES: usize = (TILE * TILE) as usize;
