//! Runs: how work is cut into pieces, and what they give put together.

use crate::thread::{tasks, until_done};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The numbers of a run.
fn range(run: usize, length: usize, count: usize) -> Range<usize> {
    let start = run * length;
    start..count.min(start + length)
}

/// Whether one of the runs of `length` numbers below `count` has something; those that come after
/// it has been found are left out.
///
/// # Panics
/// If `length` is 0.
#[must_use]
pub fn any(count: usize, length: usize, has: &(dyn Fn(Range<usize>) -> bool + Sync)) -> bool {
    let found = AtomicBool::new(false);
    tasks(count.div_ceil(length), &|run| {
        if !found.load(Ordering::Relaxed) && has(range(run, length, count)) {
            found.store(true, Ordering::Relaxed);
        }
    });
    found.into_inner()
}

/// The lowest number that `find` gives, each of its own run.
///
/// # Panics
/// If `length` is 0.
#[must_use]
pub fn first(
    count: usize,
    length: usize,
    find: &(dyn Fn(Range<usize>) -> Option<usize> + Sync),
) -> Option<usize> {
    let lowest = AtomicUsize::new(usize::MAX);
    tasks(count.div_ceil(length), &|run| {
        let run = range(run, length, count);
        if run.start < lowest.load(Ordering::Relaxed)
            && let Some(found) = find(run)
        {
            lowest.fetch_min(found, Ordering::Relaxed);
        }
    });
    Some(lowest.into_inner()).filter(|&lowest| lowest != usize::MAX)
}

/// Works on pieces that are taken one by one, in no order. Each should be worth a thread's while.
pub fn each<T: Send>(pieces: impl ExactSizeIterator<Item = T> + Send, work: &(dyn Fn(T) + Sync)) {
    let count = pieces.len();
    let pieces = Mutex::new(pieces);
    until_done(count, &|| {
        // In a statement of its own: the lock is let go of before the work.
        let piece = pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
        piece.map(work).is_some()
    });
}

/// Writes a slice in runs of `length`: `write` gets where a run begins, and the run.
///
/// # Panics
/// If `length` is 0.
pub fn fill<T: Send>(values: &mut [T], length: usize, write: &(dyn Fn(usize, &mut [T]) + Sync)) {
    each(values.chunks_mut(length).enumerate(), &|(run, values)| write(run * length, values));
}

/// What each run of `length` numbers below `count` gives, in order.
///
/// # Panics
/// If `length` is 0.
#[must_use]
pub fn map<R: Default + Send>(
    count: usize,
    length: usize,
    of_run: &(dyn Fn(Range<usize>) -> R + Sync),
) -> Vec<R> {
    let mut results = Vec::new();
    results.resize_with(count.div_ceil(length), R::default);
    fill(&mut results, 1, &|run, result| result[0] = of_run(range(run, length, count)));
    results
}

/// What each run of `length` numbers below `count` appends to its list, one list after the other.
///
/// # Panics
/// If `length` is 0.
#[must_use]
pub fn gather<T: Send>(
    count: usize,
    length: usize,
    append: &(dyn Fn(Range<usize>, &mut Vec<T>) + Sync),
) -> Vec<T> {
    let mut lists: Vec<Vec<T>> = map(count, length, &|run| {
        let mut list = Vec::new();
        append(run, &mut list);
        list
    });
    let mut total = 0;
    for list in &lists {
        total += list.len();
    }
    let mut all = Vec::new();
    for list in &mut lists {
        if all.is_empty() {
            // A single run's list is the result.
            std::mem::swap(&mut all, list);
            all.reserve_exact(total - all.len());
        } else {
            all.append(list);
        }
        // Gives the memory back at once.
        *list = Vec::new();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{any, each, fill, first, gather, map};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn runs_give_what_a_loop_gives(count in 0..300_usize, length in 1..40_usize, divisor in 1..50_usize) {
            let is_kept = |number: &usize| number % divisor == divisor / 2;
            let expected: Vec<usize> = (0..count).filter(is_kept).collect();
            let found = gather(count, length, &|run, found| found.extend(run.filter(is_kept)));
            prop_assert_eq!(&found, &expected);
            prop_assert_eq!(first(count, length, &|mut run| run.find(is_kept)), expected.first().copied());
            prop_assert_eq!(any(count, length, &|mut run| run.any(|n| is_kept(&n))), !expected.is_empty());
            let ranges = map(count, length, &|run| vec![run]).concat();
            prop_assert!(ranges.iter().all(|run| run.len() <= length));
            prop_assert_eq!(ranges.into_iter().flatten().collect::<Vec<_>>(), (0..count).collect::<Vec<_>>());
            let mut squares = vec![0; count];
            fill(&mut squares, length, &|start, run| {
                for (number, square) in (start..).zip(run) {
                    *square = number * number;
                }
            });
            prop_assert_eq!(squares, (0..count).map(|number| number * number).collect::<Vec<_>>());
        }
    }

    #[test]
    fn every_piece_is_worked_on() {
        let mut pieces = vec![1_u32; 100];
        each(pieces.iter_mut(), &|piece| *piece += 1);
        assert_eq!(pieces, [2; 100]);
    }
}
