//! Axis-aligned bounding boxes in `f32`.

/// An axis-aligned bounding box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Aabb {
    pub(crate) low: [f32; 3],
    pub(crate) high: [f32; 3],
}

impl Aabb {
    /// The identity of [`Self::union`]: every lower bound lies above every upper one.
    pub(crate) const EMPTY: Self = Self { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    pub(crate) fn of_triangle(corners: [[f32; 3]; 3]) -> Self {
        let mut bounds = Self::EMPTY;
        for corner in corners {
            bounds.include(corner);
        }
        bounds
    }

    pub(crate) fn include(&mut self, point: [f32; 3]) {
        for axis in 0..3 {
            self.low[axis] = lower(point[axis], self.low[axis]);
            self.high[axis] = higher(point[axis], self.high[axis]);
        }
    }

    pub(crate) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        for axis in 0..3 {
            union.low[axis] = lower(other.low[axis], self.low[axis]);
            union.high[axis] = higher(other.high[axis], self.high[axis]);
        }
        union
    }

    /// Half the surface area; 0 for an empty box.
    pub(crate) fn half_area(&self) -> f32 {
        let extent = |axis: usize| (self.high[axis] - self.low[axis]).max(0.0);
        let [x, y, z] = [extent(0), extent(1), extent(2)];
        x * y + y * z + z * x
    }

    /// The length of the longest side.
    pub(crate) fn longest_side(&self) -> f32 {
        (0..3).map(|axis| self.high[axis] - self.low[axis]).fold(0.0, f32::max)
    }

    /// The largest absolute coordinate along each axis.
    pub(crate) fn largest(&self) -> [f32; 3] {
        std::array::from_fn(|axis| self.low[axis].abs().max(self.high[axis].abs()))
    }
}

/// `min` with the semantics of one processor instruction: the second operand wins if either is NaN.
#[inline(always)]
pub(crate) fn lower(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// `max` with the semantics of one processor instruction: the second operand wins if either is NaN.
#[inline(always)]
pub(crate) fn higher(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
