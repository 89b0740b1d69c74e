//! Cutting a run of boxes in two, where the surface area heuristic says (MacDonald and Booth 1990):
//! a ray that meets the whole meets a part in proportion to the part's surface. Candidates are the
//! borders of equal bins along an axis (Wald 2007).

use super::Quality;
use super::bins::{
    Bins, Border, EMPTY, Lanes, NO_BINS, Ref, Scale, Side, box_of, fill, lanes, longest, middles_of,
};
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};
use luxel_parallel::{each, map};

/// Runs that one thread takes at a time where several work on one cut.
const CHUNK: usize = 1 << 14;
/// From this depth on, runs are halved: no mesh makes a tree deeper than that and 27 levels.
const HALVED_FROM: u32 = 40;

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
            dispatch_long!(care.level, simd => fill(simd, refs, &scale, [0, 1, 2], &mut bins));
            bins.to_vec()
        } else {
            let mut bins = [NO_BINS];
            dispatch_long!(care.level, simd => fill(simd, refs, &scale, [scale.longest], &mut bins));
            bins.to_vec()
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
    let mut bins = [NO_BINS];
    fill(simd, refs, scale, [scale.longest], &mut bins);
    let [bins] = bins;
    let border = bins.border(simd, scale.longest, scale.bins)?;
    let (at, middles) = partition(simd, refs, scratch, scale, border);
    Some(Split { at, sides: bins.sides(simd, border, middles), cost: border.cost })
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
