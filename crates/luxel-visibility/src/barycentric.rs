//! Where on its triangle a sample lies, as a ray through the sample finds it.
//!
//! Coverage and the depth test go by snapped corners; everything told or lit goes by the triangle
//! itself. For corners p_0, p_1, p_2 in view space and the ray t d from the eye, Cramer's rule
//! gives weights w_i = d . (p_j x p_k), with barycentrics b_i = w_i / (w_0 + w_1 + w_2). The ray's
//! direction is linear in window x and y, and so are the weights: three linear forms a triangle
//! ("perspective-correct interpolation", Olano and Greer 1997), also for parallel rays.
//!
//! Forms are made in f64, then moved to the 4x4 block that is evaluated, where f32 suffices: to
//! about 1e-6 of the triangle's size where it is larger than the block.

use glam::DVec3;
use luxel_math::{Number, SUBPIXELS};
use luxel_scene::{Projection, Size};

/// How window positions become rays: x = x0 + dx X in the plane z = -1 of view space for
/// perspectives, in the eye's plane for parallel rays; X in pixels.
#[derive(Clone, Copy, Debug)]
pub struct WindowRays {
    x0: f64,
    dx: f64,
    y0: f64,
    dy: f64,
    parallel: bool,
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

    /// The part of an edge that lies before the eye, from 0 to 1 along it; `None` if none does.
    ///
    /// It ends a millionth of the front end's depth before the eye, far beyond any window's side.
    fn visible_part(&self, from: DVec3, to: DVec3) -> Option<(f64, f64)> {
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

/// The weights of a triangle's corners as linear forms over the window: w_i = a_i X + b_i Y + c_i.
#[derive(Clone, Copy, Debug)]
pub struct Forms {
    corners: [DVec3; 3],
    a: [f64; 3],
    b: [f64; 3],
    c: [f64; 3],
}

/// [`Forms`] about a block's upper left corner, in f32, scaled to about 1.
#[derive(Clone, Copy, Debug)]
pub struct BlockForms {
    a: [f32; 3],
    b: [f32; 3],
    c: [f32; 3],
}

impl Forms {
    /// The forms of a triangle given in view space.
    #[must_use]
    pub fn new(rays: &WindowRays, corners: [DVec3; 3]) -> Self {
        let [mut a, mut b, mut c] = [[0.0; 3]; 3];
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let n = if rays.parallel {
                // Twice the area of (o, p_j, p_k) for the ray's origin o.
                let (p, q) = (corners[j], corners[k]);
                DVec3::new(p.y - q.y, q.x - p.x, p.y * q.x - p.x * q.y)
            } else {
                corners[j].cross(corners[k])
            };
            a[i] = n.x * rays.dx;
            b[i] = n.y * rays.dy;
            c[i] = n.x * rays.x0 + n.y * rays.y0 - n.z;
        }
        Self { corners, a, b, c }
    }

    /// The forms about pixel (x, y), the first of a block.
    #[must_use]
    pub fn about(&self, x: i32, y: i32) -> BlockForms {
        let (x, y) = (f64::from(x), f64::from(y));
        let mut c = [0.0; 3];
        let mut largest = f64::MIN_POSITIVE;
        for (i, value) in c.iter_mut().enumerate() {
            *value = self.a[i] * x + self.b[i] * y + self.c[i];
            largest = largest.max(value.abs()).max(self.a[i].abs()).max(self.b[i].abs());
        }
        // A common factor leaves the barycentrics as they are.
        let scaled = |values: [f64; 3]| values.map(|value| (value / largest) as f32);
        BlockForms { a: scaled(self.a), b: scaled(self.b), c: scaled(c) }
    }

    /// The barycentrics of the place on the triangle's edges that lies nearest, in the window, to
    /// position (x, y) in pixels.
    ///
    /// For samples that the snapped triangle covers and the triangle itself doesn't: they lie
    /// within 1/512 pixel of an edge.
    #[must_use]
    pub fn nearest_on_edges(&self, rays: &WindowRays, x: f64, y: f64) -> [f32; 3] {
        let mut best = (f64::INFINITY, [1.0, 0.0, 0.0]);
        for i in 0..3 {
            let j = (i + 1) % 3;
            let Some((start, end)) = rays.visible_part(self.corners[i], self.corners[j]) else {
                continue;
            };
            let [p, q] =
                [start, end].map(|at| rays.window(self.corners[i].lerp(self.corners[j], at)));
            let (Some(p), Some(q)) = (p, q) else { continue };
            let (along_x, along_y) = (q[0] - p[0], q[1] - p[1]);
            let squared = along_x * along_x + along_y * along_y;
            let dot = (x - p[0]) * along_x + (y - p[1]) * along_y;
            let t = if squared > 0.0 { (dot / squared).clamp(0.0, 1.0) } else { 0.0 };
            let (off_x, off_y) = (p[0] + t * along_x - x, p[1] + t * along_y - y);
            let distance = off_x * off_x + off_y * off_y;
            if distance < best.0 {
                // A step along the window's edge is perspective on the triangle's.
                let depth = |at: f64| {
                    let z = self.corners[i].z + (self.corners[j].z - self.corners[i].z) * at;
                    if rays.parallel { 1.0 } else { -z }
                };
                let (from, to) = ((1.0 - t) / depth(start), t / depth(end));
                let along = start + (end - start) * (to / (from + to));
                let mut barycentric = [0.0; 3];
                barycentric[i] = 1.0 - along;
                barycentric[j] = along;
                best = (distance, barycentric);
            }
        }
        best.1.map(|value| value as f32)
    }

    /// The barycentrics of one window position, in steps of 1/256 pixel: what a block's lanes hold,
    /// bit for bit.
    #[must_use]
    pub fn barycentric(&self, rays: &WindowRays, [x, y]: [i32; 2]) -> [f32; 3] {
        let block = |steps: i32| steps.div_euclid(BLOCK_STEPS) * (BLOCK_STEPS / SUBPIXELS);
        let inside = |steps: i32| steps.rem_euclid(BLOCK_STEPS) as f32 / SUBPIXELS as f32;
        let forms = self.about(block(x), block(y));
        let (barycentric, outside) = forms.barycentric(inside(x), inside(y));
        if outside { self.nearest_at(rays, [x, y]) } else { barycentric }
    }

    /// The barycentrics at a position in steps of 1/256 pixel, in f64: where the ray meets the
    /// triangle, or else [`Forms::nearest_on_edges`].
    #[must_use]
    pub fn nearest_at(&self, rays: &WindowRays, [x, y]: [i32; 2]) -> [f32; 3] {
        let pixels = |steps: i32| f64::from(steps) / f64::from(SUBPIXELS);
        let (x, y) = (pixels(x), pixels(y));
        self.on_ray(x, y).unwrap_or_else(|| self.nearest_on_edges(rays, x, y))
    }

    /// Where the ray meets the triangle; `None` if it misses or runs along it.
    fn on_ray(&self, x: f64, y: f64) -> Option<[f32; 3]> {
        let mut weights = [0.0; 3];
        let mut largest = 0.0_f64;
        for (i, weight) in weights.iter_mut().enumerate() {
            let (across, down) = (self.a[i] * x, self.b[i] * y);
            *weight = across + down + self.c[i];
            largest = largest.max(across.abs()).max(down.abs()).max(self.c[i].abs());
        }
        let sum = weights[0] + weights[1] + weights[2];
        // Below this, rounding would tell more than the triangle.
        let is_told = sum.abs() > largest * 1e-9;
        (is_told && weights.iter().all(|weight| weight / sum >= 0.0))
            .then(|| weights.map(|weight| (weight / sum) as f32))
    }
}

/// Steps of 1/256 pixel along a block's side.
const BLOCK_STEPS: i32 = crate::buffer::BLOCK * SUBPIXELS;

impl BlockForms {
    /// The weights at (x, y) pixels from the block's corner; divided by their sum they are
    /// barycentrics, also outside of the triangle.
    #[inline(always)]
    pub fn weights<N: Number>(&self, x: N, y: N) -> [N; 3] {
        [self.weight(0, x, y), self.weight(1, x, y), self.weight(2, x, y)]
    }

