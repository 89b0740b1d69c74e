//! Numbers of many rays side by side, asked in groups: as many at a time as vectors are wide.

use crate::bvh::{higher, lower};
use luxel_math::{LANES, Number};

/// Most rays of a bundle: a miss of a node's box then costs a 64th of a test.
pub(crate) const BUNDLE: usize = 64;

/// A number of each ray of a bundle.
pub(crate) type Row = [[f32; LANES]; BUNDLE / LANES];

pub(crate) const NO_ROW: Row = [[0.0; LANES]; BUNDLE / LANES];

/// What triangles are asked with.
#[repr(C)]
pub(crate) struct ShearedRows {
    pub(crate) origin: [Row; 3],
    pub(crate) shear: [Row; 3],
}

/// Rays of a group.
#[inline(always)]
pub(crate) const fn width<N: Number>() -> usize {
    size_of::<N>() / size_of::<f32>()
}

/// The numbers of a group; `like` tells only the kind.
#[inline(always)]
pub(crate) fn load<N: Number>(like: N, row: &Row, group: usize) -> N {
    let at = group * width::<N>();
    like.load(&row[at / LANES % row.len()], at % LANES)
}

#[inline(always)]
pub(crate) fn store<N: Number>(values: N, row: &mut Row, group: usize) {
    let at = group * width::<N>();
    values.store(&mut row[at / LANES % (BUNDLE / LANES)], at % LANES);
}

/// The number of one ray.
#[inline(always)]
pub(crate) fn one(row: &Row, ray: usize) -> f32 {
    row.as_flattened()[ray % BUNDLE]
}

/// The least and the greatest of several groups, lane by lane.
#[derive(Clone, Copy)]
pub(crate) struct Range<N> {
    least: N,
    greatest: N,
}

impl<N: Number> Range<N> {
    #[inline(always)]
    pub(crate) fn none(like: N) -> Self {
        let (least, greatest) = (f32::INFINITY, f32::NEG_INFINITY);
        Self { least: like.constant(least), greatest: like.constant(greatest) }
    }

    #[inline(always)]
    pub(crate) fn include(&mut self, values: N) {
        self.least = self.least.minimum(values);
        self.greatest = self.greatest.maximum(values);
    }

    /// The least and the greatest of all.
    #[inline(always)]
    pub(crate) fn ends(&self) -> [f32; 2] {
        let mut lanes = [0.0; LANES];
        self.least.store(&mut lanes, 0);
        let mut half = width::<N>() / 2;
        while half > 0 {
            for lane in 0..half {
                lanes[lane] = lower(lanes[lane + half], lanes[lane]);
            }
            half /= 2;
        }
        [lanes[0], greatest(self.greatest)]
    }

    #[inline(always)]
    pub(crate) fn width(&self) -> f32 {
        let [least, greatest] = self.ends();
        greatest - least
    }
}

/// The greatest of a group.
#[inline(always)]
pub(crate) fn greatest<N: Number>(values: N) -> f32 {
    let mut lanes = [0.0; LANES];
    values.store(&mut lanes, 0);
    let mut half = width::<N>() / 2;
    while half > 0 {
        for lane in 0..half {
            lanes[lane] = higher(lanes[lane + half], lanes[lane]);
        }
        half /= 2;
    }
    lanes[0]
}
