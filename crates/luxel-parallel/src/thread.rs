//! Who does the work: the threads of the current pool.

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::num::NonZero;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The threads for work outside of pools; `None` where the system refuses to create threads.
static OUTSIDE: OnceLock<Option<ThreadPool>> = OnceLock::new();

/// How many threads the current pool has.
#[must_use]
pub fn threads() -> usize {
    if rayon::current_thread_index().is_some() {
        return rayon::current_num_threads();
    }
    outside(0).map_or(1, ThreadPool::current_num_threads)
}

/// Gives work outside of pools as many threads as this; changes nothing once there has been some.
pub fn limit_threads(count: usize) {
    outside(count);
}

/// More threads a processor than this only take memory and the scheduler's time.
const MOST_A_PROCESSOR: usize = 16;

/// A pool of threads, 0 for one a processor and never more than sixteen a processor; `None` where the system
/// refuses to create them: see [`install`].
#[must_use]
pub fn pool(count: usize) -> Option<ThreadPool> {
    if cfg!(target_family = "wasm") {
        return None;
    }
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    let count = count.min(MOST_A_PROCESSOR * processors);
    ThreadPoolBuilder::new().num_threads(count).build().ok()
}

/// Does work in a pool; without one, in the current pool, or outside of pools on as many threads as the
/// system has granted, one at least.
///
/// # Panics
/// If the work does.
pub fn install<R: Send>(pool: Option<&ThreadPool>, work: impl FnOnce() -> R + Send) -> R {
    match pool {
        Some(pool) => pool.install(work),
        None if rayon::current_thread_index().is_some() => work(),
        None => match outside(0) {
            Some(pool) => pool.install(work),
            None => work(),
        },
    }
}

/// Runs `work` in a pool, as [`install`] does, and `meanwhile` on the calling thread. Returns when both have finished.
///
/// # Panics
/// If one of them does.
pub fn install_while<R: Send>(
    pool: Option<&ThreadPool>,
    work: impl FnOnce() -> R + Send,
    meanwhile: impl FnOnce(),
) -> R {
    let mut result = None;
    let done = &mut result;
    match pool.or_else(|| outside(0)) {
        Some(pool) => pool.in_place_scope(|scope| {
            scope.spawn(|_| *done = Some(work()));
            meanwhile();
        }),
        None => {
            *done = Some(work());
            meanwhile();
        }
    }
    result.unwrap_or_else(|| unreachable!("a scope ends after its work"))
}

fn outside(count: usize) -> Option<&'static ThreadPool> {
    let start = || {
        let pool = pool(count);
        if pool.is_none() {
            // What runs nevertheless takes the current thread. Fails where the program has started this
            // pool itself.
            let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
        }
        pool
    };
    OUTSIDE.get_or_init(start).as_ref()
}

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
    install(None, || (0..workers).into_par_iter().with_max_len(1).for_each(|_| while step() {}));
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
    both(&mut || a = one.take().map(|one| one()), &mut || b = other.take().map(|other| other()));
    let (Some(a), Some(b)) = (a, b) else { unreachable!("both are done") };
    (a, b)
}

fn both(one: &mut (dyn FnMut() + Send), other: &mut (dyn FnMut() + Send)) {
    install(None, || {
        rayon::join(one, other);
    });
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
    fn a_pool_of_a_million_threads_has_a_few() {
        let pool = pool(1_000_000).unwrap();
        assert!(
            pool.current_num_threads() <= 16 * std::thread::available_parallelism().unwrap().get()
        );
    }

    #[test]
    fn work_in_a_pool_runs_beside_the_calling_thread() {
        let pool = pool(1);
        for pool in [pool.as_ref(), None] {
            let (to_work, from_caller) = std::sync::mpsc::channel::<u32>();
            let (to_caller, from_work) = std::sync::mpsc::channel();
            let work = move || {
                to_caller.send(from_caller.recv().unwrap() + 1).unwrap();
                threads()
            };
            let mut answer = 0;
            let count = install_while(pool, work, || {
                to_work.send(7).unwrap();
                answer = from_work.recv().unwrap();
            });
            assert_eq!(answer, 8);
            assert!(pool.is_none() || count == 1);
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
