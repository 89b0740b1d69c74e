//! Items that have boxes.

use super::bins::BoxRef;
use crate::aabb::Aabb;
use std::ops::Range;

/// Items per task where each takes little time.
pub(super) const CHUNK: usize = 1 << 13;

/// Items that have boxes. The provided methods process many per virtual call.
pub(crate) trait Boxes: Sync {
    /// The number of items.
    fn count(&self) -> usize;

    /// The box of one item; `None` excludes it from the tree.
    fn bounds(&self, number: usize) -> Option<Aabb>;

    /// Writes the boxes of the items from `start` on.
    fn write_refs(&self, start: usize, refs: &mut [BoxRef]) {
        for (number, of) in (start..).zip(refs) {
            *of = BoxRef::new(number as u32, self.bounds(number));
        }
    }

    /// Appends the numbers of the items of a run that have a box.
    fn append_included(&self, run: Range<usize>, numbers: &mut Vec<u32>) {
        for number in run {
            if self.bounds(number).is_some() {
                numbers.push(number as u32);
            }
        }
    }

    /// The box around several items.
    fn union(&self, numbers: &[u32]) -> Aabb {
        let mut all = Aabb::EMPTY;
        for &number in numbers {
            if let Some(bounds) = self.bounds(number as usize) {
                all = all.union(&bounds);
            }
        }
        all
    }
}
