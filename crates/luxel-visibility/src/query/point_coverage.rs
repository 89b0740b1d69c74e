//! The fill rule asked for one triangle and one sample: the same transform, snapping, clipping,
//! edge functions and depth as a frame's, so the same answer.

use crate::raster::{Triangle, clip};
use crate::types::{
    CullFaces, GUARD_BAND, Region, ViewFromLocal, WindowTransform, WindowVertex, snap,
};
use luxel_math::{Lanes, SUBPIXELS};
use luxel_scene::{Projection, Size};

/// A mesh in its place before a camera, to be asked which of its triangles cover a sample.
#[derive(Clone, Copy, Debug)]
pub struct Probe {
    transform: WindowTransform,
}

/// One rounding of an `f32`, relative.
const ROUNDING: f64 = 1.0 / 16_777_216.0;

impl Probe {
    /// For a mesh in a window, as an [`Instance`](crate::Instance) is in a [`Frame`](crate::Frame).
    #[must_use]
    pub fn new(projection: &Projection, size: Size, view_from_local: &ViewFromLocal) -> Self {
        Self { transform: WindowTransform::new(projection, size, &view_from_local.matrix()) }
    }

    /// For an instance of a frame.
    pub(crate) fn of(transform: WindowTransform) -> Self {
        Self { transform }
    }

    /// The reversed depth with which a triangle, given by its positions about the mesh's origin and its
    /// [rank](luxel_scene::CoplanarRanks), covers the sample at `position` (in steps of 1/256 pixel); `None` if it doesn't.
    ///
    /// In a frame the sample sees the triangle of the largest depth, the first submitted among
    /// equals.
    #[must_use]
    pub fn covers(
        &self,
        corners: [[f32; 3]; 3],
        cull: CullFaces,
        rank: u8,
        position: [i32; 2],
    ) -> Option<f32> {
        // Most triangles of a cluster are elsewhere, which their box shows before they are set up.
        let snapped = self.window_corners(corners);
        let is_near = snapped.is_none_or(|snapped| holds(&snapped, position));
        is_near.then(|| self.set_up(corners, snapped, cull, rank).covers(position))?
    }

    /// A triangle, given by its positions about the mesh's origin, set up for several samples, with a
    /// [rank](luxel_scene::CoplanarRanks) among those in its plane.
    #[inline]
    #[must_use]
    pub fn triangle(&self, corners: [[f32; 3]; 3], cull: CullFaces, rank: u8) -> ProbedTriangle {
        self.set_up(corners, self.window_corners(corners), cull, rank)
    }

    /// The corners of a triangle in the window; `None` if it has to be clipped.
    #[inline]
    fn window_corners(&self, corners: [[f32; 3]; 3]) -> Option<[WindowVertex; 3]> {
        let transform = &self.transform;
        let corners = corners.map(|corner| transform.clip(corner));
        let are_held = corners.iter().all(|&corner| transform.holds(corner));
        are_held.then(|| corners.map(|corner| transform.window(corner)))
    }

    /// [`Probe::triangle`], with the triangle's [`Probe::window_corners`].
    #[inline]
    fn set_up(
        &self,
        corners: [[f32; 3]; 3],
        snapped: Option<[WindowVertex; 3]>,
        cull: CullFaces,
        rank: u8,
    ) -> ProbedTriangle {
        let triangle = |corners| Some(Triangle::new(corners, cull)?.with_rank(rank));
        if let Some(snapped) = snapped {
            return ProbedTriangle(Pieces::One(triangle(snapped)));
        }
        let transform = &self.transform;
        let polygon = clip(corners.map(|corner| transform.clip(corner)), transform);
        let pieces = polygon.triangles().filter_map(triangle);
        ProbedTriangle(Pieces::Clipped(pieces.collect()))
    }

    /// Where vertices, given by positions about the mesh's origin, are snapped to in the window, in
    /// steps of 1/256 pixel; NaN for those whose triangles may have to be clipped.
    ///
    /// A triangle of others covers only samples that its snapped corners aren't all to one side of.
    #[inline(always)]
    #[must_use]
    pub fn snapped<N: Lanes>(&self, position: [N; 3]) -> [N; 2] {
        self.transform.snapped(position)
    }

