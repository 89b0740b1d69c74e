//! Long work without the interpreter's lock, which Ctrl-C ends.

use pyo3::prelude::*;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How often the interpreter is asked for signals while work goes on.
const PAUSE: Duration = Duration::from_millis(50);

/// Runs work on a thread of its own; `stop` ends it early. Signals are looked at meanwhile.
///
/// # Errors
/// What a signal handler raises: `KeyboardInterrupt` for Ctrl-C.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    stop: impl Fn() + Sync,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let (done, waiting) = channel();
    // Shared with a closure that the interpreter's lock may not enter.
    let waiting = Mutex::new(waiting);
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let result = work();
            // Without a receiver, the result is fetched by `join`.
            let _ = done.send(());
            result
        });
        let mut interrupted = None;
        loop {
            let waited = py.detach(|| lock(&waiting).recv_timeout(PAUSE));
            if !matches!(waited, Err(RecvTimeoutError::Timeout)) {
                break;
            }
            if let Err(raised) = py.check_signals() {
                stop();
                interrupted = Some(raised);
                break;
            }
        }
        let result = py.detach(|| worker.join());
        match (interrupted, result) {
            (Some(raised), _) => Err(raised),
            (None, Ok(result)) => Ok(result),
            (None, Err(panic)) => std::panic::resume_unwind(panic),
        }
    })
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
