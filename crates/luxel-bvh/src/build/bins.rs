//! Boxes as vectors of eight lanes, and bins that they fall into by their centroids.
//!
//! A box stores its low corner and the negated high corner, so that the union of two boxes is one
//! minimum of eight lanes.

use super::quality::Quality;
use crate::aabb::Aabb;
use bytemuck::{Pod, Zeroable};
use luxel_math::{Simd, f32x8, prelude::*};

/// A box with its item's number: low x, y, z, the number's bits, and -x, -y, -z of the high corner.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(32))]
pub(crate) struct BoxRef(pub(super) BoxLanes);

const LANES: usize = 8;
/// Makes an item number the bits of a normal `f32` from 2 on: vector units stall on subnormal ones.
const NUMBER: u32 = 1 << 30;

/// A box in the layout of a [`BoxRef`].
pub(super) type BoxLanes = [f32; LANES];

pub(super) const EMPTY: BoxLanes = [f32::INFINITY; LANES];

/// Bins per axis; 32 were no better, 8 a little worse.
const BINS: usize = 16;
/// Bins per axis for up to [`FEW`] boxes.
const FEW_BINS: usize = 8;
const FEW: usize = 16;
/// From this many boxes on, bins are filled two at a time.
const MANY: usize = 96;
/// Above this many boxes all three axes are tried; below, only the one along which centroids spread
/// the most. Trying all three in small runs too cost a ray as many instructions, and the tree a little
/// more.
const ALL_AXES: usize = 1 << 14;
/// Adding this to a number of up to 22 bits leaves it, rounded, in the lowest bits.
const ROUNDING: f32 = 12_582_912.0;

/// The box around a run, and the box around its centroids.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub(super) bounds: Aabb,
    pub(super) centroids: BoxLanes,
}

/// The boxes of the bins along an axis, and their counts.
#[derive(Clone, Copy)]
pub(super) struct Bins {
    boxes: [BoxLanes; BINS],
    pub(super) counts: [u32; BINS],
}

pub(super) const NO_BINS: Bins = Bins { boxes: [EMPTY; BINS], counts: [0; BINS] };

/// Maps centroids to bins: `(centroid - low) * scale` along each axis, rounded.
#[derive(Clone, Copy)]
pub(super) struct BinMapping {
    low: BoxLanes,
    scale: BoxLanes,
    /// The axis along which centroids spread the most.
    pub(super) longest: usize,
    /// Whether all axes are tried.
    pub(super) all: bool,
    pub(super) bins: usize,
}

/// A candidate plane: the axis, and the first bin behind it.
#[derive(Clone, Copy)]
pub(super) struct SplitPlane {
    pub(super) axis: usize,
    pub(super) bin: usize,
    pub(super) cost: f32,
}

impl BoxRef {
    /// `None` marks an item to exclude.
    pub(super) fn new(number: u32, bounds: Option<Aabb>) -> Self {
        let Aabb { low: [a, b, c], high: [x, y, z] } = bounds.unwrap_or(Aabb::EMPTY);
        Self([a, b, c, f32::from_bits(number | NUMBER), -x, -y, -z, 0.0])
    }

    pub(super) fn is_excluded(&self) -> bool {
        self.0[0] > -self.0[4]
    }

    pub(super) fn number(&self) -> u32 {
        self.0[3].to_bits() & !NUMBER
    }

    pub(super) fn centroid(&self, axis: usize) -> f32 {
        self.0[axis] * 0.5 - self.0[4 + axis] * 0.5
    }
}

pub(super) fn box_of([a, b, c, _, x, y, z, _]: BoxLanes) -> Aabb {
    Aabb { low: [a, b, c], high: [-x, -y, -z] }
}

/// The centroid of a box, and its negation.
#[inline(always)]
pub(super) fn centroids_of<S: Simd>(of: f32x8<S>) -> f32x8<S> {
    let half = of * 0.5;
    half - half.slide::<4>(half)
}

#[inline(always)]
pub(super) fn lanes<S: Simd>(values: f32x8<S>) -> BoxLanes {
    let mut row = [0.0; LANES];
    values.store_slice(&mut row);
    row
}

impl BinMapping {
    pub(super) fn new(centroids: &BoxLanes, count: usize, quality: Quality) -> Self {
        let low = [centroids[0], centroids[1], centroids[2]];
        let extent: [f32; 3] = std::array::from_fn(|axis| -centroids[4 + axis] - low[axis]);
        let longest = longest(&extent);
        let all = count > ALL_AXES && quality == Quality::Thorough;
        let bins = if count <= FEW { FEW_BINS } else { BINS };
        let mut scale = Self { low: [0.0; LANES], scale: [0.0; LANES], longest, all, bins };
        for axis in 0..3 {
            // Begins a little less than half a bin below the first bin, so that rounding yields bin
            // indices.
            let a_bin = extent[axis] / (bins as f32 - 0.02);
            scale.low[axis] = low[axis] + a_bin * 0.49;
            scale.scale[axis] = if extent[axis] > 0.0 { 1.0 / a_bin } else { 0.0 };
        }
        scale
    }

