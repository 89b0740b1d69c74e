//! The wall of a frustum: rows are its circles, from z = 0 up.

use super::turned;
use super::walk::{Corner, Shape};

pub(super) struct Cylinder {
    pub(super) base: f64,
    pub(super) top: f64,
    pub(super) height: f64,
}

impl Shape for Cylinder {
    const IS_CURVED_ACROSS: bool = true;
    const IS_CURVED_UP: bool = false;

    fn ends_in_points(&self) -> [bool; 2] {
        [self.base == 0.0, self.top == 0.0]
    }

    fn corner(&self, around: f64, upwards: f64) -> Corner {
        let [sine, cosine] = turned(0.0, 360.0, around);
        let radius = self.base - upwards * (self.base - self.top);
        // Along the wall: (top - base, height); across it: (height, base - top).
        let (outwards, axial) = (self.height, self.base - self.top);
        let length = (outwards * outwards + axial * axial).sqrt();
        let [outwards, axial] =
            if length > 0.0 { [outwards / length, axial / length] } else { [1.0, 0.0] };
        Corner {
            position: [radius * sine, radius * cosine, upwards * self.height],
            normal: [outwards * sine, outwards * cosine, axial],
            texture: [1.0 - around, upwards],
        }
    }
}
