//! Cutting a run of boxes in two, where the surface area heuristic says (MacDonald and Booth 1990):
//! a ray that meets the whole meets a part in proportion to the part's surface. Candidates are the
//! borders of equal bins along an axis (Wald 2007).
//!
//! A box is eight numbers, its low corner and its high one with the other sign, so that the box
//! around two is one least of eight lanes.

use super::{Box3, Quality};
use bytemuck::{Pod, Zeroable};
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};
use luxel_parallel::{each, map};

/// A box with its thing's number: low x, y, z, the number's bits, and the high corner's -x, -y, -z.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(32))]
pub(crate) struct Ref([f32; LANES]);

const LANES: usize = 8;
/// Makes a number's bits those of a number from 2 on, which vectors take in their stride.
const NUMBER: u32 = 1 << 30;

/// A box, or the box of middles, as lanes of a [`Ref`].
pub(super) type Lanes = [f32; LANES];

const EMPTY: Lanes = [f32::INFINITY; LANES];

/// Bins along an axis; 32 were no better, 8 a little worse.
const BINS: usize = 16;
/// So many for few boxes.
const FEW_BINS: usize = 8;
const FEW: usize = 16;
/// From this on, bins are filled two at a time.
const MANY: usize = 96;
/// Above this, all three axes are tried; below, only the one along which middles spread the most.
const ALL_AXES: usize = 1 << 14;
/// Runs that one thread takes at a time where several work on one cut.
const CHUNK: usize = 1 << 14;
/// From this depth on, runs are halved: no mesh makes a tree deeper than that and 27 levels.
const HALVED_FROM: u32 = 40;
/// Added to a number of up to 22 bits, leaves it rounded in the lowest bits.
const ROUNDING: f32 = 12_582_912.0;

/// How a tree is built.
#[derive(Clone, Copy)]
pub(super) struct Care {
    pub(super) quality: Quality,
    pub(super) level: Level,
}

/// Where a run was cut, and what is known of both sides.
pub(super) struct Split {
    pub(super) at: usize,
    pub(super) sides: [Side; 2],
    /// The heuristic's cost: surfaces times counts.
    pub(super) cost: f32,
}

/// The box of a run, and the box of its boxes' middles.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub(super) bounds: Box3,
    pub(super) middles: Lanes,
}

/// The boxes of the bins along an axis, and how many are in each.
#[derive(Clone, Copy)]
struct Bins {
    boxes: [Lanes; BINS],
    counts: [u32; BINS],
}

const NO_BINS: Bins = Bins { boxes: [EMPTY; BINS], counts: [0; BINS] };

/// How middles become bins: along each axis (middle - low) * scale, rounded.
#[derive(Clone, Copy)]
struct Scale {
    low: Lanes,
    scale: Lanes,
    /// The axis along which middles spread the most.
    longest: usize,
    /// Whether all axes are tried.
    all: bool,
    bins: usize,
}

/// The best border: before which bin of which axis.
#[derive(Clone, Copy)]
struct Border {
    axis: usize,
    bin: usize,
    cost: f32,
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

    fn middle(&self, axis: usize) -> f32 {
        self.0[axis] * 0.5 - self.0[4 + axis] * 0.5
    }
}

fn box_of([a, b, c, _, x, y, z, _]: Lanes) -> Box3 {
    Box3 { low: [a, b, c], high: [-x, -y, -z] }
}

/// Middles of a box, and the same with the other sign.
#[inline(always)]
fn middles_of<S: Simd>(of: f32x8<S>) -> f32x8<S> {
    let half = of * 0.5;
    half - half.slide::<4>(half)
}

#[inline(always)]
fn lanes<S: Simd>(values: f32x8<S>) -> Lanes {
    let mut row = [0.0; LANES];
    values.store_slice(&mut row);
    row
}

/// The box around a run, and that of its middles.
pub(super) fn side_of(refs: &[Ref], level: Level) -> Side {
    let sides = map(refs.len(), CHUNK, &|run| {
        Some(dispatch_long!(level, simd => lanes_around(simd, &refs[run.clone()])))
    });
    let mut all = [EMPTY; 2];
    for side in sides.into_iter().flatten() {
        for (all, side) in all.as_flattened_mut().iter_mut().zip(side.as_flattened()) {
            *all = all.min(*side);
        }
    }
    Side { bounds: box_of(all[0]), middles: all[1] }
}

#[inline(always)]
fn lanes_around<S: Simd>(simd: S, refs: &[Ref]) -> [Lanes; 2] {
    let mut bounds = f32x8::simd_from(simd, EMPTY);
    let mut middles = bounds;
    for of in refs {
        let of = f32x8::simd_from(simd, of.0);
        bounds = bounds.min(of);
        middles = middles.min(middles_of(of));
    }
    [lanes(bounds), lanes(middles)]
}

