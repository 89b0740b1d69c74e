//! Triangles of a few pixels, sixteen at a time to the end: most of a fine mesh's are such.
//!
//! A lane is a triangle here, not a pixel. Triangles wait in queues by size, so that a queue's
//! sixteen go through the samples of their boxes in step. Coverage and depth are those of
//! [`Triangle`](super::setup::Triangle), number by number: edge functions are exact integers, here
//! small enough for products of 16 bits, and the depth plane has its one formula.

use super::sample_cull::{Corners, SIZES};
use super::tile_points::{self, SamplePixels, turned, x_of, y_of};

use crate::types::{BLOCK, BLOCKS, Region, TILE};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i16x32, i32x16, prelude::*};

/// What takes the samples of small triangles. Mark its method `#[inline(always)]`.
pub trait SmallSink<I> {
    /// Takes one sample of each of some triangles. Two of them may be the same one.
    fn put<S: Simd>(&mut self, samples: &SmallSamples<'_, S, I>);
}

/// A sample each of up to sixteen triangles, lane by lane.
#[derive(Clone, Copy)]
pub struct SmallSamples<'q, S: Simd, I> {
    /// The triangles, by what they were given with.
    pub ids: &'q [I; LANES],
    /// The lanes whose triangle covers its sample, a bit each.
    pub covered: u32,
    /// Depths.
    pub z: f32x16<S>,
    /// Which sample of the pixels.
    pub sample: usize,
    /// About the tile's middle.
    pub(crate) pixels: i16x32<S>,
}

/// Where samples lie in a plane, row by row within a block and block by block, and their depths.
///
/// In lines of the cache, which also makes the compiler lay what finds no register into such lines, not across two.
#[repr(align(64))]
pub struct SmallPlaces {
    /// Places; only those of samples that are covered lie within the plane.
    pub places: [i32; LANES],
    /// Depths.
    pub z: [f32; LANES],
}

impl<S: Simd, I> SmallSamples<'_, S, I> {
    /// Places and depths in memory.
    #[inline(always)]
    #[must_use]
    pub fn places(&self) -> SmallPlaces {
        let simd = self.z.simd;
        let within_tile = self.pixels + tile_points::splat(simd, [TILE / 2; 2]);
        // Whole numbers of pixels, and of blocks.
        let blocks = within_tile >> BLOCK.ilog2();
        let place = tile_points::dot(within_tile, tile_points::splat(simd, [1, BLOCK]))
            + tile_points::dot(blocks, tile_points::splat(simd, BLOCK_STEPS));
        let mut places = SmallPlaces { places: [0; LANES], z: [0.0; LANES] };
        place.store_slice(&mut places.places);
        self.z.store_slice(&mut places.z);
        places
    }
}

/// The samples of a tile.
#[derive(Clone, Copy, Debug)]
pub struct SampleGrid<'o> {
    /// The tile's pixels: 64 or fewer each way.
    pub region: Region,
    /// Where the samples of a pixel lie, in steps of 1/256 pixel from its corner.
    pub offsets: &'o [[i32; 2]],
}

/// Triangles that wait to be drawn together.
pub(crate) struct Queues<I>([Queue<I>; SIZES]);

/// Up to sixteen triangles, each a lane.
#[repr(C, align(64))]
struct Queue<I> {
    corners: Corners,
    ids: [I; LANES],
    count: usize,
}

impl<I: Copy> Queues<I> {
    /// Empty ones; `none` stands for no triangle.
    pub(crate) fn new(none: I) -> Self {
        Self(std::array::from_fn(|_| Queue {
            corners: [[[0; 2]; LANES]; 3],
            ids: [none; LANES],
            count: 0,
        }))
    }

    /// Takes a triangle, on a side that is drawn, into the queue of its size; whether that is full now
    /// and has to be drawn.
    #[inline(always)]
    pub(crate) fn push(&mut self, size: usize, corners: &Corners, lane: usize, id: I) -> bool {
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
        grid: SampleGrid<'_>,
        sink: &mut impl SmallSink<I>,
    ) {
        draw(simd, &mut self.0[size], grid, sink);
    }

    /// Draws what still waits.
    #[inline(always)]
    pub(crate) fn finish<S: Simd>(
        &mut self,
        simd: S,
        grid: SampleGrid<'_>,
        sink: &mut impl SmallSink<I>,
    ) {
        for queue in &mut self.0 {
            if queue.count > 0 {
                draw(simd, queue, grid, sink);
            }
        }
    }
}

/// Draws the triangles of a queue and empties it. Compiled once a level, not into its callers.
#[inline(never)]
fn draw<S: Simd, I>(
    simd: S,
    queue: &mut Queue<I>,
    grid: SampleGrid<'_>,
    sink: &mut impl SmallSink<I>,
) {
    simd.vectorize(
        #[inline(always)]
        || draw_lanes(simd, queue, grid, sink),
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
fn draw_lanes<S: Simd, I>(
    simd: S,
    queue: &Queue<I>,
    grid: SampleGrid<'_>,
    sink: &mut impl SmallSink<I>,
) {
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
    for (sample, &offset) in grid.offsets.iter().enumerate() {
        let SamplePixels { first, last } = SamplePixels::new(low, high, offset, grid.region);
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
                    let ids = &queue.ids;
                    sink.put(&SmallSamples { ids, covered, z, sample, pixels });
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

/// How much farther the first place of the next block to the right, and of the next one below, is than
/// steps from pixel to pixel lead.
const BLOCK_STEPS: [i32; 2] = [LANES as i32 - BLOCK, BLOCKS * LANES as i32 - BLOCK * BLOCK];
