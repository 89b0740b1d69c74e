//! Boxes as lanes of a vector, and bins that they fall into by their middles.
//!
//! A box is eight numbers, its low corner and its high one with the other sign, so that the box
//! around two is one least of eight lanes.

use super::{Box3, Quality};
use bytemuck::{Pod, Zeroable};
use luxel_math::{Simd, f32x8, prelude::*};

/// A box with its thing's number: low x, y, z, the number's bits, and the high corner's -x, -y, -z.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(32))]
pub(crate) struct Ref(pub(super) Lanes);

const LANES: usize = 8;
/// Makes a number's bits those of a number from 2 on, which vectors take in their stride.
const NUMBER: u32 = 1 << 30;

/// A box, or the box of middles, as lanes of a [`Ref`].
pub(super) type Lanes = [f32; LANES];

pub(super) const EMPTY: Lanes = [f32::INFINITY; LANES];

/// Bins along an axis; 32 were no better, 8 a little worse.
const BINS: usize = 16;
/// So many for few boxes.
const FEW_BINS: usize = 8;
const FEW: usize = 16;
/// From this on, bins are filled two at a time.
const MANY: usize = 96;
/// Above this, all three axes are tried; below, only the one along which middles spread the most.
const ALL_AXES: usize = 1 << 14;
/// Added to a number of up to 22 bits, leaves it rounded in the lowest bits.
const ROUNDING: f32 = 12_582_912.0;

/// The box of a run, and the box of its boxes' middles.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub(super) bounds: Box3,
    pub(super) middles: Lanes,
}

/// The boxes of the bins along an axis, and how many are in each.
#[derive(Clone, Copy)]
pub(super) struct Bins {
    boxes: [Lanes; BINS],
    pub(super) counts: [u32; BINS],
}

pub(super) const NO_BINS: Bins = Bins { boxes: [EMPTY; BINS], counts: [0; BINS] };

/// How middles become bins: along each axis (middle - low) * scale, rounded.
#[derive(Clone, Copy)]
pub(super) struct Scale {
    low: Lanes,
    scale: Lanes,
    /// The axis along which middles spread the most.
    pub(super) longest: usize,
    /// Whether all axes are tried.
    pub(super) all: bool,
    pub(super) bins: usize,
}

/// The best border: before which bin of which axis.
#[derive(Clone, Copy)]
pub(super) struct Border {
    pub(super) axis: usize,
    pub(super) bin: usize,
    pub(super) cost: f32,
}

impl Ref {
    /// `None` marks what is to be left out.
    pub(super) fn new(number: u32, bounds: Option<Box3>) -> Self {
        let Box3 { low: [a, b, c], high: [x, y, z] } = bounds.unwrap_or(Box3::EMPTY);
        Self([a, b, c, f32::from_bits(number | NUMBER), -x, -y, -z, 0.0])
    }

    pub(super) fn is_left_out(&self) -> bool {
        self.0[0] > -self.0[4]
    }

    pub(super) fn number(&self) -> u32 {
        self.0[3].to_bits() & !NUMBER
    }

    pub(super) fn middle(&self, axis: usize) -> f32 {
        self.0[axis] * 0.5 - self.0[4 + axis] * 0.5
    }
}

pub(super) fn box_of([a, b, c, _, x, y, z, _]: Lanes) -> Box3 {
    Box3 { low: [a, b, c], high: [-x, -y, -z] }
}

/// Middles of a box, and the same with the other sign.
#[inline(always)]
pub(super) fn middles_of<S: Simd>(of: f32x8<S>) -> f32x8<S> {
    let half = of * 0.5;
    half - half.slide::<4>(half)
}

#[inline(always)]
pub(super) fn lanes<S: Simd>(values: f32x8<S>) -> Lanes {
    let mut row = [0.0; LANES];
    values.store_slice(&mut row);
    row
}

impl Scale {
    pub(super) fn new(middles: &Lanes, count: usize, quality: Quality) -> Self {
        let low = [middles[0], middles[1], middles[2]];
        let extent: [f32; 3] = std::array::from_fn(|axis| -middles[4 + axis] - low[axis]);
        let longest = longest(&extent);
        let all = count > ALL_AXES && quality == Quality::Thorough;
        let bins = if count <= FEW { FEW_BINS } else { BINS };
        let mut scale = Self { low: [0.0; LANES], scale: [0.0; LANES], longest, all, bins };
        for axis in 0..3 {
            // A little less than half a bin before the first, so that rounding gives the bins' numbers.
            let a_bin = extent[axis] / (bins as f32 - 0.02);
            scale.low[axis] = low[axis] + a_bin * 0.49;
            scale.scale[axis] = if extent[axis] > 0.0 { 1.0 / a_bin } else { 0.0 };
        }
        scale
    }

