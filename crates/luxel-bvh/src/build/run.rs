//! Runs of boxes, and splitting them in two.

use super::bins::{BoxLanes, BoxRef, Side};
use super::split::{BuildSettings, split, split_many};
use crate::aabb::Aabb;
use luxel_parallel::join;

/// Runs up to this size belong to one task. A constant, so that trees don't depend on threads.
const TASK: usize = 1 << 13;

/// A run of boxes that is still to be split, or the two parts of one that was.
pub(super) enum Part<'r> {
    Run(Run<'r>),
    Split { bounds: Aabb, count: usize, parts: Box<[Self; 2]> },
}

/// Consecutive boxes.
pub(super) struct Run<'r> {
    pub(super) refs: &'r mut [BoxRef],
    pub(super) scratch: &'r mut [BoxRef],
    /// The first one's index in the order of all.
    pub(super) start: usize,
    pub(super) bounds: Aabb,
    /// The box around the centroids of the boxes.
    pub(super) centroids: BoxLanes,
    pub(super) depth: u32,
    /// Whether `refs` and `scratch` have changed places.
    pub(super) swapped: bool,
    /// Whether splitting has been found not to pay.
    pub(super) keep_whole: bool,
}

impl<'r> Run<'r> {
    /// A run of all boxes.
    pub(super) fn all(
        refs: &'r mut [BoxRef],
        scratch: &'r mut [BoxRef],
        bounds: Aabb,
        centroids: BoxLanes,
    ) -> Self {
        let (swapped, keep_whole) = (false, false);
        Self { refs, scratch, start: 0, bounds, centroids, depth: 0, swapped, keep_whole }
    }

    /// Splits the run in two.
    fn split(self, settings: BuildSettings) -> [Self; 2] {
        let split = split(self.refs, self.scratch, &self.centroids, self.depth, settings);
        self.parts(split.at, split.sides)
    }

    /// Splits a run of more than one task's size, on all threads.
    fn split_by_all(mut self, settings: BuildSettings) -> [Self; 2] {
        let (split, moved) =
            split_many(self.refs, self.scratch, &self.centroids, self.depth, settings);
        if moved {
            std::mem::swap(&mut self.refs, &mut self.scratch);
            self.swapped = !self.swapped;
        }
        self.parts(split.at, split.sides)
    }

    /// The two parts of a run whose boxes are in order around `at`.
    pub(super) fn parts(self, at: usize, [left, right]: [Side; 2]) -> [Self; 2] {
        let (left_refs, right_refs) = self.refs.split_at_mut(at);
        let (left_scratch, right_scratch) = self.scratch.split_at_mut(at);
        let (depth, swapped, keep_whole) = (self.depth + 1, self.swapped, false);
        let part = |refs, scratch, start, Side { bounds, centroids }| Run {
            refs,
            scratch,
            start,
            bounds,
            centroids,
            depth,
            swapped,
            keep_whole,
        };
        [
            part(left_refs, left_scratch, self.start, left),
            part(right_refs, right_scratch, self.start + at, right),
        ]
    }

    /// Moves the boxes back to where they belong.
    fn restored(mut self) -> Self {
        if self.swapped {
            self.scratch.copy_from_slice(self.refs);
            std::mem::swap(&mut self.refs, &mut self.scratch);
            self.swapped = false;
        }
        self
    }
}

/// Splits a run until no part exceeds a task.
pub(super) fn split_in_tasks(run: Run<'_>, settings: BuildSettings) -> Part<'_> {
    if run.refs.len() <= TASK {
        return Part::Run(run.restored());
    }
    let (bounds, count) = (run.bounds, run.refs.len());
    let [left, right] = run.split_by_all(settings);
    let (left, right) = join(|| split_in_tasks(left, settings), || split_in_tasks(right, settings));
    Part::Split { bounds, count, parts: Box::new([left, right]) }
}

impl<'r> Part<'r> {
    pub(super) fn bounds(&self) -> &Aabb {
        match self {
            Self::Run(run) => &run.bounds,
            Self::Split { bounds, .. } => bounds,
        }
    }

    pub(super) fn count(&self) -> usize {
        match self {
            Self::Run(run) => run.refs.len(),
            Self::Split { count, .. } => *count,
        }
    }

    /// Splits the part in two.
    pub(super) fn split(self, settings: BuildSettings) -> [Self; 2] {
        match self {
            Self::Run(run) => run.split(settings).map(Part::Run),
            Self::Split { parts, .. } => *parts,
        }
    }
}
