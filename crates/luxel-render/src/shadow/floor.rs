//! The ground that a model stands on, as it is in the way of rays.

use glam::DVec3;
use luxel_rays::WorldRay;

/// The plane up.p = level. Nothing of the model is below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Floor {
    /// Of unit length.
    pub(crate) up: DVec3,
    pub(crate) level: f64,
}

impl Floor {
    /// Whether a ray from above meets it. A ray that begins on it or, by rounding, below does if it goes
    /// down.
    pub(crate) fn meets(&self, ray: &WorldRay) -> bool {
        let fall = -self.up.dot(ray.direction);
        fall > 0.0 && self.up.dot(ray.origin) - self.level <= fall * ray.range[1]
    }
}
