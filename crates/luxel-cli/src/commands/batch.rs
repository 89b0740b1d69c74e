//! `luxel batch`: long lists of pictures.

mod flag_reader;
mod layers;
mod options;
mod painter;
mod task;
mod verification;

use crate::console::Console;
use crate::failure::Failure;
use crate::output;
use crate::program;
use crate::progress::Progress;
use clap::{Args, Command, FromArgMatches, Subcommand};
use luxel_batch::{
    Event, Limits, List, Output, Plan, RunError, Seat, Share, Summary, Work, WorkError,
    limit_memory, path_of, run, serve,
};
use options::{BatchExecution, ProgressKind, RunOptions, WorkerOptions};
use painter::Painter;
use serde_json::json;
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::{self, Read};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicI32, Ordering};
use std::time::Duration;
use verification::VerifyOptions;

/// Render a list of tasks, each a model with its views
///
/// TASKS has a JSON object a line: {"id": "a1", "model": "a.glb", "orbit": {"count": 12}, "layers": ["rgba",
/// "z"], "size": "224x224"}; other keys are the flags of `luxel render`. Worker processes draw;
/// outputs appear whole or not at all under OUT, which may be resumed at any time, and
/// OUT/manifest.json lists them with their digests. For example: luxel batch tasks.jsonl -o out
#[derive(Args, Debug)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct BatchCommand {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    run: RunOptions,
}

#[derive(Subcommand, Debug)]
enum Action {
    Verify(VerifyOptions),
    #[command(hide = true)]
    Worker(WorkerOptions),
}

impl BatchCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        match self.action {
            None => draw(self.run, console),
            Some(Action::Verify(options)) => options.run(console),
            Some(Action::Worker(options)) => work(options),
        }
    }
}

/// The tasks of a file, or of the standard input.
fn list(tasks: &OsString) -> Result<List, Failure> {
    if tasks != "-" {
        return Ok(List::File(PathBuf::from(tasks)));
    }
    let mut bytes = Vec::new();
    let read = io::stdin().lock().read_to_end(&mut bytes);
    read.map_err(|error| Failure::work(format!("standard input: {error}"), ""))?;
    Ok(List::Bytes(bytes))
}

/// The failure of a list that can't be read.
fn list_failure(list: &List, error: &io::Error) -> Failure {
    let name = match list {
        List::File(path) => path.display().to_string(),
        List::Bytes(_) => "standard input".to_owned(),
    };
    Failure::work(format!("{name}: {error}"), "name a file with a JSON object a line")
}

/// The line that starts a worker, up to its folders.
fn worker_line(folder: PathBuf, execution: &BatchExecution) -> Vec<OsString> {
    let mut line = program::line();
    line.extend(["batch".into(), "worker".into(), "--folder".into(), folder.into()]);
    line.push(format!("--threads={}", execution.threads).into());
    line.push(format!("--simd={}", execution.simd.name()).into());
    line.push(format!("--max-memory={}", execution.max_memory).into());
    line
}

/// How tasks are tried.
fn limits(execution: &BatchExecution) -> Limits {
    /// Whatever grows in a process is small again after so many tasks.
    const TASKS_A_WORKER: u32 = 1000;
    Limits {
        time: Duration::from_secs_f64(execution.time_limit),
        tries: execution.tries,
        tasks_a_worker: TASKS_A_WORKER,
    }
}

