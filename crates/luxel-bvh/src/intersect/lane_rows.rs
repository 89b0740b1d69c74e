//! Values of a packet's rays side by side, processed in groups as wide as the vectors.

use super::sheared::ShearedRay;
use crate::aabb::{higher, lower};
use luxel_math::{LANES, Lanes};

/// The most rays of a packet: a miss of a node's box then costs each ray a 64th of a test.
pub(crate) const PACKET: usize = 64;

/// One value per ray of a packet.
pub(crate) type Row = [[f32; LANES]; PACKET / LANES];

pub(crate) const EMPTY_ROW: Row = [[0.0; LANES]; PACKET / LANES];

/// A packet's rays in the form of the triangle test; see [`ShearedRay`](super::ShearedRay).
#[repr(C)]
pub(crate) struct ShearedRows {
    pub(crate) origin: [Row; 3],
    pub(crate) shear: [Row; 3],
}

impl ShearedRows {
    /// One of the rays; all share their longest axis, `last`, and its sign.
    #[inline(always)]
    pub(crate) fn ray(&self, at: usize, last: usize, is_negative: bool) -> ShearedRay {
        let ([x, y, z], [sx, sy, sz]) = (&self.origin, &self.shear);
        ShearedRay {
            last,
            is_negative,
            origin: [lane(x, at), lane(y, at), lane(z, at)],
            shear: [lane(sx, at), lane(sy, at), lane(sz, at)],
        }
    }
}

/// Rays per group.
#[inline(always)]
pub(crate) const fn width<N: Lanes>() -> usize {
    size_of::<N>() / size_of::<f32>()
}

/// The values of a group; `lanes` selects the lane type.
#[inline(always)]
pub(crate) fn load<N: Lanes>(lanes: N, row: &Row, group: usize) -> N {
    let at = group * width::<N>();
    lanes.load(&row[at / LANES % row.len()], at % LANES)
}

#[inline(always)]
pub(crate) fn store<N: Lanes>(values: N, row: &mut Row, group: usize) {
    let at = group * width::<N>();
    values.store(&mut row[at / LANES % (PACKET / LANES)], at % LANES);
}

/// The value of one ray.
#[inline(always)]
pub(crate) fn lane(row: &Row, ray: usize) -> f32 {
    row.as_flattened()[ray % PACKET]
}

/// The minimum and maximum over several groups, lane by lane.
#[derive(Clone, Copy)]
pub(crate) struct LaneRange<N> {
    least: N,
    greatest: N,
}

impl<N: Lanes> LaneRange<N> {
    #[inline(always)]
    pub(crate) fn empty(lanes: N) -> Self {
        let (least, greatest) = (f32::INFINITY, f32::NEG_INFINITY);
        Self { least: lanes.constant(least), greatest: lanes.constant(greatest) }
    }

    #[inline(always)]
    pub(crate) fn include(&mut self, values: N) {
        self.least = self.least.minimum(values);
        self.greatest = self.greatest.maximum(values);
    }

    /// The minimum over all lanes.
    #[inline(always)]
    pub(crate) fn least(&self) -> f32 {
        let mut lanes = [0.0; LANES];
        self.least.store(&mut lanes, 0);
        let mut half = width::<N>() / 2;
        while half > 0 {
            for lane in 0..half {
                lanes[lane] = lower(lanes[lane + half], lanes[lane]);
            }
            half /= 2;
        }
        lanes[0]
    }

    /// The maximum over all lanes.
    #[inline(always)]
    pub(crate) fn greatest(&self) -> f32 {
        greatest(self.greatest)
    }

    /// The minimum and the maximum over all lanes.
    #[inline(always)]
    pub(crate) fn ends(&self) -> [f32; 2] {
        [self.least(), self.greatest()]
    }
}

/// The maximum over the lanes of a group.
#[inline(always)]
pub(crate) fn greatest<N: Lanes>(values: N) -> f32 {
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