    /// How a corner's weight changes from pixel to pixel, across and down.
    #[inline(always)]
    #[must_use]
    pub fn gradient(&self, corner: usize) -> [f32; 2] {
        [self.a[corner], self.b[corner]]
    }

    #[inline(always)]
    fn weight<N: Number>(&self, i: usize, x: N, y: N) -> N {
        x.constant(self.c[i]) + x * x.constant(self.a[i]) + y * y.constant(self.b[i])
    }

    /// The barycentrics at (x, y) pixels from the block's corner, and where they lie outside the
    /// triangle or f32 can't tell (near edge-on) and [`Forms::nearest_at`] has to answer.
    #[inline(always)]
    pub fn barycentric<N: Number>(&self, x: N, y: N) -> ([N; 3], N::Mask) {
        let [w0, w1, w2] = self.weights(x, y);
        let sum = w0 + w1 + w2;
        let scale = x.one() / sum;
        let [b0, b1, b2] = [w0 * scale, w1 * scale, w2 * scale];
        // Comparisons with NaN are false: what can't be told counts as outside.
        let zero = x.zero();
        let inside = zero.less_or_equal(b0)
            & zero.less_or_equal(b1)
            & zero.less_or_equal(b2)
            & x.constant(Self::LEAST_SUM).less_or_equal(sum.abs());
        ([b0, b1, b2], !inside)
    }

    /// Weights are rounded to about 2^-21, as they and their slopes are at most 1: with a smaller
    /// sum, barycentrics would be off by more than 1e-4. It is the height in pixels, or so, of the
    /// triangles that this leaves to f64.
    const LEAST_SUM: f32 = 1.0 / 64.0;
}
