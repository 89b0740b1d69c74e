//! Who does the work: threads of `rayon`.

use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use std::num::NonZero;
use std::sync::OnceLock;

pub use rayon::ThreadPool;

/// The threads for work outside of pools.
static OUTSIDE: OnceLock<Outside> = OnceLock::new();

struct Outside {
    /// The number that they were made for: 0 for one a processor.
    count: usize,
    /// `None` where the system refuses to create threads.
    pool: Option<ThreadPool>,
}

/// How many threads the current pool has.
#[must_use]
pub fn threads() -> usize {
    if rayon::current_thread_index().is_some() {
        return rayon::current_num_threads();
    }
    outside().map_or(1, ThreadPool::current_num_threads)
}

/// Gives work outside of pools as many threads as this; changes nothing once there has been some.
pub fn limit_threads(count: usize) {
    OUTSIDE.get_or_init(|| Outside::new(count, builder(count)));
}

/// Gives work outside of pools as many threads as this, 0 for one a processor, the calling thread among them; changes
/// nothing once there has been some.
///
/// For programs that do all of it from this thread, which works itself then instead of waiting, in memory that it has
/// used before. Other threads have to wait for it where it is the only one.
pub fn take_part(count: usize) {
    OUTSIDE.get_or_init(|| Outside::new(count, builder(count).use_current_thread()));
}

/// More threads a processor than this only take memory and the scheduler's time.
const MOST_A_PROCESSOR: usize = 16;

/// A pool of threads, 0 for one a processor and never more than sixteen a processor; `None` where the calling thread
/// [takes part](take_part) in as many already, and where the system refuses to create them: see [`install`].
#[must_use]
pub fn pool(count: usize) -> Option<ThreadPool> {
    let takes_part = |pool: &ThreadPool| pool.current_thread_index().is_some();
    let has_as_many = |Outside { count: own, pool }: &Outside| {
        *own == count && pool.as_ref().is_some_and(takes_part)
    };
    if OUTSIDE.get().is_some_and(has_as_many) {
        return None;
    }
    builder(count).build().ok()
}

fn builder(count: usize) -> ThreadPoolBuilder {
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    ThreadPoolBuilder::new().num_threads(count.min(MOST_A_PROCESSOR * processors))
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
        None => match outside() {
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
    let pool = match pool {
        None => outside(),
        own => own,
    };
    match pool {
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

fn outside() -> Option<&'static ThreadPool> {
    OUTSIDE.get_or_init(|| Outside::new(0, builder(0))).pool.as_ref()
}

impl Outside {
    fn new(count: usize, builder: ThreadPoolBuilder) -> Self {
        let pool = builder.build().ok();
        if pool.is_none() {
            // What runs nevertheless takes the current thread. Fails where the program has started this
            // pool itself.
            let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
        }
        Self { count, pool }
    }
}

/// Calls `work` on as many threads, one call a thread, and returns when all have returned.
pub(crate) fn on_threads(count: usize, work: &(dyn Fn() + Sync)) {
    install(None, || (0..count).into_par_iter().with_max_len(1).for_each(|_| work()));
}

/// Calls `own` on the calling thread, and `work` on all but one of the pool's.
pub(crate) fn on_this_and_others(
    pool: &ThreadPool,
    work: &(dyn Fn() + Sync),
    own: &mut dyn FnMut(),
) {
    pool.in_place_scope(|scope| {
        for _ in 1..pool.current_num_threads() {
            scope.spawn(|_| work());
        }
        own();
    });
}

/// Does two things, side by side if a thread is free.
pub(crate) fn beside_each_other(one: &mut (dyn FnMut() + Send), other: &mut (dyn FnMut() + Send)) {
    install(None, || {
        rayon::join(one, other);
    });
}

/// Sorts on all threads.
pub(crate) fn sort<T: Ord + Send>(keys: &mut [T]) {
    install(None, || keys.par_sort_unstable());
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
