//! Splits a run of boxes in two by the surface area heuristic (MacDonald and Booth 1990): a ray that
//! hits the whole hits a part with a probability proportional to the part's surface. Candidates are
//! the planes between equal bins along an axis (Wald 2007).

use super::bins::{
    BinMapping, Bins, BoxLanes, BoxRef, EMPTY, NO_BINS, Side, SplitPlane, box_of, centroids_of,
    fill, lanes, longest,
};
use super::quality::Quality;
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};
use luxel_parallel::{each, map};

/// Boxes per task where several threads work on one split.
const CHUNK: usize = 1 << 14;
/// From this depth on, runs are split at the median, so no mesh makes a tree of more than this and 27
/// levels.
const MEDIAN_FROM: u32 = 40;

/// How a tree is built: its quality, and the SIMD level of the builder.
#[derive(Clone, Copy)]
pub(super) struct BuildSettings {
    pub(super) quality: Quality,
    pub(super) level: Level,
}

/// The result of a split.
pub(super) struct Split {
    pub(super) at: usize,
    pub(super) sides: [Side; 2],
    /// The cost by the heuristic: surface areas times counts.
    pub(super) cost: f32,
}

/// The box around a run, and the box around its centroids.
pub(super) fn side_of(refs: &[BoxRef], level: Level) -> Side {
    let sides = map(refs.len(), CHUNK, &|run| {
        Some(dispatch_long!(level, simd => lanes_around(simd, &refs[run.clone()])))
    });
    let mut all = [EMPTY; 2];
    for side in sides.into_iter().flatten() {
        for (all, side) in all.as_flattened_mut().iter_mut().zip(side.as_flattened()) {
            *all = all.min(*side);
        }
    }
    Side { bounds: box_of(all[0]), centroids: all[1] }
}

#[inline(always)]
fn lanes_around<S: Simd>(simd: S, refs: &[BoxRef]) -> [BoxLanes; 2] {
    let mut bounds = f32x8::simd_from(simd, EMPTY);
    let mut centroids = bounds;
    for of in refs {
        let of = f32x8::simd_from(simd, of.0);
        bounds = bounds.min(of);
        centroids = centroids.min(centroids_of(of));
    }
    [lanes(bounds), lanes(centroids)]
}

/// Splits a run of at least two into two parts of at least one, keeping the order within both.
pub(super) fn split(
    refs: &mut [BoxRef],
    scratch: &mut [BoxRef],
    centroids: &BoxLanes,
    depth: u32,
    settings: BuildSettings,
) -> Split {
    let mapping = BinMapping::new(centroids, refs.len(), settings.quality);
    if depth < MEDIAN_FROM
        && let Some(split) =
            dispatch_long!(settings.level, simd => split_small(simd, refs, scratch, &mapping))
    {
        return split;
    }
    split_median(refs, centroids, depth, settings)
}

/// Splits a large run on all threads. The boxes end up in `scratch` if the second result is true.
pub(super) fn split_many(
    refs: &mut [BoxRef],
    scratch: &mut [BoxRef],
    centroids: &BoxLanes,
    depth: u32,
    settings: BuildSettings,
) -> (Split, bool) {
    let mapping = BinMapping::new(centroids, refs.len(), settings.quality);
    if depth >= MEDIAN_FROM {
        return (split_median(refs, centroids, depth, settings), false);
    }
    let of_runs = map(refs.len(), CHUNK, &|run| {
        let refs = &refs[run.clone()];
        if mapping.all {
            let mut bins = [NO_BINS; 3];
            dispatch_long!(settings.level, simd => fill(simd, refs, &mapping, [0, 1, 2], &mut bins));
            bins.to_vec()
        } else {
            let mut bins = [NO_BINS];
            dispatch_long!(settings.level, simd => fill(simd, refs, &mapping, [mapping.longest], &mut bins));
            bins.to_vec()
        }
    });
    // The axes whose bins were filled.
    let axes = if mapping.all { vec![0, 1, 2] } else { vec![mapping.longest] };
    let mut sum = vec![NO_BINS; axes.len()];
    for of_run in &of_runs {
        for (sum, of_run) in sum.iter_mut().zip(of_run) {
            dispatch_long!(settings.level, simd => sum.include(simd, of_run));
        }
    }
    let mut best: Option<(usize, SplitPlane)> = None;
    for (index, bins) in sum.iter().enumerate() {
        let plane = dispatch_long!(settings.level, simd => bins.best_plane(simd, axes[index], mapping.bins));
        if let Some(plane) = plane
            && best.is_none_or(|(_, best)| plane.cost < best.cost)
        {
            best = Some((index, plane));
        }
    }
    let Some((index, plane)) = best else {
        return (split_median(refs, centroids, depth, settings), false);
    };
    let bins = &sum[index];
    let left_of = |bins: &Bins| bins.counts[..plane.bin].iter().sum::<u32>() as usize;
    let at = left_of(bins);
    let (mut left, mut right) = scratch.split_at_mut(at);
    let mut centroids = vec![[EMPTY; 2]; of_runs.len()];
    let mut pieces = Vec::with_capacity(of_runs.len());
    for ((run, of_run), centroids) in refs.chunks(CHUNK).zip(&of_runs).zip(&mut centroids) {
        let count = left_of(&of_run[index]);
        let (to_left, more_left) = left.split_at_mut(count);
        let (to_right, more_right) = right.split_at_mut(run.len() - count);
        (left, right) = (more_left, more_right);
        pieces.push((run, to_left, to_right, centroids));
    }
    each(pieces.into_iter(), &|(run, left, right, centroids)| {
        *centroids = dispatch_long!(settings.level, simd => scatter(simd, run, left, right, &mapping, plane));
    });
    let mut all = [EMPTY; 2];
    for of_run in &centroids {
        for (all, of_run) in all.as_flattened_mut().iter_mut().zip(of_run.as_flattened()) {
            *all = all.min(*of_run);
        }
    }
    let sides = dispatch_long!(settings.level, simd => bins.sides(simd, plane, all));
    (Split { at, sides, cost: plane.cost }, true)
}

