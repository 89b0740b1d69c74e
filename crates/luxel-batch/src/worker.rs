//! The side of a worker process: draws the tasks that it is given, a line each, and answers with a line each.

use crate::answer::{Answer, Done, Failed};
use crate::store::Store;
use crate::work::{Work, WorkError};
use std::io::{self, BufRead, Write};
use std::path::Path;
use std::sync::mpsc;

/// Serves tasks from the standard input, whose outputs are written below `root` by way of `parts`. Ends the
/// process when the input ends, also in the middle of a task: nobody waits for it any more.
///
/// # Errors
/// An input that can't be read, or an answer that can't be written.
pub fn serve(work: &mut dyn Work, root: &Path, parts: &Path) -> io::Result<()> {
    let (lines, tasks) = mpsc::channel();
    #[expect(clippy::exit, reason = "the task at work has nobody left to be drawn for")]
    std::thread::spawn(move || {
        for line in io::stdin().lock().lines() {
            if lines.send(line).is_err() {
                return;
            }
        }
        std::process::exit(0);
    });
    let mut store = Store::new(root, parts);
    for line in tasks {
        let answer = draw(work, &line?, &mut store);
        let mut text = serde_json::to_vec(&answer)?;
        text.push(b'\n');
        let mut output = io::stdout().lock();
        output.write_all(&text)?;
        output.flush()?;
    }
    Ok(())
}

fn draw(work: &mut dyn Work, line: &str, store: &mut Store) -> Answer {
    let begun = match work.begin(line) {
        Ok(begun) => begun,
        Err(error) => return Answer::Failed(error.into()),
    };
    let mut outputs = Vec::new();
    let finished = work.finish(&mut |file| {
        outputs.push(store.put(&begun.key, &file)?);
        Ok(())
    });
    match finished {
        Ok(finished) => Answer::Done(Done::new(begun, outputs, finished)),
        Err(WorkError::Task(error)) => Answer::Failed(error.into()),
        Err(WorkError::Output(error)) => Answer::Failed(Failed {
            error: format!("an output can't be written: {error}"),
            is_in_list: false,
        }),
    }
}

/// Bounds the memory of this process: beyond, allocating ends it. Does nothing where the system has no such bound.
pub fn limit_memory(bytes: u64) {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
        let hard = getrlimit(Resource::Data).maximum;
        let bytes = hard.map_or(bytes, |hard| hard.min(bytes));
        // Without a bound, the work still goes on.
        let _ = setrlimit(Resource::Data, Rlimit { current: Some(bytes), maximum: Some(bytes) });
    }
    #[cfg(not(target_os = "linux"))]
    let _ = bytes;
}
