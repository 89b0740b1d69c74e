//! From a mesh's coordinates to the window.
//!
//! Clip coordinates here are scaled and turned so that one division leads to the window:
//! x/w and y/w are steps of 1/256 pixel from the window's *centre*, y down; z/w is the reversed
//! depth, 1 at the near plane and 0 at the far one, which spends the precision of floats evenly
//! over distance (Reed 2015).

use glam::{DMat4, DVec4};
use luxel_math::{Lanes, SUBPIXELS};
use luxel_scene::{Projection, Size};

/// Half the side of the guard band in steps of 1/256 pixel: 2^14 pixels either way from the
/// window's middle. Triangles that reach farther out are clipped, so that edge functions fit their
/// integers (see `raster::setup`).
pub const GUARD_BAND: i32 = (1 << 14) * SUBPIXELS;

/// Most pixels of a window's side: as many as the guard band holds, less the pixel at either end
/// that clipping keeps off.
pub const MAX_SIDE: u32 = (1 << 15) - 2;

/// A vertex in clip coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClipVertex {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) z: f32,
    pub(crate) w: f32,
}

/// A vertex in the window: snapped position in steps of 1/256 pixel from the corner where columns and rows begin,
/// and its depth, which is reversed in luxel's frames.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WindowVertex {
    /// Steps across.
    pub x: i32,
    /// Steps along columns.
    pub y: i32,
    /// Depth, in the encoding of whoever draws.
    pub z: f32,
}

/// The transform of one instance: rows of the matrix to clip coordinates, and the window's centre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WindowTransform {
    /// x, y, z, w: each a row to multiply (x, y, z, 1) with.
    pub(crate) rows: [[f32; 4]; 4],
    /// The window's middle, in steps of 1/256 pixel.
    pub(crate) centre: [f32; 2],
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
    pub(crate) fn snapped<N: Lanes>(&self, [x, y, z]: [N; 3]) -> [N; 2] {
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
    fn snapped_and_held<N: Lanes>(&self, [x, y, z, w]: [N; 4]) -> ([N; 2], N::Mask) {
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

/// A clip coordinate on the window's grid, in steps of 1/256 pixel: value / w + centre, rounded to the nearest step,
/// ties to even. `value` is scaled to such steps, `centre` where the window's middle lies.
#[inline(always)]
pub fn snap<N: Lanes>(value: N, w: N, centre: f32) -> N {
    (value / w + w.constant(centre)).round_ties_even()
}

/// One row times positions: a clip coordinate.
#[inline(always)]
pub(crate) fn row_times<N: Lanes>(row: &[f32; 4], x: N, y: N, z: N) -> N {
    x * x.constant(row[0]) + y * x.constant(row[1]) + z * x.constant(row[2]) + x.constant(row[3])
}
