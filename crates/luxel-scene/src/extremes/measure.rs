//! The measures to maximize.

use glam::DVec3;

/// Distances below its inverse overflow when they divide.
const LARGE: f64 = 1e150;

/// A number of each point, in whichever space it is searched.
pub(crate) trait Measure: Copy {
    /// Its value at a point; of equal first numbers the second decides.
    fn at(&self, point: DVec3) -> (f64, f64);

    /// Where the first number may be at least `least`.
    fn half_space(&self, least: f64) -> HalfSpace;
}

/// Where normal . point + constant is at least 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfSpace {
    pub(super) normal: DVec3,
    pub(super) constant: f64,
    /// Of the constant's terms.
    pub(super) magnitude: f64,
}

/// A coordinate, or its opposite.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coordinate {
    pub(crate) axis: usize,
    /// 1 or -1.
    pub(crate) sign: f64,
}

impl Measure for Coordinate {
    #[inline(always)]
    fn at(&self, point: DVec3) -> (f64, f64) {
        (self.sign * point[self.axis], 0.0)
    }

    fn half_space(&self, least: f64) -> HalfSpace {
        let normal = self.sign * DVec3::AXES[self.axis];
        HalfSpace { normal, constant: -least, magnitude: least.abs() }
    }
}

/// x + slope z, or its opposite; or y instead of x.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Along {
    pub(crate) axis: usize,
    pub(crate) slope: f64,
    /// 1 or -1.
    pub(crate) sign: f64,
}

impl Measure for Along {
    #[inline(always)]
    fn at(&self, point: DVec3) -> (f64, f64) {
        (self.sign * (point[self.axis] + self.slope * point.z), 0.0)
    }

    fn half_space(&self, least: f64) -> HalfSpace {
        let normal = self.sign * (DVec3::AXES[self.axis] + DVec3::new(0.0, 0.0, self.slope));
        HalfSpace { normal, constant: -least, magnitude: least.abs() }
    }
}

/// x over the distance along z, as the eye sees it, or its opposite; or y instead of x. Of equal
/// ones the farthest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    pub(crate) axis: usize,
    /// 1 or -1.
    pub(crate) sign: f64,
    pub(crate) eye: DVec3,
    /// The distance of the nearest point.
    pub(crate) nearest: f64,
}

impl Measure for Slope {
    #[inline(always)]
    fn at(&self, point: DVec3) -> (f64, f64) {
        let distance = self.eye.z - point.z;
        let by_distance = 1.0 / distance;
        (self.sign * ((point[self.axis] - self.eye[self.axis]) * by_distance), distance)
    }

    fn half_space(&self, least: f64) -> HalfSpace {
        let axis = self.sign * DVec3::AXES[self.axis];
        if !(least.is_finite() && self.nearest > 1.0 / LARGE && self.eye.z.abs() < LARGE) {
            return HalfSpace { normal: axis, constant: f64::INFINITY, magnitude: f64::INFINITY };
        }
        let (across, forwards) = (self.sign * self.eye[self.axis], least * self.eye.z);
        HalfSpace {
            normal: axis + DVec3::new(0.0, 0.0, least),
            constant: -(across + forwards),
            magnitude: across.abs() + forwards.abs(),
        }
    }
}
