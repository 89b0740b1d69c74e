//! A sphere: rows are its parallels, from the south pole up.

use super::turned;
use super::walk::{Corner, Shape, columns};

pub(super) struct Sphere {
    pub(super) radius: f64,
    pub(super) across: u32,
    pub(super) up: u32,
}

impl Shape for Sphere {
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
        row == 0 || row == self.up
    }

    fn corner(&self, column: f64, row: f64) -> Corner {
        let (around, upwards) = (column / f64::from(self.across), row / f64::from(self.up));
        let [sine, cosine] = turned(0.0, 360.0, around);
        let [equatorial, axial] = turned(180.0, -180.0, upwards);
        let normal = [equatorial * sine, equatorial * cosine, axial];
        Corner {
            position: normal.map(|x| self.radius * x),
            normal,
            texture: [1.0 - around, upwards],
        }
    }

    fn silhouette_rows(&self) -> Vec<u32> {
        (0..=self.up).collect()
    }

    fn silhouette_columns(&self) -> Vec<u32> {
        columns(self)
    }
}
