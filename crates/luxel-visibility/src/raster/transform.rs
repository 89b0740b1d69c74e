//! Vertices of clusters to the window, sixteen at a time.

use super::tile_points;
use crate::cluster::{CLUSTER_VERTICES, GROUP_WORDS};
use crate::types::{WindowTransform, WindowVertex, row_times, snap};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i16x32, i32x4, i32x16, prelude::*, u32x16};

/// The transformed vertices of one cluster.
#[repr(C, align(64))]
pub(crate) struct ClusterVertices {
    /// Position [about the tile's middle](tile_points) and reversed depth, as bits: what small
    /// triangles are made of, moved as one value.
    pub(crate) points: [[u32; 2]; CLUSTER_VERTICES],
    /// Positions in the window, wherever they are.
    x: [i32; CLUSTER_VERTICES],
    y: [i32; CLUSTER_VERTICES],
}

/// What transformed vertices lie within.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    /// Pixels: left, top, right, bottom; as far as they are about the tile.
    pub(crate) pixels: [i32; 4],
    /// The nearest depth.
    pub(crate) nearest: f32,
}

impl ClusterVertices {
    pub(crate) fn new() -> Self {
        Self {
            points: [[0; 2]; CLUSTER_VERTICES],
            x: [0; CLUSTER_VERTICES],
            y: [0; CLUSTER_VERTICES],
        }
    }

    #[inline(always)]
    pub(crate) fn vertex(&self, corner: usize) -> WindowVertex {
        let z = f32::from_bits(self.points[corner][1]);
        WindowVertex { x: self.x[corner], y: self.y[corner], z }
    }
}

/// Transforms all vertices of a cluster whose every vertex lies in front of the near plane and
/// within the guard band: the same bits as [`WindowTransform::window`].
#[inline(always)]
pub(crate) fn transform_cluster<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    groups: &[[u32; GROUP_WORDS]],
    middle: [i32; 2],
    out: &mut ClusterVertices,
) -> Bounds {
    simd.vectorize(
        #[inline(always)]
        || transform_groups(simd, transform, groups, middle, out),
    )
}

#[inline(always)]
fn transform_groups<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    groups: &[[u32; GROUP_WORDS]],
    middle: [i32; 2],
    out: &mut ClusterVertices,
) -> Bounds {
    let mut low = i16x32::splat(simd, i16::MAX);
    let mut high = i16x32::splat(simd, i16::MIN);
    let mut nearest = f32x16::splat(simd, 0.0);
    let out_points = out.points.as_chunks_mut::<LANES>().0;
    let out_x = out.x.as_chunks_mut::<LANES>().0;
    let out_y = out.y.as_chunks_mut::<LANES>().0;
    for (((group, points), out_x), out_y) in groups.iter().zip(out_points).zip(out_x).zip(out_y) {
        let x: f32x16<S> = u32x16::from_slice(simd, &group[..LANES]).bitcast();
        let y: f32x16<S> = u32x16::from_slice(simd, &group[LANES..2 * LANES]).bitcast();
        let z: f32x16<S> = u32x16::from_slice(simd, &group[2 * LANES..]).bitcast();
        let clip_x = row_times(&transform.rows[0], x, y, z);
        let clip_y = row_times(&transform.rows[1], x, y, z);
        let clip_z = row_times(&transform.rows[2], x, y, z);
        let clip_w = row_times(&transform.rows[3], x, y, z);
        let window_x = i32x16::truncate_from(snap(clip_x, clip_w, transform.centre[0]));
        let window_y = i32x16::truncate_from(snap(clip_y, clip_w, transform.centre[1]));
        let z = clip_z / clip_w;
        window_x.store_slice(out_x);
        window_y.store_slice(out_y);
        let about_middle = tile_points::about(window_x, window_y, middle);
        tile_points::store_with_depths(about_middle, z, points);
        let about_middle: i16x32<S> = about_middle.bitcast();
        (low, high) = (low.min(about_middle), high.max(about_middle));
        nearest = nearest.maximum(z);
    }
    let [left, top] = least(low);
    let [right, bottom] = least(i16x32::splat(simd, -1) - high).map(|reflected| -1 - reflected);
    let shift = SUBPIXELS.ilog2();
    let [x, y] = middle;
    let (nearest, other) = nearest.split();
    Bounds {
        pixels: [
            x + (left >> shift),
            y + (top >> shift),
            x + (right >> shift),
            y + (bottom >> shift),
        ],
        nearest: nearest.maximum(other).as_slice().iter().copied().fold(0.0, f32::max),
    }
}

/// The least coordinates of points.
#[inline(always)]
fn least<S: Simd>(points: i16x32<S>) -> [i32; 2] {
    let (a, b) = points.split();
    let (a, b) = a.min(b).split();
    let least: [i32; 4] = a.min(b).bitcast::<i32x4<S>>().into();
    let [mut x, mut y] = [i32::MAX; 2];
    for point in least {
        (x, y) = (x.min(point << 16 >> 16), y.min(point >> 16));
    }
    [x, y]
}