#[inline(always)]
fn split_small<S: Simd>(
    simd: S,
    refs: &mut [BoxRef],
    scratch: &mut [BoxRef],
    mapping: &BinMapping,
) -> Option<Split> {
    let mut bins = [NO_BINS];
    fill(simd, refs, mapping, [mapping.longest], &mut bins);
    let [bins] = bins;
    let plane = bins.best_plane(simd, mapping.longest, mapping.bins)?;
    let (at, centroids) = partition(simd, refs, scratch, mapping, plane);
    Some(Split { at, sides: bins.sides(simd, plane, centroids), cost: plane.cost })
}

/// The boxes around the centroids on both sides of a plane.
struct CentroidBounds<S: Simd> {
    left: f32x8<S>,
    right: f32x8<S>,
}

impl<S: Simd> CentroidBounds<S> {
    #[inline(always)]
    fn include(&mut self, simd: S, centroids: f32x8<S>, is_left: bool) {
        // Raises the lanes of the other side above all others.
        const RAISED: [f32; 3] = [f32::INFINITY, f32::NEG_INFINITY, f32::INFINITY];
        let side = usize::from(is_left);
        self.left = self.left.min(centroids.max(f32x8::splat(simd, RAISED[side])));
        self.right = self.right.min(centroids.max(f32x8::splat(simd, RAISED[side + 1])));
    }

    #[inline(always)]
    fn lanes(&self) -> [BoxLanes; 2] {
        [lanes(self.left), lanes(self.right)]
    }
}

/// Moves the boxes before a plane to the front; returns their count. The boxes of centroids, which the
/// next split needs, come with it.
#[inline(always)]
fn partition<S: Simd>(
    simd: S,
    refs: &mut [BoxRef],
    scratch: &mut [BoxRef],
    mapping: &BinMapping,
    plane: SplitPlane,
) -> (usize, [BoxLanes; 2]) {
    let none = f32x8::splat(simd, f32::INFINITY);
    let mut all = CentroidBounds { left: none, right: none };
    // Writes to both destinations, one of which is overwritten next: no branch to mispredict.
    let mut at = 0;
    for index in 0..refs.len() {
        let of = refs[index];
        let centroids = centroids_of(f32x8::simd_from(simd, of.0));
        let is_left = mapping.bins(simd, centroids)[plane.axis & 3] < plane.bin;
        all.include(simd, centroids, is_left);
        refs[at] = of;
        scratch[index - at] = of;
        at += usize::from(is_left);
    }
    let count = refs.len() - at;
    refs[at..].copy_from_slice(&scratch[..count]);
    (at, all.lanes())
}

/// Copies a run to both sides of a plane; returns the boxes around both sides' centroids.
#[inline(always)]
fn scatter<S: Simd>(
    simd: S,
    refs: &[BoxRef],
    left: &mut [BoxRef],
    right: &mut [BoxRef],
    mapping: &BinMapping,
    plane: SplitPlane,
) -> [BoxLanes; 2] {
    let none = f32x8::splat(simd, f32::INFINITY);
    let mut all = CentroidBounds { left: none, right: none };
    let mut at = 0;
    for (index, of) in refs.iter().enumerate() {
        let centroids = centroids_of(f32x8::simd_from(simd, of.0));
        let is_left = mapping.bins(simd, centroids)[plane.axis & 3] < plane.bin;
        all.include(simd, centroids, is_left);
        // As in `partition`, but without writing beyond the end of a side.
        if let Some(to) = left.get_mut(at) {
            *to = *of;
        }
        if let Some(to) = right.get_mut(index - at) {
            *to = *of;
        }
        at += usize::from(is_left);
    }
    all.lanes()
}

/// Splits in two halves, as the boxes lie or, deep down, by the order of their centroids.
fn split_median(
    refs: &mut [BoxRef],
    centroids: &BoxLanes,
    depth: u32,
    settings: BuildSettings,
) -> Split {
    if depth >= MEDIAN_FROM {
        let longest = longest(&std::array::from_fn(|axis| -centroids[4 + axis] - centroids[axis]));
        refs.sort_by(|a, b| a.centroid(longest).total_cmp(&b.centroid(longest)));
    }
    let at = refs.len() / 2;
    let (left, right) = refs.split_at(at);
    let sides = [side_of(left, settings.level), side_of(right, settings.level)];
    let area = |side: usize| sides[side].bounds.half_area();
    let cost = area(0) * left.len() as f32 + area(1) * right.len() as f32;
    Split { at, sides, cost }
}
