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
    let (lives, ended) = channel();
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let _lives = lives;
            work()
        });
        let interrupted = listen(py, ended, &mut || Ok(()), &stop);
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
    let asked = &stop;
    let (lives, ended) = channel();
    let work = move || {
        let _lives = lives;
        work(asked)
    };
    let mut interrupted = Ok(());
    let end = || stop.store(true, Ordering::Relaxed);
    let listen = || interrupted = listen(py, ended, &mut || Ok(()), &end);
    let result = renderer.install_while(work, listen);
    interrupted.map(|()| result)
}

/// [`interruptible_on`] for each of some numbers, on all threads of the renderer; after each, `heard` is called, which may
/// end the work by an error.
///
/// # Errors
/// What a signal handler raises, or `heard`.
pub(crate) fn interruptible_each<T: Send>(
    py: Python<'_>,
    renderer: &Renderer,
    count: usize,
    work: &(dyn Fn(usize, &AtomicBool) -> T + Sync),
    heard: &mut dyn FnMut() -> PyResult<()>,
) -> PyResult<Vec<T>> {
    let stop = AtomicBool::new(false);
    let asked = &stop;
    let (done, finished) = channel();
    let all = move || {
        let mut results: Vec<Option<T>> = Vec::new();
        results.resize_with(count, || None);
        luxel_parallel::fill(&mut results, 1, &|number, result| {
            if !asked.load(Ordering::Relaxed) {
                result[0] = Some(work(number, asked));
                // Nobody listens after an error.
                let _ = done.send(());
            }
        });
        results
    };
    let mut interrupted = Ok(());
    let end = || stop.store(true, Ordering::Relaxed);
    let results = renderer.install_while(all, || interrupted = listen(py, finished, heard, &end));
    interrupted.map(|()| results.into_iter().flatten().collect())
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

/// Waits without the lock until the work hangs up, also by a panic. `heard` is called for each message of it, and signals
/// are looked at. After an error of either, `stop` is called, and what is left of the work waited for.
///
/// # Errors
/// What a signal handler raises, or `heard`.
fn listen(
    py: Python<'_>,
    messages: Receiver<()>,
    heard: &mut dyn FnMut() -> PyResult<()>,
    stop: &dyn Fn(),
) -> PyResult<()> {
    // Shared with a closure that the interpreter's lock may not enter.
    let messages = Mutex::new(messages);
    let mut looked = Instant::now();
    loop {
        let found = match py.detach(|| lock(&messages).recv_timeout(PAUSE)) {
            Err(RecvTimeoutError::Disconnected) => return Ok(()),
            Err(RecvTimeoutError::Timeout) => Ok(()),
            Ok(()) => heard(),
        };
        let found = found.and_then(|()| {
            if looked.elapsed() < PAUSE {
                return Ok(());
            }
            looked = Instant::now();
            py.check_signals()
        });
        if found.is_err() {
            stop();
            py.detach(|| while lock(&messages).recv().is_ok() {});
            return found;
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
