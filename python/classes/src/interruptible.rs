//! Long work without the interpreter's lock, which Ctrl-C ends.

use luxel::render::Renderer;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

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
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let result = work();
            // Without a receiver, the result is fetched by `join`.
            let _ = done.send(());
            result
        });
        let interrupted = wait(py, waiting, &stop);
        match (interrupted, worker.join()) {
            (Err(raised), _) => Err(raised),
            (Ok(()), Ok(result)) => Ok(result),
            (Ok(()), Err(panic)) => std::panic::resume_unwind(panic),
        }
    })
}

/// [`interruptible`] on the threads of a renderer: a small picture takes not much longer than to create a thread. The
/// work ends early once what it is given is true.
///
/// # Errors
/// What a signal handler raises: `KeyboardInterrupt` for Ctrl-C.
pub(crate) fn interruptible_on<T: Send>(
    py: Python<'_>,
    renderer: &Renderer,
    work: impl FnOnce(&AtomicBool) -> T + Send,
) -> PyResult<T> {
    let stop = AtomicBool::new(false);
    let (done, waiting) = channel();
    let asked = &stop;
    // Owns `done`, so that a panic hangs up.
    let work = move || {
        let result = work(asked);
        let _ = done.send(());
        result
    };
    let mut interrupted = Ok(());
    let raise = || stop.store(true, Ordering::Relaxed);
    let result = renderer.install_while(work, || interrupted = wait(py, waiting, &raise));
    interrupted.map(|()| result)
}

/// Works on pieces without the interpreter's lock, by this thread and the renderer's. Signals are looked at between
/// pieces, which should take a few milliseconds at most.
///
/// # Errors
/// What a signal handler raises: `KeyboardInterrupt` for Ctrl-C.
pub(crate) fn interruptible_pieces<T: Send>(
    py: Python<'_>,
    renderer: &Renderer,
    pieces: impl Iterator<Item = T> + Send,
    work: &(dyn Fn(T) + Sync),
) -> PyResult<()> {
    py.detach(|| {
        let mut looked = Instant::now();
        let mut interrupted = Ok(());
        renderer.each_from_outside(pieces, work, &mut || {
            if looked.elapsed() >= PAUSE {
                looked = Instant::now();
                interrupted = Python::attach(|py| py.check_signals());
            }
            interrupted.is_ok()
        });
        interrupted
    })
}

/// Waits without the lock for the work's end. After a signal that raises something, `stop` is called first.
///
/// # Errors
/// What a signal handler raises.
fn wait(py: Python<'_>, done: Receiver<()>, stop: &dyn Fn()) -> PyResult<()> {
    // Shared with a closure that the interpreter's lock may not enter.
    let done = Mutex::new(done);
    loop {
        let waited = py.detach(|| lock(&done).recv_timeout(PAUSE));
        if !matches!(waited, Err(RecvTimeoutError::Timeout)) {
            return Ok(());
        }
        if let Err(raised) = py.check_signals() {
            stop();
            // Work that panics hangs up.
            let _ = py.detach(|| lock(&done).recv());
            return Err(raised);
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
