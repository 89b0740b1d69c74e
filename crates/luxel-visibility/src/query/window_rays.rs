//! How window positions become rays in view space, and back.

use glam::DVec3;
use luxel_math::{F64Lanes, Lanes};
use luxel_scene::{Projection, Size};

/// How window positions become rays: x = x0 + dx X in the plane z = -1 of view space for
/// perspectives, in the eye's plane for parallel rays; X in pixels.
#[derive(Clone, Copy, Debug)]
pub struct WindowRays {
    pub(super) x0: f64,
    pub(super) dx: f64,
    pub(super) y0: f64,
    pub(super) dy: f64,
    pub(super) parallel: bool,
    pub(super) size: [f64; 2],
}

impl WindowRays {
    /// The rays of a projection onto a window.
    #[must_use]
    pub fn new(projection: &Projection, size: Size) -> Self {
        let clip = projection.clip_from_view(size);
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        // x_ndc = 2 X / width - 1 = (P_00 x + P_02 z) / -z with z = -1, or P_00 x + P_03.
        let parallel = projection.is_orthographic();
        let (skew_x, skew_y) = if parallel {
            (-clip.w_axis.x, -clip.w_axis.y)
        } else {
            (clip.z_axis.x, clip.z_axis.y)
        };
        Self {
            x0: (skew_x - 1.0) / clip.x_axis.x,
            dx: 2.0 / (width * clip.x_axis.x),
            y0: (skew_y + 1.0) / clip.y_axis.y,
            dy: -2.0 / (height * clip.y_axis.y),
            parallel,
            size: [width, height],
        }
    }

    /// The ray through a window position in pixels: origin and direction in view space, the
    /// direction with z = -1.
    #[must_use]
    pub fn ray(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let (x, y) = (self.x0 + self.dx * x, self.y0 + self.dy * y);
        if self.parallel {
            (DVec3::new(x, y, 0.0), DVec3::NEG_Z)
        } else {
            (DVec3::ZERO, DVec3::new(x, y, -1.0))
        }
    }

    /// Whether rays are parallel.
    #[inline(always)]
    pub(crate) fn is_parallel(&self) -> bool {
        self.parallel
    }

    /// How a ray's direction, or its origin for parallel rays, changes a pixel to the right and a pixel down.
    #[inline(always)]
    pub(crate) fn steps(&self) -> [f32; 2] {
        [self.dx as f32, self.dy as f32]
    }

    /// Positive where a triangle's corners, in view space, run counterclockwise as seen from the eye,
    /// negative where they run clockwise: -p_0 . (p_1 x p_2), or twice the area for parallel rays.
    #[inline(always)]
    #[must_use]
    pub fn towards_eye<D: F64Lanes>(&self, [a, b, c]: &[[D; 3]; 3]) -> D {
        if self.parallel {
            return (b[0] * c[1] - b[1] * c[0])
                + (c[0] * a[1] - c[1] * a[0])
                + (a[0] * b[1] - a[1] * b[0]);
        }
        let n = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        -(a[0] * n[0] + a[1] * n[1] + a[2] * n[2])
    }

    /// Where a point in view space lies in the window, in pixels, and its distance along the viewing
    /// axis; the position means nothing where that isn't positive.
    #[inline(always)]
    pub(crate) fn window_lanes<D: F64Lanes>(&self, [x, y, z]: [D; 3]) -> [D; 3] {
        let one = x.constant(1.0);
        let depth = if self.parallel { one } else { -z };
        let scale = one / depth;
        [
            (x * scale - x.constant(self.x0)) * x.constant(1.0 / self.dx),
            (y * scale - y.constant(self.y0)) * y.constant(1.0 / self.dy),
            depth,
        ]
    }

    /// [`Self::window_lanes`] to the digits of f32, for bounds.
    #[inline(always)]
    pub(crate) fn window_narrow<D: F64Lanes>(&self, [x, y, z]: [D; 3]) -> [D::F32; 3] {
        let (x, y, z) = (x.to_f32(), y.to_f32(), z.to_f32());
        let depth = if self.parallel { x.one() } else { -z };
        let scale = x.one() / depth;
        [
            (x * scale - x.constant(self.x0 as f32)) * x.constant((1.0 / self.dx) as f32),
            (y * scale - y.constant(self.y0 as f32)) * y.constant((1.0 / self.dy) as f32),
            depth,
        ]
    }

    /// The part of an edge that lies before the eye, from 0 to 1 along it; `None` if none does.
    ///
    /// It ends a millionth of the front end's depth before the eye, far beyond any window's side.
    pub(super) fn visible_part(&self, from: DVec3, to: DVec3) -> Option<(f64, f64)> {
        let (front, back) = (-from.z, -to.z);
        let crossing = |near: f64, far: f64| (far - far * 1e-6) / (far - near);
        match (front > 0.0, back > 0.0) {
            _ if self.parallel => Some((0.0, 1.0)),
            (true, true) => Some((0.0, 1.0)),
            (true, false) => Some((0.0, crossing(back, front))),
            (false, true) => Some((1.0 - crossing(front, back), 1.0)),
            (false, false) => None,
        }
    }

    /// The window position of a point in view space, in pixels; `None` if it isn't before the eye.
    #[must_use]
    pub fn window(&self, point: DVec3) -> Option<[f64; 2]> {
        let depth = if self.parallel { 1.0 } else { -point.z };
        (depth > 0.0)
            .then(|| [(point.x / depth - self.x0) / self.dx, (point.y / depth - self.y0) / self.dy])
    }
}
