//! Values computed once, by work on all threads.

use std::sync::OnceLock;

/// A value that is computed when it is first needed, by work on the pool's threads.
///
/// No lock is held during the work, as [`OnceLock::get_or_init`] would hold one. A thread of a pool that waits for
/// the others takes up further work meanwhile, which may need this very value: with a lock it would wait for itself
/// for ever. Threads that need the value at the same time compute it side by side, and the first one's result is kept.
///
/// ```
/// let squares = luxel_parallel::Memo::new();
/// let compute = || luxel_parallel::gather(100, 10, &|run, list| list.extend(run.map(|n| n * n)));
/// assert_eq!(squares.get_or_compute(compute)[9], 81);
/// assert_eq!(squares.get_or_compute(|| unreachable!())[3], 9);
/// ```
#[derive(Clone, Debug)]
pub struct Memo<T>(OnceLock<T>);

impl<T> Memo<T> {
    /// One without a value.
    #[must_use]
    pub const fn new() -> Self {
        Self(OnceLock::new())
    }

    /// The value, if it has been computed.
    #[must_use]
    pub fn get(&self) -> Option<&T> {
        self.0.get()
    }

    /// The value, computed now if there is none yet.
    pub fn get_or_compute(&self, compute: impl FnOnce() -> T) -> &T {
        if let Some(value) = self.0.get() {
            return value;
        }
        let value = compute();
        self.0.get_or_init(|| value)
    }

    /// Takes the value out.
    pub fn take(&mut self) -> Option<T> {
        self.0.take()
    }
}

impl<T> Default for Memo<T> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::Memo;
    use std::sync::{Arc, mpsc};
    use std::time::Duration;

    #[test]
    fn work_taken_up_while_a_value_is_computed_waits_for_it_forever() {
        let pool = crate::pool(1).unwrap();
        let (sender, receiver) = mpsc::channel();
        let memo = Arc::new(Memo::new());
        for number in 0..2 {
            let (memo, sender) = (Arc::clone(&memo), sender.clone());
            pool.spawn(move || {
                let compute = || {
                    // As waiting for other threads does, this takes up the other work.
                    rayon::yield_now();
                    number
                };
                let _ = sender.send(*memo.get_or_compute(compute));
            });
        }
        let answer = || receiver.recv_timeout(Duration::from_secs(60)).expect("the work ends");
        assert_eq!(answer(), answer());
    }
}
