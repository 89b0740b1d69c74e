//! From a mesh's coordinates to the window.
//!
//! Clip coordinates here are scaled and turned so that one division leads to the window:
//! x/w and y/w are steps of 1/256 pixel from the window's *centre*, y down; z/w is the reversed
//! depth, 1 at the near plane and 0 at the far one, which spends the precision of floats evenly
//! over distance (Reed 2015).

use glam::{DMat4, DVec4};
use luxel_math::{LANES, Number, SUBPIXELS, Simd, f32x16, i32x16, prelude::*, u32x16};
use luxel_scene::{Projection, Size};

use crate::cluster::{CLUSTER_VERTICES, GROUP_WORDS};
use crate::cull::GUARD_BAND;

/// A vertex in clip coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClipVertex {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) z: f32,
    pub(crate) w: f32,
}

/// A vertex in the window: snapped position in steps of 1/256 pixel from the upper left corner,
/// and reversed depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct WindowVertex {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) z: f32,
}

/// The transform of one instance: rows of the matrix to clip coordinates, and the window's centre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WindowTransform {
    /// x, y, z, w: each a row to multiply (x, y, z, 1) with.
    pub(crate) rows: [[f32; 4]; 4],
    /// The window's middle, in steps of 1/256 pixel.
    pub(crate) centre: [f32; 2],
}

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

impl WindowTransform {
    /// The transform for a projection and a size of the window. Composed in f64; the instance's
    /// place relative to the eye is in `view_from_local`, so nothing large is left in f32.
    pub(crate) fn new(projection: &Projection, size: Size, view_from_local: &DMat4) -> Self {
        let clip_from_local = projection.clip_from_view(size) * *view_from_local;
        let half = f64::from(SUBPIXELS) * 0.5;
        let (half_x, half_y) = (half * f64::from(size.width), half * f64::from(size.height));
        let [x, y, z, w] = [0, 1, 2, 3].map(|row| clip_from_local.row(row));
        // OpenGL's depth runs from -w at the near plane to w at the far one.
        let reversed = (w - z) * 0.5;
        let f32s = |row: DVec4| row.as_vec4().to_array();
        Self {
            rows: [f32s(x * half_x), f32s(y * -half_y), f32s(reversed), f32s(w)],
            centre: [half_x as f32, half_y as f32],
        }
    }

    /// The clip coordinates of one position.
    pub(crate) fn clip(&self, [px, py, pz]: [f32; 3]) -> ClipVertex {
        let [x, y, z, w] = self.rows.map(|row| row_times(&row, px, py, pz));
        ClipVertex { x, y, z, w }
    }

    /// Whether a vertex lies in front of the near plane and, snapped, within the guard band. A
    /// triangle of such vertices is never clipped, whatever cluster it is in.
    pub(crate) fn holds(&self, vertex: ClipVertex) -> bool {
        let ClipVertex { x, y, z, w } = vertex;
        self.snapped_and_held([x, y, z, w]).1
    }

    /// The window coordinates of a vertex that the transform `holds`.
    pub(crate) fn window(&self, vertex: ClipVertex) -> WindowVertex {
        let ClipVertex { x, y, z, w } = vertex;
        let [centre_x, centre_y] = self.centre;
        WindowVertex { x: snap(x, w, centre_x) as i32, y: snap(y, w, centre_y) as i32, z: z / w }
    }

    /// Where vertices are snapped to, as [`Self::window`] has it; NaN for those that the transform
    /// doesn't hold.
    #[inline(always)]
    pub(crate) fn snapped<N: Number>(&self, [x, y, z]: [N; 3]) -> [N; 2] {
        let [across, down, depth, w] = &self.rows;
        let ([across, down], held) = self.snapped_and_held([
            row_times(across, x, y, z),
            row_times(down, x, y, z),
            row_times(depth, x, y, z),
            row_times(w, x, y, z),
        ]);
        let nan = x.constant(f32::NAN);
        [across.select(held, nan), down.select(held, nan)]
    }

    /// Where clip coordinates are snapped to, and whether that [holds](Self::holds).
    #[inline(always)]
    fn snapped_and_held<N: Number>(&self, [x, y, z, w]: [N; 4]) -> ([N; 2], N::Mask) {
        let zero = w.zero();
        let mut held = zero.less(w) & zero.less_or_equal(w - z);
        let mut snapped = [x, y];
        for (at, centre) in snapped.iter_mut().zip(self.centre) {
            let guard = GUARD_BAND as f32;
            *at = snap(*at, w, centre);
            held = held
                & w.constant(centre - guard).less_or_equal(*at)
                & at.less_or_equal(w.constant(centre + guard));
        }
        (snapped, held)
    }
}

/// A clip coordinate on the window's grid, in steps of 1/256 pixel.
#[inline(always)]
fn snap<N: Number>(value: N, w: N, centre: f32) -> N {
    (value / w + w.constant(centre)).round_ties_even()
}

/// One row times positions: a clip coordinate.
#[inline(always)]
pub(crate) fn row_times<N: Number>(row: &[f32; 4], x: N, y: N, z: N) -> N {
    x * x.constant(row[0]) + y * x.constant(row[1]) + z * x.constant(row[2]) + x.constant(row[3])
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
