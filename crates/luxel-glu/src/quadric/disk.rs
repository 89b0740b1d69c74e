//! A disk, a ring, or a part of them: rows are its circles, from the outermost in.

use super::turned;
use super::walk::{Corner, Shape};

pub(super) struct Disk {
    pub(super) inner: f64,
    pub(super) outer: f64,
    pub(super) start: f64,
    pub(super) sweep: f64,
    pub(super) whole: bool,
    pub(super) across: u32,
    pub(super) up: u32,
}

impl Shape for Disk {
    fn across(&self) -> u32 {
        self.across
    }

    fn up(&self) -> u32 {
        self.up
    }

    fn is_closed(&self) -> bool {
        self.whole
    }

    fn is_point(&self, row: u32) -> bool {
        row == self.up && self.inner == 0.0
    }

    fn corner(&self, column: f64, row: f64) -> Corner {
        let [sine, cosine] = turned(self.start, self.sweep, column / f64::from(self.across));
        let inwards = row / f64::from(self.up);
        let radius = self.outer - inwards * (self.outer - self.inner);
        let part = 0.5 * radius / self.outer;
        Corner {
            position: [radius * sine, radius * cosine, 0.0],
            normal: [0.0, 0.0, 1.0],
            texture: [0.5 + part * sine, 0.5 + part * cosine],
        }
    }

    fn silhouette_rows(&self) -> Vec<u32> {
        vec![0, self.up]
    }

    fn silhouette_columns(&self) -> Vec<u32> {
        if self.whole { Vec::new() } else { vec![0, self.across] }
    }
}