    /// The bins of a box's middle.
    #[inline(always)]
    pub(super) fn bins<S: Simd>(&self, simd: S, middles: f32x8<S>) -> [usize; LANES] {
        let low = f32x8::simd_from(simd, self.low);
        let scale = f32x8::simd_from(simd, self.scale);
        let row = lanes((middles - low) * scale + ROUNDING);
        let mut bins = [0; LANES];
        for axis in 0..3 {
            // Whatever comes out, as from numbers too large, is a bin.
            bins[axis] = row[axis].to_bits() as usize & (self.bins - 1) & (BINS - 1);
        }
        bins
    }
}

pub(super) fn longest(extent: &[f32; 3]) -> usize {
    (1..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best })
}

/// Fills the bins along some axes. Counts and bounds don't depend on who counted first.
#[inline(always)]
pub(super) fn fill<S: Simd, const AXES: usize>(
    simd: S,
    refs: &[Ref],
    scale: &Scale,
    axes: [usize; AXES],
    bins: &mut [Bins; AXES],
) {
    let mut rest = refs;
    if refs.len() >= MANY {
        // Neighbours often fall into one bin and would wait for one another: every other one has bins
        // of its own.
        let mut others = [NO_BINS; AXES];
        let pairs;
        (pairs, rest) = refs.as_chunks::<2>();
        for [one, other] in pairs {
            let one = f32x8::simd_from(simd, one.0);
            let other = f32x8::simd_from(simd, other.0);
            let places = scale.bins(simd, middles_of(one));
            let other_places = scale.bins(simd, middles_of(other));
            for axis in 0..AXES {
                bins[axis].add(simd, places[axes[axis] & 3], one);
                others[axis].add(simd, other_places[axes[axis] & 3], other);
            }
        }
        for (bins, others) in bins.iter_mut().zip(&others) {
            bins.include(simd, others);
        }
    }
    for of in rest {
        let of = f32x8::simd_from(simd, of.0);
        let places = scale.bins(simd, middles_of(of));
        for axis in 0..AXES {
            bins[axis].add(simd, places[axes[axis] & 3], of);
        }
    }
}

impl Bins {
    #[inline(always)]
    fn add<S: Simd>(&mut self, simd: S, place: usize, of: f32x8<S>) {
        let place = place & (BINS - 1);
        let bounds = &mut self.boxes[place];
        f32x8::simd_from(simd, *bounds).min(of).store_slice(bounds);
        self.counts[place] += 1;
    }

    #[inline(always)]
    pub(super) fn include<S: Simd>(&mut self, simd: S, other: &Self) {
        for (bounds, other) in self.boxes.iter_mut().zip(&other.boxes) {
            let other = f32x8::simd_from(simd, *other);
            f32x8::simd_from(simd, *bounds).min(other).store_slice(bounds);
        }
        for (count, other) in self.counts.iter_mut().zip(&other.counts) {
            *count += other;
        }
    }

    /// The border of the least cost; none if all are in one bin.
    #[inline(always)]
    pub(super) fn border<S: Simd>(&self, simd: S, axis: usize, bins: usize) -> Option<Border> {
        let bins = bins.min(BINS);
        let empty = f32x8::simd_from(simd, EMPTY);
        let mut right = [(0.0, 0); BINS];
        let (mut bounds, mut count) = (empty, 0);
        for bin in (1..bins).rev() {
            bounds = bounds.min(f32x8::simd_from(simd, self.boxes[bin]));
            count += self.counts[bin];
            right[bin] = (half_area(bounds) * count as f32, count);
        }
        let mut best: Option<Border> = None;
        let (mut bounds, mut count) = (empty, 0);
        for bin in 1..bins {
            bounds = bounds.min(f32x8::simd_from(simd, self.boxes[bin - 1]));
            count += self.counts[bin - 1];
            let (right_cost, right_count) = right[bin];
            let cost = half_area(bounds) * count as f32 + right_cost;
            if count != 0 && right_count != 0 && best.is_none_or(|best| cost < best.cost) {
                best = Some(Border { axis, bin, cost });
            }
        }
        best
    }

    /// What is on both sides of a border.
    #[inline(always)]
    pub(super) fn sides<S: Simd>(&self, simd: S, border: Border, middles: [Lanes; 2]) -> [Side; 2] {
        let (left, right) = self.boxes.split_at(border.bin.min(BINS));
        [
            Side { bounds: box_of(around(simd, left)), middles: middles[0] },
            Side { bounds: box_of(around(simd, right)), middles: middles[1] },
        ]
    }
}

#[inline(always)]
fn around<S: Simd>(simd: S, boxes: &[Lanes]) -> Lanes {
    let mut all = f32x8::simd_from(simd, EMPTY);
    for bounds in boxes {
        all = all.min(f32x8::simd_from(simd, *bounds));
    }
    lanes(all)
}

/// Half a box's surface.
#[inline(always)]
fn half_area<S: Simd>(bounds: f32x8<S>) -> f32 {
    // Extents with the other sign: products of two have none.
    let extent = bounds + bounds.slide::<4>(bounds);
    let [x, y, z] = [extent[0], extent[1], extent[2]];
    x * (y + z) + y * z
}
