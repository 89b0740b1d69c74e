//! Work handed out to the threads of the current pool.

use crate::pool::{beside_each_other, on_threads, threads};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Calls `work` with every number below `count`, in no order. Each should be worth a thread's
/// while: ten microseconds at least.
pub fn tasks(count: usize, work: &(dyn Fn(usize) + Sync)) {
    let next = AtomicUsize::new(0);
    until_done(count, &|| {
        let number = next.fetch_add(1, Ordering::Relaxed);
        if number < count {
            work(number);
        }
        number < count
    });
}

/// Calls `step` again and again, on all threads but no more than `most`, until it says that nothing
/// is left.
pub(crate) fn until_done(most: usize, step: &(dyn Fn() -> bool + Sync)) {
    // A single step needs no pool.
    let workers = if most <= 1 { most } else { threads().min(most) };
    if workers <= 1 {
        while step() {}
        return;
    }
    on_threads(workers, &|| while step() {});
}

/// Does two things, side by side if a thread is free.
///
/// # Panics
/// If one of them does.
pub fn join<A: Send, B: Send>(
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    let (mut one, mut other) = (Some(one), Some(other));
    let (mut a, mut b) = (None, None);
    beside_each_other(&mut || a = one.take().map(|one| one()), &mut || {
        b = other.take().map(|other| other());
    });
    let (Some(a), Some(b)) = (a, b) else { unreachable!("both are done") };
    (a, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[test]
    fn every_task_is_done_once() {
        for count in [0, 1, 2, 3, 1000] {
            let done = Mutex::new(Vec::new());
            tasks(count, &|number| done.lock().unwrap().push(number));
            let mut done = done.into_inner().unwrap();
            done.sort_unstable();
            assert_eq!(done, (0..count).collect::<Vec<_>>());
        }
    }

    #[test]
    fn tasks_may_be_nested() {
        let sum = AtomicUsize::new(0);
        tasks(50, &|outer| {
            tasks(50, &|inner| {
                sum.fetch_add(outer * inner, Ordering::Relaxed);
            });
        });
        assert_eq!(sum.into_inner(), 1225 * 1225);
    }

    #[test]
    fn both_sides_of_a_join_are_done() {
        let mut count = 0;
        let text = String::from("moved");
        assert_eq!(join(|| count += 1, || text), ((), "moved".to_owned()));
        assert_eq!(count, 1);
    }
}
