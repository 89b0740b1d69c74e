//! Who does the work where there are no threads: the caller. What `pool.rs` says holds here too, with one thread.
//!
//! A module of WebAssembly has no threads of its own; a page has several modules instead.

/// There are none.
#[derive(Debug)]
pub enum ThreadPool {}

/// How many threads the current pool has.
#[must_use]
pub fn threads() -> usize {
    1
}

/// Changes nothing: there is one thread.
pub fn limit_threads(_count: usize) {}

/// Changes nothing: there is one thread.
pub fn take_part(_count: usize) {}

/// `None`: see [`install`].
#[must_use]
pub fn pool(_count: usize) -> Option<ThreadPool> {
    None
}

/// Does work.
pub fn install<R>(_pool: Option<&ThreadPool>, work: impl FnOnce() -> R) -> R {
    work()
}

/// Does `work`, then `meanwhile`.
pub fn install_while<R>(
    _pool: Option<&ThreadPool>,
    work: impl FnOnce() -> R,
    meanwhile: impl FnOnce(),
) -> R {
    let result = work();
    meanwhile();
    result
}

pub(crate) fn on_threads(count: usize, work: &dyn Fn()) {
    for _ in 0..count {
        work();
    }
}

pub(crate) fn on_this_and_others(pool: &ThreadPool, _work: &dyn Fn(), _own: &mut dyn FnMut()) {
    match *pool {}
}

pub(crate) fn beside_each_other(one: &mut dyn FnMut(), other: &mut dyn FnMut()) {
    one();
    other();
}

pub(crate) fn sort<T: Ord>(keys: &mut [T]) {
    keys.sort_unstable();
}