impl Scale {
    fn new(middles: &Lanes, count: usize, quality: Quality) -> Self {
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
    fn bins<S: Simd>(&self, simd: S, middles: f32x8<S>) -> [usize; LANES] {
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

fn longest(extent: &[f32; 3]) -> usize {
    (1..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best })
}

/// Cuts a run of at least two in two, both of at least one, keeping the order within both.
pub(super) fn split(
    refs: &mut [Ref],
    scratch: &mut [Ref],
    middles: &Lanes,
    depth: u32,
    care: Care,
) -> Split {
    let scale = Scale::new(middles, refs.len(), care.quality);
    if depth < HALVED_FROM
        && let Some(split) =
            dispatch_long!(care.level, simd => split_few(simd, refs, scratch, &scale))
    {
        return split;
    }
    halved(refs, middles, depth, care)
}

/// The same for many, by all threads: what is cut goes to `scratch`, unless the result's second says
/// otherwise.
pub(super) fn split_many(
    refs: &mut [Ref],
    scratch: &mut [Ref],
    middles: &Lanes,
    depth: u32,
    care: Care,
) -> (Split, bool) {
    let scale = Scale::new(middles, refs.len(), care.quality);
    if depth >= HALVED_FROM {
        return (halved(refs, middles, depth, care), false);
    }
    let of_runs = map(refs.len(), CHUNK, &|run| {
        let refs = &refs[run.clone()];
        if scale.all {
            let mut bins = [NO_BINS; 3];
            dispatch_long!(care.level, simd => fill_all(simd, refs, &scale, &mut bins));
            bins.to_vec()
        } else {
            let mut bins = vec![NO_BINS];
            dispatch_long!(care.level, simd => fill(simd, refs, &scale, &mut bins[0]));
            bins
        }
    });
    // What was filled along each axis.
    let axes = if scale.all { vec![0, 1, 2] } else { vec![scale.longest] };
    let mut sum = vec![NO_BINS; axes.len()];
    for of_run in &of_runs {
        for (sum, of_run) in sum.iter_mut().zip(of_run) {
            dispatch_long!(care.level, simd => sum.include(simd, of_run));
        }
    }
    let mut best: Option<(usize, Border)> = None;
    for (place, bins) in sum.iter().enumerate() {
        let border = dispatch_long!(care.level, simd => bins.border(simd, axes[place], scale.bins));
        if let Some(border) = border
            && best.is_none_or(|(_, best)| border.cost < best.cost)
        {
            best = Some((place, border));
        }
    }
    let Some((place, border)) = best else {
        return (halved(refs, middles, depth, care), false);
    };
    let bins = &sum[place];
    let left_of = |bins: &Bins| bins.counts[..border.bin].iter().sum::<u32>() as usize;
    let at = left_of(bins);
    let (mut left, mut right) = scratch.split_at_mut(at);
    let mut middles = vec![[EMPTY; 2]; of_runs.len()];
    let mut pieces = Vec::with_capacity(of_runs.len());
    for ((run, of_run), middles) in refs.chunks(CHUNK).zip(&of_runs).zip(&mut middles) {
        let count = left_of(&of_run[place]);
        let (to_left, more_left) = left.split_at_mut(count);
        let (to_right, more_right) = right.split_at_mut(run.len() - count);
        (left, right) = (more_left, more_right);
        pieces.push((run, to_left, to_right, middles));
    }
    each(pieces.into_iter(), &|(run, left, right, middles)| {
        *middles =
            dispatch_long!(care.level, simd => scatter(simd, run, left, right, &scale, border));
    });
    let mut all = [EMPTY; 2];
    for of_run in &middles {
        for (all, of_run) in all.as_flattened_mut().iter_mut().zip(of_run.as_flattened()) {
            *all = all.min(*of_run);
        }
    }
    let sides = dispatch_long!(care.level, simd => bins.sides(simd, border, all));
    (Split { at, sides, cost: border.cost }, true)
}

#[inline(always)]
fn split_few<S: Simd>(
    simd: S,
    refs: &mut [Ref],
    scratch: &mut [Ref],
    scale: &Scale,
) -> Option<Split> {
    let mut bins = NO_BINS;
    fill(simd, refs, scale, &mut bins);
    let border = bins.border(simd, scale.longest, scale.bins)?;
    let (at, middles) = partition(simd, refs, scratch, scale, border);
    Some(Split { at, sides: bins.sides(simd, border, middles), cost: border.cost })
}

/// Fills the bins along the longest axis. Counts and bounds don't depend on who counted first.
#[inline(always)]
fn fill<S: Simd>(simd: S, refs: &[Ref], scale: &Scale, bins: &mut Bins) {
    if refs.len() < MANY {
        for of in refs {
            let of = f32x8::simd_from(simd, of.0);
            bins.add(simd, scale.bins(simd, middles_of(of))[scale.longest & 3], of);
        }
        return;
    }
    // Neighbours often fall into one bin and would wait for one another: every other one has bins of
    // its own.
    let mut others = NO_BINS;
    let (pairs, rest) = refs.as_chunks::<2>();
    for [one, other] in pairs {
        let one = f32x8::simd_from(simd, one.0);
        let other = f32x8::simd_from(simd, other.0);
        let place = scale.bins(simd, middles_of(one))[scale.longest & 3];
        let other_place = scale.bins(simd, middles_of(other))[scale.longest & 3];
        bins.add(simd, place, one);
        others.add(simd, other_place, other);
    }
    for of in rest {
        let of = f32x8::simd_from(simd, of.0);
        bins.add(simd, scale.bins(simd, middles_of(of))[scale.longest & 3], of);
    }
    bins.include(simd, &others);
}

/// The same along all axes, for many.
#[inline(always)]
fn fill_all<S: Simd>(simd: S, refs: &[Ref], scale: &Scale, bins: &mut [Bins; 3]) {
    let mut others = [NO_BINS; 3];
    let (pairs, rest) = refs.as_chunks::<2>();
    for [one, other] in pairs {
        let one = f32x8::simd_from(simd, one.0);
        let other = f32x8::simd_from(simd, other.0);
        let places = scale.bins(simd, middles_of(one));
        let other_places = scale.bins(simd, middles_of(other));
        for axis in 0..3 {
            bins[axis].add(simd, places[axis], one);
            others[axis].add(simd, other_places[axis], other);
        }
    }
    for of in rest {
        let of = f32x8::simd_from(simd, of.0);
        let places = scale.bins(simd, middles_of(of));
        for axis in 0..3 {
            bins[axis].add(simd, places[axis], of);
        }
    }
    for (bins, others) in bins.iter_mut().zip(&others) {
        bins.include(simd, others);
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
    fn include<S: Simd>(&mut self, simd: S, other: &Self) {
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
    fn border<S: Simd>(&self, simd: S, axis: usize, bins: usize) -> Option<Border> {
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
    fn sides<S: Simd>(&self, simd: S, border: Border, middles: [Lanes; 2]) -> [Side; 2] {
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

/// Of both sides of a border the boxes of middles.
struct Middles<S: Simd> {
    left: f32x8<S>,
    right: f32x8<S>,
}

impl<S: Simd> Middles<S> {
    #[inline(always)]
    fn include(&mut self, simd: S, middles: f32x8<S>, is_left: bool) {
        // What is on the other side is raised above all.
        const RAISED: [f32; 3] = [f32::INFINITY, f32::NEG_INFINITY, f32::INFINITY];
        let side = usize::from(is_left);
        self.left = self.left.min(middles.max(f32x8::splat(simd, RAISED[side])));
        self.right = self.right.min(middles.max(f32x8::splat(simd, RAISED[side + 1])));
    }

    #[inline(always)]
    fn lanes(&self) -> [Lanes; 2] {
        [lanes(self.left), lanes(self.right)]
    }
}

/// Brings what lies before a border to the front; where the rest begins.
#[inline(always)]
fn partition<S: Simd>(
    simd: S,
    refs: &mut [Ref],
    scratch: &mut [Ref],
    scale: &Scale,
    border: Border,
) -> (usize, [Lanes; 2]) {
    let none = f32x8::splat(simd, f32::INFINITY);
    let mut all = Middles { left: none, right: none };
    // Both places are written each time, one of them to be overwritten: no branch to foretell.
    let mut at = 0;
    for place in 0..refs.len() {
        let of = refs[place];
        let middles = middles_of(f32x8::simd_from(simd, of.0));
        let is_left = scale.bins(simd, middles)[border.axis & 3] < border.bin;
        all.include(simd, middles, is_left);
        refs[at] = of;
        scratch[place - at] = of;
        at += usize::from(is_left);
    }
    let count = refs.len() - at;
    refs[at..].copy_from_slice(&scratch[..count]);
    (at, all.lanes())
}

/// Copies a run to both sides of a border; the boxes of both sides' middles.
#[inline(always)]
fn scatter<S: Simd>(
    simd: S,
    refs: &[Ref],
    left: &mut [Ref],
    right: &mut [Ref],
    scale: &Scale,
    border: Border,
) -> [Lanes; 2] {
    let none = f32x8::splat(simd, f32::INFINITY);
    let mut all = Middles { left: none, right: none };
    let mut at = 0;
    for (place, of) in refs.iter().enumerate() {
        let middles = middles_of(f32x8::simd_from(simd, of.0));
        let is_left = scale.bins(simd, middles)[border.axis & 3] < border.bin;
        all.include(simd, middles, is_left);
        // As in `partition`; at a side's end only what belongs there.
        if let Some(to) = left.get_mut(at) {
            *to = *of;
        }
        if let Some(to) = right.get_mut(place - at) {
            *to = *of;
        }
        at += usize::from(is_left);
    }
    all.lanes()
}

/// In two halves, as they lie; deep down in the order of their middles.
fn halved(refs: &mut [Ref], middles: &Lanes, depth: u32, care: Care) -> Split {
    if depth >= HALVED_FROM {
        let longest = longest(&std::array::from_fn(|axis| -middles[4 + axis] - middles[axis]));
        refs.sort_by(|a, b| a.middle(longest).total_cmp(&b.middle(longest)));
    }
    let at = refs.len() / 2;
    let (left, right) = refs.split_at(at);
    let sides = [side_of(left, care.level), side_of(right, care.level)];
    let area = |side: usize| sides[side].bounds.half_area();
    let cost = area(0) * left.len() as f32 + area(1) * right.len() as f32;
    Split { at, sides, cost }
}
