//! Vertices of clusters to the window, sixteen at a time.

use crate::cluster::{CLUSTER_VERTICES, GROUP_WORDS};
use crate::types::{WindowTransform, row_times, snap};
use luxel_math::{LANES, SUBPIXELS, Simd, f32x16, i32x16, prelude::*, u32x16};

/// The transformed vertices of one cluster.
pub(crate) struct ClusterVertices {
    pub(crate) xy: [[i32; 2]; CLUSTER_VERTICES],
    pub(crate) z: [f32; CLUSTER_VERTICES],
}

/// What transformed vertices lie within.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    /// Pixels: left, top, right, bottom.
    pub(crate) pixels: [i32; 4],
    /// The nearest depth.
    pub(crate) nearest: f32,
}

impl ClusterVertices {
    pub(crate) fn new() -> Self {
        Self { xy: [[0; 2]; CLUSTER_VERTICES], z: [0.0; CLUSTER_VERTICES] }
    }
}

/// Transforms all vertices of a cluster whose every vertex lies in front of the near plane and
/// within the guard band: the same bits as [`WindowTransform::window`].
#[inline(always)]
pub(crate) fn transform_cluster<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    groups: &[[u32; GROUP_WORDS]],
    out: &mut ClusterVertices,
) -> Bounds {
    simd.vectorize(
        #[inline(always)]
        || transform_groups(simd, transform, groups, out),
    )
}

#[inline(always)]
fn transform_groups<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    groups: &[[u32; GROUP_WORDS]],
    out: &mut ClusterVertices,
) -> Bounds {
    let [mut left, mut top] = [i32x16::splat(simd, i32::MAX); 2];
    let [mut right, mut bottom] = [i32x16::splat(simd, i32::MIN); 2];
    let mut nearest = f32x16::splat(simd, 0.0);
    let out_xy = out.xy.as_chunks_mut::<LANES>().0;
    let out_z = out.z.as_chunks_mut::<LANES>().0;
    for ((group, out_xy), out_z) in groups.iter().zip(out_xy).zip(out_z) {
        let x: f32x16<S> = u32x16::from_slice(simd, &group[..LANES]).bitcast();
        let y: f32x16<S> = u32x16::from_slice(simd, &group[LANES..2 * LANES]).bitcast();
        let z: f32x16<S> = u32x16::from_slice(simd, &group[2 * LANES..]).bitcast();
        let clip_x = row_times(&transform.rows[0], x, y, z);
        let clip_y = row_times(&transform.rows[1], x, y, z);
        let clip_z = row_times(&transform.rows[2], x, y, z);
        let clip_w = row_times(&transform.rows[3], x, y, z);
        let window_x = i32x16::truncate_from(snap(clip_x, clip_w, transform.centre[0]));
        let window_y = i32x16::truncate_from(snap(clip_y, clip_w, transform.centre[1]));
        let (first, second) = out_xy.as_flattened_mut().split_at_mut(LANES);
        let (low, high) = simd.interleave_i32x16(window_x, window_y);
        low.store_slice(first);
        high.store_slice(second);
        let z = clip_z / clip_w;
        z.store_slice(out_z);
        (left, right) = (left.min(window_x), right.max(window_x));
        (top, bottom) = (top.min(window_y), bottom.max(window_y));
        nearest = nearest.maximum(z);
    }
    Bounds {
        pixels: [least(left), least(top), greatest(right), greatest(bottom)],
        nearest: nearest.as_slice().iter().copied().fold(0.0, f32::max),
    }
}

/// The pixel of the least of lanes in steps of 1/256 pixel.
#[inline(always)]
fn least<S: Simd>(lanes: i32x16<S>) -> i32 {
    lanes.as_slice().iter().copied().fold(i32::MAX, i32::min) >> SUBPIXELS.ilog2()
}

/// The pixel of the greatest.
#[inline(always)]
fn greatest<S: Simd>(lanes: i32x16<S>) -> i32 {
    lanes.as_slice().iter().copied().fold(i32::MIN, i32::max) >> SUBPIXELS.ilog2()
}
