//! A sphere: rows are its parallels, from the south pole up.

use super::turned;
use super::walk::{Corner, Shape};

pub(super) struct Sphere {
    pub(super) radius: f64,
}

impl Shape for Sphere {
    const IS_CURVED_ACROSS: bool = true;
    const IS_CURVED_UP: bool = true;
    const LINES_RUN_DOWN: bool = true;

    fn ends_in_points(&self) -> [bool; 2] {
        [true, true]
    }

    fn has_fans(&self, textured: bool) -> bool {
        !textured
    }

    fn corner(&self, around: f64, upwards: f64) -> Corner {
        let [sine, cosine] = turned(0.0, 360.0, around);
        let [equatorial, axial] = turned(180.0, -180.0, upwards);
        let normal = [equatorial * sine, equatorial * cosine, axial];
        Corner {
            position: normal.map(|x| self.radius * x),
            normal,
            texture: [1.0 - around, upwards],
        }
    }
}
