//! Rays and hits.

use luxel_math::LANES;

/// A ray: all points `origin + t * direction` with t within `range`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Ray {
    /// The point at t = 0.
    pub origin: [f32; 3],
    /// The direction, of any length but 0; t counts in units of this length.
    pub direction: [f32; 3],
    /// The smallest t, not below 0, and the largest, which may be infinite. Both are included.
    pub range: [f32; 2],
}

/// Up to sixteen rays side by side, component by component.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct RayColumns {
    /// The points at t = 0, axis by axis.
    pub origin: [[f32; LANES]; 3],
    /// The directions, axis by axis, of any length but 0.
    pub direction: [[f32; LANES]; 3],
    /// The smallest t and the largest, as in [`Ray::range`].
    pub range: [[f32; LANES]; 2],
    /// A bit for each lane that has a ray.
    pub lanes: u32,
}

impl RayColumns {
    /// No rays.
    pub const NONE: Self = Self {
        origin: [[0.0; LANES]; 3],
        direction: [[0.0; LANES]; 3],
        range: [[0.0; LANES]; 2],
        lanes: 0,
    };

    /// The ray of a lane.
    ///
    /// # Panics
    /// If there are fewer lanes.
    #[must_use]
    pub fn ray(&self, lane: usize) -> Ray {
        Ray {
            origin: self.origin.map(|row| row[lane]),
            direction: self.direction.map(|row| row[lane]),
            range: self.range.map(|row| row[lane]),
        }
    }

    /// Puts a ray into a lane.
    ///
    /// # Panics
    /// If there are fewer lanes.
    pub fn put(&mut self, lane: usize, ray: &Ray) {
        for axis in 0..3 {
            self.origin[axis][lane] = ray.origin[axis];
            self.direction[axis][lane] = ray.direction[axis];
        }
        for (row, end) in self.range.iter_mut().zip(ray.range) {
            row[lane] = end;
        }
        self.lanes |= 1 << lane;
    }
}

/// Where a ray hits a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// The distance along the ray, in units of the direction's length.
    pub t: f32,
    /// The triangle's index in the mesh.
    pub triangle: u32,
    /// Barycentric coordinates: the weights of the triangle's corners.
    pub barycentric: [f32; 3],
}

/// Directions whose largest component lies within this range are traced without rescaling.
pub(crate) const USUAL_LENGTHS: std::ops::Range<f32> = 1e-9..1e9;

impl Ray {
    /// A ray without end.
    #[must_use]
    pub const fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        Self { origin, direction, range: [0.0, f32::INFINITY] }
    }

    /// The segment between two points, as shadow rays need it: t runs from 0 at `from` to 1 at `to`.
    ///
    /// Raise `range[0]` a little above 0 and lower `range[1]` a little below 1 to ignore surfaces on
    /// which the end points lie.
    #[must_use]
    pub fn between(from: [f32; 3], to: [f32; 3]) -> Self {
        let direction = std::array::from_fn(|axis| to[axis] - from[axis]);
        Self { origin: from, direction, range: [0.0, 1.0] }
    }

    /// Whether the ray is valid: origin and direction are finite, the direction isn't 0, and the
    /// range isn't empty and doesn't begin below 0. Invalid rays hit nothing.
    #[must_use]
    #[inline]
    pub fn is_sound(&self) -> bool {
        let finite = |values: &[f32; 3]| values.iter().all(|value| value.is_finite());
        finite(&self.origin)
            && finite(&self.direction)
            && self.direction != [0.0; 3]
            && self.has_range()
    }

    /// Whether the range isn't empty and doesn't begin below 0.
    #[inline(always)]
    pub(crate) fn has_range(&self) -> bool {
        let [nearest, farthest] = self.range;
        nearest >= 0.0 && farthest >= nearest
    }

    /// Whether the direction can be traced without rescaling.
    #[inline(always)]
    pub(crate) fn is_usual(&self) -> bool {
        let [x, y, z] = self.direction.map(f32::abs);
        USUAL_LENGTHS.contains(&x.max(y).max(z))
    }

    /// The same ray with a direction of usual length, and the factor from its t to this ray's t. The
    /// factor is a power of two, so nothing is rounded. Very short and very long directions would
    /// overflow or underflow in the slab and triangle tests. Expects a sound ray.
    #[inline(always)]
    pub(crate) fn scaled(&self) -> (Self, f32) {
        let [x, y, z] = self.direction.map(f32::abs);
        let longest = x.max(y).max(z);
        if USUAL_LENGTHS.contains(&longest) { (*self, 1.0) } else { self.rescaled(longest) }
    }

    #[cold]
    #[inline(never)]
    fn rescaled(&self, longest: f32) -> (Self, f32) {
        let mut ray = *self;
        let (mut scale, mut longest) = (1.0_f32, longest);
        // In steps of 2^24: one factor for the whole way could itself overflow.
        const STEP: f32 = 16_777_216.0;
        // A few steps bring any finite length but 0 into range.
        for _ in 0..8 {
            if USUAL_LENGTHS.contains(&longest) {
                break;
            }
            let factor = if longest < 1.0 { STEP } else { 1.0 / STEP };
            ray.direction = ray.direction.map(|component| component * factor);
            ray.range = ray.range.map(|t| t / factor);
            (scale, longest) = (scale * factor, longest * factor);
        }
        (ray, scale)
    }
}

/// The axis of the largest absolute component.
#[inline(always)]
pub(crate) fn longest_axis(direction: &[f32; 3]) -> usize {
    let [x, y, z] = [direction[0].abs(), direction[1].abs(), direction[2].abs()];
    if x > y && x > z { 0 } else { 1 + usize::from(z >= y) }
}

/// The cyclic order of axes that ends with the longest, so that handedness is preserved. A table: the
/// longest axes of random rays can't be predicted.
#[inline(always)]
pub(crate) fn axis_order(longest: usize) -> [usize; 3] {
    const ORDERS: [[u8; 3]; 4] = [[1, 2, 0], [2, 0, 1], [0, 1, 2], [0, 1, 2]];
    ORDERS[longest & 3].map(usize::from)
}
