//! Worker processes: started, given tasks, killed past a time limit, replaced.

use crate::answer::{Answer, Failed};
use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::Duration;

/// How tasks are tried.
#[derive(Clone, Debug)]
pub struct Limits {
    /// The longest a task may take.
    pub time: Duration,
    /// How often a task is tried that ends its worker.
    pub tries: u32,
    /// How many tasks a worker draws before another one takes its place.
    pub tasks_a_worker: u32,
}

/// A place for a worker process, and the process while there is one.
pub struct Seat {
    line: Vec<OsString>,
    limits: Limits,
    worker: Option<Worker>,
}

struct Worker {
    child: Child,
    tasks: Option<ChildStdin>,
    answers: Receiver<io::Result<String>>,
    drawn: u32,
}

impl Worker {
    fn start(line: &[OsString]) -> io::Result<Self> {
        let [program, arguments @ ..] = line else {
            return Err(io::Error::other("no program for workers"));
        };
        let mut child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let (sender, answers) = mpsc::channel();
        let output = child.stdout.take().ok_or_else(|| io::Error::other("no output"))?;
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines() {
                if sender.send(line).is_err() {
                    return;
                }
            }
        });
        Ok(Self { tasks: child.stdin.take(), child, answers, drawn: 0 })
    }

    /// The answer to a task, or why there is none: the worker then is gone.
    fn draw(&mut self, task: &str, time: Duration) -> Result<Answer, String> {
        let tasks = self.tasks.as_mut().ok_or("the worker has no input")?;
        let given = tasks.write_all(format!("{task}\n").as_bytes()).and_then(|()| tasks.flush());
        if given.is_err() {
            return Err(self.end());
        }
        match self.answers.recv_timeout(time) {
            Ok(Ok(answer)) => serde_json::from_str(&answer)
                .map_err(|error| format!("the worker's answer can't be read: {error}")),
            Ok(Err(_)) | Err(RecvTimeoutError::Disconnected) => Err(self.end()),
            Err(RecvTimeoutError::Timeout) => {
                let _ = self.child.kill();
                let _ = self.child.wait();
                Err(format!("it took longer than {} seconds", time.as_secs_f64()))
            }
        }
    }

    /// How the process ended.
    fn end(&mut self) -> String {
        self.tasks = None;
        match self.child.wait() {
            Ok(status) => format!("its worker ended: {status}"),
            Err(error) => format!("its worker ended: {error}"),
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // The end of its input ends it.
        self.tasks = None;
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl std::fmt::Debug for Seat {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { line, limits, .. } = self;
        formatter.debug_struct("Seat").field("line", line).field("limits", limits).finish()
    }
}

impl Seat {
    /// A place for workers that a line starts.
    #[must_use]
    pub fn new(line: Vec<OsString>, limits: Limits) -> Self {
        Self { line, limits, worker: None }
    }

    /// Draws a task and gives its answer as JSON, as logs have it: its key, inputs, outputs and times, or its error.
    ///
    /// # Errors
    /// A worker can't be started.
    pub fn draw_to_json(&mut self, task: &str) -> io::Result<String> {
        Ok(serde_json::to_string(&self.draw(task)?)?)
    }

    /// Draws a task, several times if it ends its workers.
    ///
    /// # Errors
    /// A worker can't be started.
    pub(crate) fn draw(&mut self, task: &str) -> io::Result<Answer> {
        let mut why = String::new();
        for _ in 0..self.limits.tries.max(1) {
            if self.worker.as_ref().is_some_and(|worker| worker.drawn >= self.limits.tasks_a_worker)
            {
                self.worker = None;
            }
            let worker = match &mut self.worker {
                Some(worker) => worker,
                none => none.insert(Worker::start(&self.line)?),
            };
            worker.drawn += 1;
            match worker.draw(task, self.limits.time) {
                Ok(answer) => return Ok(answer),
                Err(error) => {
                    self.worker = None;
                    why = error;
                }
            }
        }
        let tries = match self.limits.tries {
            0 | 1 => String::new(),
            tries => format!(", {tries} times"),
        };
        Ok(Answer::Failed(Failed { error: format!("{why}{tries}"), is_in_list: false }))
    }
}
