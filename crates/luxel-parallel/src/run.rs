//! Runs: how work is cut into pieces, and what they give put together.

use crate::pool::{ThreadPool, on_this_and_others};
use crate::thread::{tasks, until_done};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

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
        let piece = lock(&pieces).next();
        piece.map(work).is_some()
    });
}

/// [`each`] on the calling thread and on all but one of the pool's threads, so that as many work as the pool has.
/// The calling thread calls `proceed` after each of its pieces; once it returns false, the remaining pieces are skipped.
///
/// For calls of a few milliseconds from outside the pool: one thread fewer has to wake up, and the calling thread does
/// not idle.
///
/// # Panics
/// If the work does.
pub fn each_from_outside<T: Send>(
    pool: Option<&ThreadPool>,
    pieces: impl Iterator<Item = T> + Send,
    work: &(dyn Fn(T) + Sync),
    proceed: &mut dyn FnMut() -> bool,
) {
    let pieces = Mutex::new(Some(pieces));
    let next = || lock(&pieces).as_mut()?.next();
    let mut own = || {
        while let Some(piece) = next() {
            work(piece);
            if !proceed() {
                *lock(&pieces) = None;
            }
        }
    };
    let Some(pool) = pool else { return own() };
    let others = || {
        while let Some(piece) = next() {
            work(piece);
        }
    };
    on_this_and_others(pool, &others, &mut own);
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
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
        // Lists that grow are up to twice as long as what they hold.
        list.shrink_to_fit();
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
    use super::{any, each, each_from_outside, fill, first, gather, map};
    use crate::pool::pool;
    use proptest::prelude::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

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
    fn each_from_outside_visits_every_piece_and_stops_early() {
        for pool in [None, pool(1), pool(3)] {
            let mut pieces = vec![1_u32; 1000];
            each_from_outside(pool.as_ref(), pieces.iter_mut(), &|piece| *piece += 1, &mut || true);
            assert_eq!(pieces, [2; 1000]);
            // Other threads may finish some more pieces before the first one here.
            let done = AtomicUsize::new(0);
            let count = |_| {
                done.fetch_add(1, Ordering::Relaxed);
                std::thread::sleep(std::time::Duration::from_micros(50));
            };
            each_from_outside(pool.as_ref(), 0..100_000, &count, &mut || false);
            assert!(done.into_inner() < 50_000);
        }
    }

    #[test]
    fn every_piece_is_worked_on() {
        let mut pieces = vec![1_u32; 100];
        each(pieces.iter_mut(), &|piece| *piece += 1);
        assert_eq!(pieces, [2; 100]);
    }
}
