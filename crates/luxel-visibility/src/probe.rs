//! The fill rule asked for one triangle and one sample: the same transform, snapping, clipping,
//! edge functions and depth as a frame's, so the same answer.

use crate::clip::clip;
use crate::cull::GUARD_BAND;
use crate::setup::{CullFaces, Region, Triangle};
use crate::transform::WindowTransform;
use glam::DMat4;
use luxel_math::SUBPIXELS;
use luxel_scene::{Mesh, Projection, Size};

/// A mesh in its place before a camera, to be asked which of its triangles cover a sample.
#[derive(Clone, Copy, Debug)]
pub struct Probe {
    transform: WindowTransform,
}

/// One rounding of an `f32`, relative.
const ROUNDING: f64 = 1.0 / 16_777_216.0;

impl Probe {
    /// For a mesh about `origin` (its [`Mesh::origin`]) in a window, as an
    /// [`Instance`](crate::Instance) is in a [`Frame`](crate::Frame).
    #[must_use]
    pub fn new(projection: &Projection, size: Size, view_from_mesh: &DMat4, mesh: &Mesh) -> Self {
        let view_from_local = *view_from_mesh * DMat4::from_translation(mesh.origin);
        Self { transform: WindowTransform::new(projection, size, &view_from_local) }
    }

    /// The reversed depth with which a triangle, given by its positions about the mesh's origin,
    /// covers the sample at `position` (in steps of 1/256 pixel); `None` if it doesn't.
    ///
    /// In a frame the sample sees the triangle of the largest depth, the first submitted among
    /// equals.
    #[must_use]
    pub fn covers(
        &self,
        corners: [[f32; 3]; 3],
        cull: CullFaces,
        position: [i32; 2],
    ) -> Option<f32> {
        let transform = &self.transform;
        let corners = corners.map(|corner| transform.clip(corner));
        if corners.iter().all(|&corner| transform.holds(corner)) {
            let triangle = Triangle::new(corners.map(|corner| transform.window(corner)), cull)?;
            return covered(&triangle, position);
        }
        let mut nearest: Option<f32> = None;
        for piece in clip(corners, transform).triangles() {
            let depth = Triangle::new(piece, cull).and_then(|piece| covered(&piece, position));
            if let Some(depth) = depth {
                nearest = Some(nearest.map_or(depth, |nearest| nearest.max(depth)));
            }
        }
        nearest
    }

    /// No sample of a triangle within a box about the mesh's origin has a larger reversed depth:
    /// the bound by which [`Frame`](crate::Frame) hides clusters.
    #[must_use]
    pub fn nearest(&self, low: [f32; 3], high: [f32; 3]) -> f32 {
        // The operations of vertices, in their order; rounding is monotone, so this is a bound.
        let [.., depth, w] = &self.transform.rows;
        let extreme = |row: &[f32; 4], toward_high: bool| {
            let term = |axis: usize| {
                let at = if (row[axis] < 0.0) != toward_high { high[axis] } else { low[axis] };
                row[axis] * at
            };
            term(0) + term(1) + term(2) + row[3]
        };
        let (z_high, w_low) = (extreme(depth, true), extreme(w, false));
        if !(w_low > 0.0 && w_low - z_high >= 0.0) {
            return f32::INFINITY;
        }
        let divisor = if z_high < 0.0 { extreme(w, true) } else { w_low };
        z_high / divisor
    }

    /// How far from a triangle the ray of a sample may pass that it covers, across and down the
    /// window in steps of 1/256 pixel: `constant + by_distance / w` at the distance w along the
    /// viewing axis (1 for parallel rays), for positions up to `largest` about the mesh's origin.
    ///
    /// Snapping moves a corner by half a step, and a division and a sum round at up to the guard
    /// band's 2^22 steps; clipping may round otherwise by two. Before that, rows of the matrix and
    /// their products and sums round in proportion to the mesh, which matters by distance; what
    /// that does to w counts by how far from the middle a corner may lie.
    #[must_use]
    pub fn reach(&self, largest: [f32; 3]) -> Reach {
        let magnitude = |row: &[f32; 4]| {
            let terms = (0..3).map(|axis| f64::from(row[axis].abs()) * f64::from(largest[axis]));
            terms.sum::<f64>() + f64::from(row[3].abs())
        };
        let [x, y, _, w] = &self.transform.rows;
        let guard = f64::from(GUARD_BAND);
        // A coefficient, a product, three sums, and one to spare.
        let rounding = 6.0 * ROUNDING;
        let of_w = rounding * magnitude(w) * guard;
        Reach {
            constant: 0.5 + 4.0 * ROUNDING * guard + 2.0,
            by_distance: [x, y].map(|row| rounding * magnitude(row) + of_w),
        }
    }
}

/// See [`Probe::reach`].
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// Steps at any distance, across and down alike.
    pub constant: f64,
    /// Steps times distance, across and down.
    pub by_distance: [f64; 2],
}

/// The depth of a snapped triangle at a sample that it covers.
fn covered(triangle: &Triangle, position: [i32; 2]) -> Option<f32> {
    let [pixel_x, pixel_y] = position.map(|steps| steps.div_euclid(SUBPIXELS));
    let offset = position.map(|steps| steps.rem_euclid(SUBPIXELS));
    let region = Region { x: pixel_x, y: pixel_y, width: 1, height: 1 };
    triangle.pixels(region, offset)?;
    let [e0, e1, e2] = triangle.edges(region, offset)?;
    if (e0.start | e1.start | e2.start) < 0 {
        return None;
    }
    // What lies beyond the far plane is not drawn.
    let depth = triangle.depth.at(position);
    (depth >= 0.0).then_some(depth)
}