fn draw(options: RunOptions, console: Console) -> Result<(), Failure> {
    let (Some(tasks), Some(out)) = (&options.tasks, &options.output) else {
        return Err(Failure::Usage("luxel batch needs TASKS and -o OUT".to_owned()));
    };
    let list = list(tasks)?;
    let plan = Plan {
        worker: worker_line(list.folder(), &options.execution),
        workers: options.workers.unwrap_or_else(cores),
        limits: limits(&options.execution),
        share: options.shard.map(|(number, count)| Share { number, count }),
        archive_size: options.tar,
        version: env!("CARGO_PKG_VERSION").to_owned(),
        out: out.clone(),
        list,
    };
    let stop = Arc::new(AtomicBool::new(false));
    let signal = stop_on_signals(&stop);
    let mut bar = None;
    let mut finished = (0_u64, 0_u64);
    let summary = run(&plan, &stop, &mut |event| {
        match event {
            Event::Begun { tasks, whole } => {
                finished = (*whole, *tasks);
                let open = usize::try_from(tasks - whole).unwrap_or(usize::MAX);
                if options.progress == ProgressKind::Bar {
                    bar = Some(Progress::new(console, open, "tasks"));
                }
                if *whole > 0 {
                    console.detail(&format!("{whole} of {tasks} tasks are whole already"));
                }
            }
            Event::Drawn { .. } => finished.0 += 1,
            Event::Failed { id, error } => {
                finished.0 += 1;
                let what = match id {
                    Some(id) => format!("{id}: {error}"),
                    None => (*error).to_owned(),
                };
                match &bar {
                    Some(bar) => bar.hidden(|| console.warn(&what)),
                    None if options.progress == ProgressKind::Bar => console.warn(&what),
                    None => {}
                }
            }
        }
        if let (Some(bar), Event::Drawn { .. } | Event::Failed { .. }) = (&bar, event) {
            bar.step();
        }
        if options.progress == ProgressKind::Json {
            eprintln!("{}", progress_line(event, finished));
        }
    });
    if let Some(bar) = bar {
        bar.finish();
    }
    let summary = summary.map_err(|error| match error {
        RunError::List(error) => list_failure(&plan.list, &error),
        RunError::Out(error) => Failure::work(
            format!("can't be written: {error}"),
            "choose another folder with -o, or make this one writable",
        ),
        RunError::Worker(error) => Failure::work(format!("workers can't be started: {error}"), ""),
    })?;
    report(&summary, &options, console, signal.load(Ordering::Relaxed))
}

/// How many workers there are if nobody says it.
fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Sets a flag on SIGTERM and SIGINT, so that tasks at work are finished; a second one ends the program. The number of
/// the signal, 0 without one.
fn stop_on_signals(stop: &Arc<AtomicBool>) -> Arc<AtomicI32> {
    let signal = Arc::new(AtomicI32::new(0));
    #[cfg(unix)]
    fail_to_write_long_files(Arc::default());
    #[cfg(unix)]
    for number in [signal_hook::consts::SIGTERM, signal_hook::consts::SIGINT] {
        use signal_hook::flag;
        // Without a handler, the signal ends the program: what is whole stays.
        let _ = flag::register_conditional_shutdown(number, 128 + number, Arc::clone(stop));
        let _ = flag::register(number, Arc::clone(stop));
        let told = Arc::new(AtomicBool::new(false));
        let _ = flag::register(number, Arc::clone(&told));
        let signal = Arc::clone(&signal);
        std::thread::spawn(move || {
            while !told.load(Ordering::Relaxed) {
                std::thread::sleep(Duration::from_millis(50));
            }
            signal.store(number, Ordering::Relaxed);
        });
    }
    let _ = stop;
    signal
}

/// Makes a file beyond the limit of `ulimit -f` an error, which otherwise ends the program.
#[cfg(unix)]
fn fail_to_write_long_files(heard: Arc<AtomicBool>) {
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, heard);
}

/// A line of `--progress json`.
fn progress_line(event: &Event<'_>, (finished, tasks): (u64, u64)) -> serde_json::Value {
    match event {
        Event::Begun { whole, .. } => json!({"event": "begun", "tasks": tasks, "whole": whole}),
        Event::Drawn { id, outputs } => json!({
            "event": "drawn", "id": id, "outputs": outputs, "finished": finished, "tasks": tasks,
        }),
        Event::Failed { id, error } => json!({
            "event": "failed", "id": id, "error": error, "finished": finished, "tasks": tasks,
        }),
    }
}

fn report(
    summary: &Summary,
    options: &RunOptions,
    console: Console,
    signal: i32,
) -> Result<(), Failure> {
    let Summary { tasks, whole, drawn, failed, manifest } = summary;
    if options.json {
        output::print_json(&json!({
            "tasks": tasks,
            "whole": whole,
            "drawn": drawn,
            "failed": failed,
            "manifest": manifest.as_ref().map(|(path, _)| path.to_string_lossy()),
            "root": manifest.as_ref().map(|(_, root)| root.to_string()),
        }))?;
    } else if let Some((path, root)) = manifest {
        console.notice(&format!(
            "{drawn} tasks drawn, {whole} were whole, {failed} failed; {}: {root}",
            path.display()
        ));
    }
    match manifest {
        None => {
            let left = tasks - whole - drawn - failed;
            console.notice(&format!("stopped: {left} of {tasks} tasks are left; run it again"));
            // Machines that are taken away say so by SIGTERM: nothing is wrong then.
            match signal {
                2 => Err(Failure::Interrupted),
                _ => Ok(()),
            }
        }
        Some(_) if *failed > 0 => {
            Err(Failure::work(format!("{failed} of {tasks} tasks failed"), ""))
        }
        Some(_) => Ok(()),
    }
}

