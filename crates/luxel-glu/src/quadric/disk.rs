//! A disk, a ring, or a part of them: rows are its circles, from the outermost in.

use super::turned;
use super::walk::{Corner, Shape};

pub(super) struct Disk {
    pub(super) inner: f64,
    pub(super) outer: f64,
    pub(super) start: f64,
    pub(super) sweep: f64,
    pub(super) whole: bool,
}

impl Shape for Disk {
    const IS_CURVED_ACROSS: bool = false;
    const IS_CURVED_UP: bool = false;

    fn is_closed(&self) -> bool {
        self.whole
    }

    fn ends_in_points(&self) -> [bool; 2] {
        [false, self.inner == 0.0]
    }

    fn has_fans(&self, _: bool) -> bool {
        true
    }

    fn corner(&self, around: f64, inwards: f64) -> Corner {
        let [sine, cosine] = turned(self.start, self.sweep, around);
        let radius = self.outer - inwards * (self.outer - self.inner);
        let part = 0.5 * radius / self.outer;
        Corner {
            position: [radius * sine, radius * cosine, 0.0],
            normal: [0.0, 0.0, 1.0],
            texture: [0.5 + part * sine, 0.5 + part * cosine],
        }
    }
}
