//! The wall of a frustum: rows are its circles, from z = 0 up.

use super::turned;
use super::walk::{Corner, Shape, columns};

pub(super) struct Cylinder {
    pub(super) base: f64,
    pub(super) top: f64,
    pub(super) height: f64,
    pub(super) across: u32,
    pub(super) up: u32,
}

impl Shape for Cylinder {
    fn across(&self) -> u32 {
        self.across
    }

    fn up(&self) -> u32 {
        self.up
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn is_point(&self, row: u32) -> bool {
        (row == 0 && self.base == 0.0) || (row == self.up && self.top == 0.0)
    }

    fn corner(&self, column: f64, row: f64) -> Corner {
        let (around, upwards) = (column / f64::from(self.across), row / f64::from(self.up));
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

    fn silhouette_rows(&self) -> Vec<u32> {
        vec![0, self.up]
    }

    fn silhouette_columns(&self) -> Vec<u32> {
        columns(self)
    }
}
