//! Long work without the GIL, which Ctrl-C cancels.

use luxel::render::Renderer;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Interval between checks for pending signals.
const PAUSE: Duration = Duration::from_millis(50);

/// Runs work on a thread of its own and checks for signals meanwhile; `stop` cancels the work.
///
/// # Errors
/// What a signal handler raises: `KeyboardInterrupt` for Ctrl-C.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    stop: impl Fn() + Sync,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let (sender, receiver) = channel();
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let _until_done = sender;
            work()
        });
        let interrupted = wait(py, receiver, &mut || Ok(()), &stop);
        match (interrupted, worker.join()) {
            (Err(raised), _) => Err(raised),
            (Ok(()), Ok(result)) => Ok(result),
            (Ok(()), Err(panic)) => std::panic::resume_unwind(panic),
        }
    })
}

/// [`interruptible`] on a renderer's threads, since a small picture takes hardly longer than to create a thread.
/// `work` gets a flag, and returns early once it is set.
///
/// # Errors
/// What a signal handler raises: `KeyboardInterrupt` for Ctrl-C.
pub(crate) fn interruptible_on<T: Send>(
    py: Python<'_>,
    renderer: &Renderer,
    work: impl FnOnce(&AtomicBool) -> T + Send,
) -> PyResult<T> {
    on_threads(py, renderer, &mut || Ok(()), |stop, _until_done| work(stop))
}

/// [`interruptible_on`] for 0, then for each other number below `count`, in parallel on the renderer's threads.
/// `progress` is called after each, and cancels the rest by an error.
///
/// # Errors
/// What a signal handler or `progress` raises.
pub(crate) fn interruptible_each<T: Send>(
    py: Python<'_>,
    renderer: &Renderer,
    count: usize,
    work: &(dyn Fn(usize, &AtomicBool) -> T + Sync),
    progress: &mut dyn FnMut() -> PyResult<()>,
) -> PyResult<Vec<T>> {
    let results = on_threads(py, renderer, progress, |stop, done| {
        let mut results: Vec<Option<T>> = Vec::new();
        results.resize_with(count, || None);
        let fill = |number: usize, result: &mut [Option<T>]| {
            if !stop.load(Ordering::Relaxed) {
                result[0] = Some(work(number, stop));
                // Fails only after the receiver is gone, with a panic.
                let _ = done.send(());
            }
        };
        // What all of them need is computed once, by the first.
        if let Some((first, others)) = results.split_at_mut_checked(1) {
            fill(0, first);
            luxel_parallel::fill(others, 1, &|number, result| fill(number + 1, result));
        }
        results
    })?;
    Ok(results.into_iter().flatten().collect())
}

/// Works on pieces without the GIL, on this thread and on the renderer's. Signals are checked between
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
        let mut last_check = Instant::now();
        let mut interrupted = Ok(());
        renderer.each_from_outside(pieces, work, &mut || {
            if last_check.elapsed() >= PAUSE {
                last_check = Instant::now();
                interrupted = Python::attach(|py| py.check_signals());
            }
            interrupted.is_ok()
        });
        interrupted
    })
}

/// Runs work on a renderer's threads with a stop flag and a sender, which it drops when done; `message` is called for
/// each message.
fn on_threads<T: Send>(
    py: Python<'_>,
    renderer: &Renderer,
    message: &mut dyn FnMut() -> PyResult<()>,
    work: impl FnOnce(&AtomicBool, Sender<()>) -> T + Send,
) -> PyResult<T> {
    let stop = AtomicBool::new(false);
    let (sender, receiver) = channel();
    let mut interrupted = Ok(());
    let cancel = || stop.store(true, Ordering::Relaxed);
    let result = renderer.install_while(
        || work(&stop, sender),
        || interrupted = wait(py, receiver, message, &cancel),
    );
    interrupted.map(|()| result)
}

/// Waits without the GIL until the sender is dropped, also by a panic. Calls `message` for each message and checks for
/// signals; on an error of either, calls `stop` and waits for the rest of the work.
///
/// # Errors
/// What a signal handler or `message` raises.
fn wait(
    py: Python<'_>,
    receiver: Receiver<()>,
    message: &mut dyn FnMut() -> PyResult<()>,
    stop: &dyn Fn(),
) -> PyResult<()> {
    // `detach` demands what is `Sync`.
    let receiver = Mutex::new(receiver);
    let mut last_check = Instant::now();
    loop {
        let outcome = match py.detach(|| lock(&receiver).recv_timeout(PAUSE)) {
            Err(RecvTimeoutError::Disconnected) => return Ok(()),
            Err(RecvTimeoutError::Timeout) => Ok(()),
            Ok(()) => message(),
        };
        let outcome = outcome.and_then(|()| {
            if last_check.elapsed() < PAUSE {
                return Ok(());
            }
            last_check = Instant::now();
            py.check_signals()
        });
        if outcome.is_err() {
            stop();
            py.detach(|| while lock(&receiver).recv().is_ok() {});
            return outcome;
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