    /// No sample of a triangle within a box about the mesh's origin, given by its low planes and its
    /// high ones, has a larger reversed depth: the bound by which [`Frame`](crate::Frame) hides
    /// clusters.
    #[inline(always)]
    #[must_use]
    pub fn nearest<N: Lanes>(&self, low: [N; 3], high: [N; 3]) -> N {
        // The operations of vertices, in their order; rounding is monotone, so this is a bound.
        let [.., depth, w] = &self.transform.rows;
        let (z_high, w_low) = (extreme(depth, high, low), extreme(w, low, high));
        let zero = z_high.zero();
        let divisor = extreme(w, high, low).select(z_high.less(zero), w_low);
        let is_before = zero.less(w_low) & zero.less_or_equal(w_low - z_high);
        (z_high / divisor).select(is_before, zero.constant(f32::INFINITY))
    }

    /// A rectangle of the window, from the least x and y to the greatest in steps of 1/256 pixel, that holds
    /// all samples of triangles within a box about the mesh's origin, given by its low planes and its high
    /// ones. NaN where triangles may have to be clipped: compare so that NaN counts as inside.
    #[inline(always)]
    #[must_use]
    pub fn window_bounds<N: Lanes>(&self, low: [N; 3], high: [N; 3]) -> [[N; 2]; 2] {
        // As in `nearest`, the operations of vertices in their order.
        let [across, down, depth, w] = &self.transform.rows;
        let (w_low, w_high) = (extreme(w, low, high), extreme(w, high, low));
        let zero = w_low.zero();
        let mut held = zero.less(w_low) & zero.less_or_equal(w_low - extreme(depth, high, low));
        let mut bounds = [[zero; 2]; 2];
        let guard = GUARD_BAND as f32;
        for (axis, (row, centre)) in
            [across, down].into_iter().zip(self.transform.centre).enumerate()
        {
            let (least, most) = (extreme(row, low, high), extreme(row, high, low));
            // A quotient is least where the divisor brings it farthest from, or nearest to, zero.
            let least = snap(least, w_low.select(least.less(zero), w_high), centre);
            let most = snap(most, w_high.select(most.less(zero), w_low), centre);
            held = held
                & zero.constant(centre - guard).less_or_equal(least)
                & most.less_or_equal(zero.constant(centre + guard));
            (bounds[0][axis], bounds[1][axis]) = (least, most);
        }
        let nan = zero.constant(f32::NAN);
        bounds.map(
            #[inline(always)]
            |[x, y]| [x.select(held, nan), y.select(held, nan)],
        )
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

/// A triangle set up by the fill rule, for one sample after the other.
#[derive(Clone, Debug)]
pub struct ProbedTriangle(Pieces);

#[derive(Clone, Debug)]
enum Pieces {
    /// `None` for a triangle that is culled or has no area.
    One(Option<Triangle>),
    /// What clipping leaves.
    Clipped(Vec<Triangle>),
}

impl ProbedTriangle {
    /// The reversed depth with which the triangle covers a sample, see [`Probe::covers`].
    #[inline]
    #[must_use]
    pub fn covers(&self, position: [i32; 2]) -> Option<f32> {
        match &self.0 {
            Pieces::One(triangle) => covered(triangle.as_ref()?, position),
            Pieces::Clipped(pieces) => {
                let depths = pieces.iter().filter_map(|piece| covered(piece, position));
                depths.reduce(f32::max)
            }
        }
    }
}

/// A row times the corner of a box that lies farthest along it towards `first`, as its planes stand:
/// what the row turns round is taken from `second`.
#[inline(always)]
fn extreme<N: Lanes>(row: &[f32; 4], first: [N; 3], second: [N; 3]) -> N {
    let mut terms = first;
    for axis in 0..3 {
        let plane = if row[axis] < 0.0 { second[axis] } else { first[axis] };
        terms[axis] = plane * plane.constant(row[axis]);
    }
    let [x, y, z] = terms;
    x + y + z + x.constant(row[3])
}

/// Whether a position of the window lies in the box around a triangle.
#[inline]
fn holds(corners: &[WindowVertex; 3], [x, y]: [i32; 2]) -> bool {
    let [a, b, c] = corners;
    (a.x.min(b.x).min(c.x)..=a.x.max(b.x).max(c.x)).contains(&x)
        && (a.y.min(b.y).min(c.y)..=a.y.max(b.y).max(c.y)).contains(&y)
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
