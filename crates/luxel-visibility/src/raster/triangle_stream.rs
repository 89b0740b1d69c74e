//! Triangles one by one into the samples of a tile, whatever takes them: small ones wait for others.

use super::sample_cull::{SIZES, TriangleGroup};
use super::small_triangles::{Queues, SampleGrid, SmallSink};
use super::tile_points;
use crate::types::{CullFaces, WindowVertex};
use luxel_math::{LANES, Simd, f32x16, i32x16, prelude::*};

/// What takes the samples of triangles of which small ones come later than they were given. Mark its methods
/// `#[inline(always)]`.
pub trait StreamSink<I>: SmallSink<I> {
    /// Takes a triangle that isn't small: these come in the order in which they were given.
    fn large<S: Simd>(&mut self, simd: S, corners: [WindowVertex; 3], id: I);
}

/// Triangles of one tile. Those of up to seven pixels across and down wait until sixteen of about the same size can go
/// through their samples together; those that hold no sample are dropped.
///
/// Samples are those of [`cover`](super::sink::cover), and so are depths, to the bit. Only their order is another: who
/// takes them must know from the triangles what the order was, where it matters.
pub struct TriangleStream<I> {
    group: GivenTriangles<I>,
    /// How many of the group are there.
    count: usize,
    queues: Queues<I>,
}

/// Sixteen triangles as they were given, one a lane.
#[repr(align(64))]
struct GivenTriangles<I> {
    x: [[i32; LANES]; 3],
    y: [[i32; LANES]; 3],
    z: [[f32; LANES]; 3],
    ids: [I; LANES],
}

impl<I: Copy> TriangleStream<I> {
    /// Without triangles; `none` stands for one that isn't there.
    #[must_use]
    pub fn new(none: I) -> Self {
        let group = GivenTriangles {
            x: [[0; LANES]; 3],
            y: [[0; LANES]; 3],
            z: [[0.0; LANES]; 3],
            ids: [none; LANES],
        };
        Self { group, count: 0, queues: Queues::new(none) }
    }

    /// Takes a triangle, whose corners lie within the guard band; both of its sides are drawn.
    #[inline(always)]
    pub fn push<S: Simd>(
        &mut self,
        simd: S,
        corners: [WindowVertex; 3],
        id: I,
        grid: SampleGrid<'_>,
        sink: &mut impl StreamSink<I>,
    ) {
        let lane = self.count & (LANES - 1);
        for (number, corner) in corners.into_iter().enumerate() {
            self.group.x[number][lane] = corner.x;
            self.group.y[number][lane] = corner.y;
            self.group.z[number][lane] = corner.z;
        }
        self.group.ids[lane] = id;
        self.count = lane + 1;
        if self.count == LANES {
            self.sort_out(simd, grid, sink);
        }
    }

    /// Draws all that waits.
    #[inline(never)]
    pub fn finish<S: Simd>(
        &mut self,
        simd: S,
        grid: SampleGrid<'_>,
        sink: &mut impl StreamSink<I>,
    ) {
        if self.count > 0 {
            self.sort_out(simd, grid, sink);
        }
        self.queues.finish(simd, grid, sink);
    }

    /// Drops triangles of the group, draws them, or puts them into queues.
    #[inline(never)]
    fn sort_out<S: Simd>(&mut self, simd: S, grid: SampleGrid<'_>, sink: &mut impl StreamSink<I>) {
        simd.vectorize(
            #[inline(always)]
            || self.sort_lanes(simd, grid, sink),
        );
        self.count = 0;
    }

    #[inline(always)]
    fn sort_lanes<S: Simd>(
        &mut self,
        simd: S,
        grid: SampleGrid<'_>,
        sink: &mut impl StreamSink<I>,
    ) {
        let Self { group: given, count, queues } = self;
        let middle = tile_points::middle_of(grid.region);
        let mut group = TriangleGroup::new();
        for (corner, points) in group.corners.iter_mut().enumerate() {
            let x = i32x16::from_slice(simd, &given.x[corner]);
            let y = i32x16::from_slice(simd, &given.y[corner]);
            let z = f32x16::from_slice(simd, &given.z[corner]);
            tile_points::store_with_depths(tile_points::about(x, y, middle), z, points);
        }
        let held = group.may_hold_samples(simd, grid.region, grid.offsets, CullFaces::None);
        let mut left = held & ((1 << *count) - 1);
        while left != 0 {
            let lane = left.trailing_zeros() as usize & (LANES - 1);
            left &= left - 1;
            let (size, id) = (group.size(lane), given.ids[lane]);
            if size >= SIZES {
                let mut corners = [WindowVertex { x: 0, y: 0, z: 0.0 }; 3];
                for (number, corner) in corners.iter_mut().enumerate() {
                    corner.x = given.x[number][lane];
                    corner.y = given.y[number][lane];
                    corner.z = given.z[number][lane];
                }
                sink.large(simd, corners, id);
            } else if queues.push(size, &group.corners, lane, id) {
                queues.draw(simd, size, grid, sink);
            }
        }
    }
}