/// Serves tasks until the input ends.
fn work(options: WorkerOptions) -> Result<(), Failure> {
    let WorkerOptions { folder, root, parts, execution } = options;
    // A model, its trees and a picture may each take the limit.
    limit_memory(execution.max_memory.saturating_mul(3).saturating_add(1 << 28));
    #[cfg(unix)]
    {
        // The coordinator hears of Ctrl-C, and decides.
        let ignored = Arc::new(AtomicBool::new(false));
        let _ = signal_hook::flag::register(signal_hook::consts::SIGINT, Arc::clone(&ignored));
        fail_to_write_long_files(ignored);
    }
    luxel_parallel::take_part(execution.threads);
    let mut painter = Painter::new(folder, execution.painting());
    serve(&mut painter, &root, &parts)
        .map_err(|error| Failure::work(format!("a worker's input or output failed: {error}"), ""))
}

/// A place for a worker whose outputs are written below a folder, by way of another one.
///
/// # Errors
/// The message for flags that are refused.
pub(crate) fn seat(
    folder: PathBuf,
    folders: [PathBuf; 2],
    flags: &[String],
) -> Result<Seat, String> {
    let command = BatchExecution::augment_args(Command::new("worker").no_binary_name(true));
    let matches = command.try_get_matches_from(flags).map_err(|error| error.to_string())?;
    let execution =
        BatchExecution::from_arg_matches(&matches).map_err(|error| error.to_string())?;
    let mut line = worker_line(folder, &execution);
    line.extend(folders.map(OsString::from));
    Ok(Seat::new(line, limits(&execution)))
}

/// A task, drawn in this process.
#[derive(Clone, Debug)]
pub struct DrawnTask {
    /// The name by content of its outputs: 64 hexadecimal digits.
    pub key: String,
    /// The outputs, in the order of views and layers.
    pub outputs: Vec<DrawnOutput>,
    /// Parts of the model that were left out or replaced.
    pub warnings: Vec<String>,
}

/// An output in memory.
#[derive(Clone, Debug)]
pub struct DrawnOutput {
    /// The number of the view, from 0.
    pub view: u32,
    /// The name of the view, if it has one.
    pub name: Option<String>,
    /// The layer.
    pub layer: String,
    /// Where a folder of outputs has it.
    pub path: String,
    /// The digest of its bytes: 64 hexadecimal digits.
    pub sha256: String,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// Draws a task in this process, and keeps the model for the next one of the same thread.
pub(crate) fn draw_in_memory(line: &str, folder: PathBuf) -> Result<DrawnTask, String> {
    thread_local! {
        static PAINTER: RefCell<Option<(PathBuf, Painter)>> = const { RefCell::new(None) };
    }
    PAINTER.with_borrow_mut(|known| {
        if known.as_ref().is_none_or(|(of, _)| *of != folder) {
            let execution = BatchExecution::default().painting();
            luxel_parallel::limit_threads(execution.threads);
            *known = Some((folder.clone(), Painter::new(folder, execution)));
        }
        let Some((_, painter)) = known else { return Err("no painter".to_owned()) };
        let begun = painter.begin(line).map_err(|error| error.text)?;
        let mut outputs = Vec::new();
        let finished = painter.finish(&mut |file| {
            let output = Output::new(&file, path_of(&begun.key, &file.file));
            let Output { view, name, layer, path, sha256, .. } = output;
            let sha256 = sha256.to_string();
            outputs.push(DrawnOutput { view, name, layer, path, sha256, bytes: file.bytes });
            Ok(())
        });
        let warnings = match finished {
            Ok(finished) => finished.warnings,
            Err(WorkError::Task(error)) => return Err(error.text),
            Err(WorkError::Output(error)) => return Err(error.to_string()),
        };
        Ok(DrawnTask { key: begun.key.to_string(), outputs, warnings })
    })
}