    /// The bin of a centroid along each axis.
    #[inline(always)]
    pub(super) fn bins<S: Simd>(&self, simd: S, centroids: f32x8<S>) -> [usize; LANES] {
        let low = f32x8::simd_from(simd, self.low);
        let scale = f32x8::simd_from(simd, self.scale);
        let row = lanes((centroids - low) * scale + ROUNDING);
        let mut bins = [0; LANES];
        for axis in 0..3 {
            // Masked, so that overflow still yields a bin.
            bins[axis] = row[axis].to_bits() as usize & (self.bins - 1) & (BINS - 1);
        }
        bins
    }
}

pub(super) fn longest(extent: &[f32; 3]) -> usize {
    (1..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best })
}

/// Fills the bins along some axes. Counts and boxes don't depend on the order.
///
/// Neighbours often fall into the same bin, where each would wait for the store of the one before, so
/// two sets of bins are filled alternately and merged.
#[inline(always)]
pub(super) fn fill<S: Simd, const AXES: usize>(
    simd: S,
    refs: &[BoxRef],
    scale: &BinMapping,
    axes: [usize; AXES],
    bins: &mut [Bins; AXES],
) {
    let mut rest = refs;
    if refs.len() >= MANY {
        let mut others = [NO_BINS; AXES];
        let pairs;
        (pairs, rest) = refs.as_chunks::<2>();
        for [one, other] in pairs {
            let one = f32x8::simd_from(simd, one.0);
            let other = f32x8::simd_from(simd, other.0);
            let bins_at = scale.bins(simd, centroids_of(one));
            let other_bins_at = scale.bins(simd, centroids_of(other));
            for axis in 0..AXES {
                bins[axis].add(simd, bins_at[axes[axis] & 3], one);
                others[axis].add(simd, other_bins_at[axes[axis] & 3], other);
            }
        }
        for (bins, others) in bins.iter_mut().zip(&others) {
            bins.include(simd, others);
        }
    }
    for of in rest {
        let of = f32x8::simd_from(simd, of.0);
        let bins_at = scale.bins(simd, centroids_of(of));
        for axis in 0..AXES {
            bins[axis].add(simd, bins_at[axes[axis] & 3], of);
        }
    }
}

impl Bins {
    #[inline(always)]
    fn add<S: Simd>(&mut self, simd: S, bin: usize, of: f32x8<S>) {
        let bin = bin & (BINS - 1);
        let bounds = &mut self.boxes[bin];
        f32x8::simd_from(simd, *bounds).min(of).store_slice(bounds);
        self.counts[bin] += 1;
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

    /// The plane of the lowest cost; `None` if all centroids are in one bin.
    #[inline(always)]
    pub(super) fn best_plane<S: Simd>(
        &self,
        simd: S,
        axis: usize,
        bins: usize,
    ) -> Option<SplitPlane> {
        let bins = bins.min(BINS);
        let empty = f32x8::simd_from(simd, EMPTY);
        let mut right = [(0.0, 0); BINS];
        let (mut bounds, mut count) = (empty, 0);
        for bin in (1..bins).rev() {
            bounds = bounds.min(f32x8::simd_from(simd, self.boxes[bin]));
            count += self.counts[bin];
            right[bin] = (half_area(bounds) * count as f32, count);
        }
        let mut best: Option<SplitPlane> = None;
        let (mut bounds, mut count) = (empty, 0);
        for bin in 1..bins {
            bounds = bounds.min(f32x8::simd_from(simd, self.boxes[bin - 1]));
            count += self.counts[bin - 1];
            let (right_cost, right_count) = right[bin];
            let cost = half_area(bounds) * count as f32 + right_cost;
            if count != 0 && right_count != 0 && best.is_none_or(|best| cost < best.cost) {
                best = Some(SplitPlane { axis, bin, cost });
            }
        }
        best
    }

    /// The boxes on both sides of a plane.
    #[inline(always)]
    pub(super) fn sides<S: Simd>(
        &self,
        simd: S,
        plane: SplitPlane,
        centroids: [BoxLanes; 2],
    ) -> [Side; 2] {
        let (left, right) = self.boxes.split_at(plane.bin.min(BINS));
        [
            Side { bounds: box_of(around(simd, left)), centroids: centroids[0] },
            Side { bounds: box_of(around(simd, right)), centroids: centroids[1] },
        ]
    }
}

#[inline(always)]
fn around<S: Simd>(simd: S, boxes: &[BoxLanes]) -> BoxLanes {
    let mut all = f32x8::simd_from(simd, EMPTY);
    for bounds in boxes {
        all = all.min(f32x8::simd_from(simd, *bounds));
    }
    lanes(all)
}

/// Half the surface area of a box.
#[inline(always)]
fn half_area<S: Simd>(bounds: f32x8<S>) -> f32 {
    // Extents are negated; products of two aren't.
    let extent = bounds + bounds.slide::<4>(bounds);
    let [x, y, z] = [extent[0], extent[1], extent[2]];
    x * (y + z) + y * z
}
