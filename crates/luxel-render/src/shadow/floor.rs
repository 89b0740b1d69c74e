//! The ground that a model stands on, as it is in the way of rays.

use glam::DVec3;
use luxel_math::{LANES, lanes_of};
use luxel_rays::RayLanes;

/// The plane up.p = level. Nothing of the model is below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Floor {
    /// Of unit length.
    pub(crate) up: DVec3,
    pub(crate) level: f64,
}

impl Floor {
    /// The lanes of rays from above that meet it, as bits. A ray that begins on it or, by rounding, below
    /// does if it goes down.
    pub(crate) fn met_by(&self, rays: &RayLanes) -> u32 {
        let meets = |lane: &usize| {
            let along = |[x, y, z]: &[[f64; LANES]; 3]| {
                self.up.dot(DVec3::new(x[*lane], y[*lane], z[*lane]))
            };
            let fall = -along(&rays.direction);
            fall > 0.0 && along(&rays.origin) - self.level <= fall * rays.end[*lane]
        };
        lanes_of(rays.lanes).filter(meets).fold(0, |met, lane| met | 1 << lane)
    }
}
