//! Cutting a run of boxes in two, where the surface area heuristic says (MacDonald and Booth 1990):
//! a ray that meets the whole meets a part in proportion to the part's surface. Candidates are the
//! borders of equal bins along an axis (Wald 2007).

use super::{Box3, Quality, higher, lower};
use luxel_parallel::map;

/// A box with its thing's number.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct Ref {
    pub(super) low: [f32; 3],
    pub(super) id: u32,
    pub(super) high: [f32; 3],
    /// Fills the 32 bytes.
    pub(super) spare: u32,
}

/// Bins along an axis; 32 were no better, 8 a little worse.
const BINS: usize = 16;
/// Above this, all three axes are tried; below, only the one along which middles spread the most.
const ALL_AXES: usize = 1 << 14;
/// Above this, bins are filled by several threads, in runs of this size.
const PARALLEL: usize = 1 << 15;
/// From this depth on, runs are halved: no mesh makes a tree deeper than that and 27 levels.
const HALVED_FROM: u32 = 40;

/// Where a run was cut, and the boxes of both sides.
pub(super) struct Split {
    pub(super) at: usize,
    pub(super) left: Box3,
    pub(super) right: Box3,
    /// The heuristic's cost: surfaces times counts.
    pub(super) cost: f32,
}

#[derive(Clone, Copy, Default)]
struct Bin {
    bounds: Box3,
    count: u32,
}

type Bins = [[Bin; BINS]; 3];

const NO_BINS: Bins = [[Bin { bounds: Box3::EMPTY, count: 0 }; BINS]; 3];

/// How middles become bins: along each axis (middle - low) * scale.
#[derive(Clone, Copy)]
struct Scale {
    low: [f32; 3],
    scale: [f32; 3],
    axes: [bool; 3],
}

impl Ref {
    fn middle(&self, axis: usize) -> f32 {
        self.low[axis] * 0.5 + self.high[axis] * 0.5
    }

    pub(super) fn bounds(&self) -> Box3 {
        Box3 { low: self.low, high: self.high }
    }
}

impl Scale {
    #[inline(always)]
    fn bin(&self, of: &Ref, axis: usize) -> usize {
        // What isn't a number becomes 0.
        (((of.middle(axis) - self.low[axis]) * self.scale[axis]) as usize).min(BINS - 1)
    }
}

/// Cuts a run of at least two in two, both of at least one, keeping the order within both.
pub(super) fn split(refs: &mut [Ref], scratch: &mut [Ref], depth: u32, quality: Quality) -> Split {
    let middles = middles(refs);
    let extent: [f32; 3] = std::array::from_fn(|axis| middles.high[axis] - middles.low[axis]);
    let longest =
        (1..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best });
    if depth >= HALVED_FROM {
        refs.sort_by(|a, b| a.middle(longest).total_cmp(&b.middle(longest)));
        return halved(refs);
    }
    let all = refs.len() > ALL_AXES && quality == Quality::Thorough;
    let scale = Scale {
        low: middles.low,
        scale: extent.map(|extent| if extent > 0.0 { BINS as f32 / extent } else { 0.0 }),
        axes: std::array::from_fn(|axis| (all || axis == longest) && extent[axis] > 0.0),
    };
    let bins = filled(refs, &scale);
    let mut best: Option<(f32, usize, usize, Box3, Box3)> = None;
    for axis in (0..3).filter(|&axis| scale.axes[axis]) {
        let mut right = [(Box3::EMPTY, 0); BINS];
        let mut sum = (Box3::EMPTY, 0);
        for bin in (1..BINS).rev() {
            sum = (sum.0.union(&bins[axis][bin].bounds), sum.1 + bins[axis][bin].count);
            right[bin] = sum;
        }
        let mut left = (Box3::EMPTY, 0);
        for bin in 1..BINS {
            left = (left.0.union(&bins[axis][bin - 1].bounds), left.1 + bins[axis][bin - 1].count);
            let (right, right_count) = right[bin];
            if left.1 == 0 || right_count == 0 {
                continue;
            }
            let cost = left.0.half_area() * left.1 as f32 + right.half_area() * right_count as f32;
            if best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, bin, left.0, right));
            }
        }
    }
    let Some((cost, axis, bin, left, right)) = best else { return halved(refs) };
    let at = partition(refs, scratch, &scale, axis, bin);
    Split { at, left, right, cost }
}

/// The box of the middles.
fn middles(refs: &[Ref]) -> Box3 {
    let of_run = |refs: &[Ref]| {
        let mut bounds = Box3::EMPTY;
        for of in refs {
            bounds.include([of.middle(0), of.middle(1), of.middle(2)]);
        }
        bounds
    };
    if refs.len() > PARALLEL {
        united(&map(refs.len(), PARALLEL, &|run| of_run(&refs[run])))
    } else {
        of_run(refs)
    }
}

/// The bins of a run. Counts and bounds don't depend on who counted first.
fn filled(refs: &[Ref], scale: &Scale) -> Bins {
    let of_run = |refs: &[Ref]| {
        let mut bins = NO_BINS;
        for axis in (0..3).filter(|&axis| scale.axes[axis]) {
            let bins = &mut bins[axis];
            for of in refs {
                let bin = &mut bins[scale.bin(of, axis)];
                bin.bounds = bin.bounds.union(&of.bounds());
                bin.count += 1;
            }
        }
        bins
    };
    if refs.len() <= PARALLEL {
        return of_run(refs);
    }
    let mut sum = NO_BINS;
    for bins in map(refs.len(), PARALLEL, &|run| of_run(&refs[run])) {
        for (sum, bin) in sum.as_flattened_mut().iter_mut().zip(bins.as_flattened()) {
            sum.bounds = sum.bounds.union(&bin.bounds);
            sum.count += bin.count;
        }
    }
    sum
}

/// Brings what lies in bins before `bin` to the front; where the rest begins.
fn partition(
    refs: &mut [Ref],
    scratch: &mut [Ref],
    scale: &Scale,
    axis: usize,
    bin: usize,
) -> usize {
    // Both places are written each time, one of them to be overwritten: no branch to foretell.
    let mut at = 0;
    for place in 0..refs.len() {
        let of = refs[place];
        let is_left = scale.bin(&of, axis) < bin;
        refs[at] = of;
        scratch[place - at] = of;
        at += usize::from(is_left);
    }
    let count = refs.len() - at;
    refs[at..].copy_from_slice(&scratch[..count]);
    at
}

/// In two halves, as they lie.
fn halved(refs: &[Ref]) -> Split {
    let at = refs.len() / 2;
    let bounds = |refs: &[Ref]| refs.iter().fold(Box3::EMPTY, |all, of| all.union(&of.bounds()));
    let (left, right) = (bounds(&refs[..at]), bounds(&refs[at..]));
    let cost = left.half_area() * at as f32 + right.half_area() * (refs.len() - at) as f32;
    Split { at, left, right, cost }
}

/// The box of a run, by several threads.
pub(super) fn bounds_of(refs: &[Ref]) -> Box3 {
    let of_run = |refs: &[Ref]| {
        let mut bounds = Box3::EMPTY;
        for of in refs {
            for axis in 0..3 {
                bounds.low[axis] = lower(of.low[axis], bounds.low[axis]);
                bounds.high[axis] = higher(of.high[axis], bounds.high[axis]);
            }
        }
        bounds
    };
    united(&map(refs.len(), PARALLEL, &|run| of_run(&refs[run])))
}

/// The box around boxes.
fn united(boxes: &[Box3]) -> Box3 {
    boxes.iter().fold(Box3::EMPTY, |all, bounds| all.union(bounds))
}
