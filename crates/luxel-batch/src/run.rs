//! A run of a list: what is whole is kept, the rest is drawn, and the manifest written.

use crate::answer::{Answer, Done, Failed};
use crate::crew::{Limits, Seat};
use crate::list::{Line, List};
use crate::log::{self, Entry, Log};
use crate::manifest::{FailedTask, Listed, ManifestWriter};
use crate::shards::{Shards, Taken};
use crate::{Digest, Input, Output, id_of};
use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufReader};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, mpsc};
use std::time::UNIX_EPOCH;

/// A part of a list, for arrays of jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    /// Which one, below the count.
    pub number: u32,
    /// How many there are.
    pub count: u32,
}

impl Share {
    /// Whether a task is in it: by its id, so that it stays there when the list grows.
    fn holds(self, id: &str) -> bool {
        let [a, b, c, d, e, f, g, h, ..] = *Digest::of(id.as_bytes()).as_bytes();
        let number = u64::from_be_bytes([a, b, c, d, e, f, g, h]);
        number % u64::from(self.count) == u64::from(self.number)
    }
}

/// What is to be done.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The tasks.
    pub list: List,
    /// The folder of outputs, log and manifest.
    pub out: PathBuf,
    /// The line that starts a worker, which calls [`serve`](crate::serve); the folder of outputs and the one for unfinished
    /// files follow.
    pub worker: Vec<OsString>,
    /// How many workers there are at a time.
    pub workers: usize,
    /// How tasks are tried.
    pub limits: Limits,
    /// The part of the list to draw; `None` for all of it.
    pub share: Option<Share>,
    /// Whether outputs go into archives, and the size of each.
    pub archive_size: Option<u64>,
    /// The program's version: what another one drew is drawn again.
    pub version: String,
}

/// What happens during a run.
#[derive(Debug)]
pub enum Event<'e> {
    /// The list has been read.
    Begun {
        /// Tasks to look at.
        tasks: u64,
        /// Those that earlier runs have drawn.
        whole: u64,
    },
    /// A task is drawn.
    Drawn {
        /// Its id.
        id: &'e str,
        /// The number of its outputs.
        outputs: usize,
    },
    /// A task failed.
    Failed {
        /// Its id, as far as its line has one.
        id: Option<&'e str>,
        /// Why.
        error: &'e str,
    },
}

/// What a run has done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Tasks of the list.
    pub tasks: u64,
    /// Those that earlier runs had drawn.
    pub whole: u64,
    /// Those that this run has drawn.
    pub drawn: u64,
    /// Those that failed.
    pub failed: u64,
    /// The manifest and its root; `None` if the run was stopped before the end.
    pub manifest: Option<(PathBuf, Digest)>,
}

/// Why a run ends early.
#[derive(Debug)]
pub enum RunError {
    /// The list can't be read.
    List(io::Error),
    /// The folder can't be used.
    Out(io::Error),
    /// Workers can't be started.
    Worker(io::Error),
}

/// What is known of a task of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// Another share draws it.
    Elsewhere,
    /// The line is wrong: the number of its error.
    Broken(u32),
    /// It is to be drawn.
    Open,
    /// A log has its outputs, at this place.
    Known { log: u16, place: u64 },
}

/// Draws a list, until it is done or `stop` is set; `watch` is told what happens.
///
/// # Errors
/// [`RunError`]; what has been drawn until then is kept.
pub fn run(
    plan: &Plan,
    stop: &AtomicBool,
    watch: &mut dyn FnMut(&Event<'_>),
) -> Result<Summary, RunError> {
    let in_out = |path: &Path, error: io::Error| {
        RunError::Out(io::Error::new(error.kind(), format!("{}: {error}", path.display())))
    };
    fs::create_dir_all(&plan.out).map_err(|error| in_out(&plan.out, error))?;
    let (log_name, manifest_name, name) = match plan.share {
        None => ("log.jsonl".to_owned(), "manifest.json".to_owned(), String::new()),
        Some(Share { number, count }) => {
            let name = format!("-{number}-of-{count}");
            (format!("log{name}.jsonl"), format!("manifest{name}.json"), name)
        }
    };
    let log_path = plan.out.join(&log_name);
    let mut log = Log::open(&log_path).map_err(|error| in_out(&log_path, error))?;
    // Nobody else uses this folder: the log is locked.
    let parts = plan.out.join(format!(".parts{name}"));
    let _ = fs::remove_dir_all(&parts);
    fs::create_dir_all(&parts).map_err(|error| in_out(&parts, error))?;

    let logs = log::logs_in(&plan.out).map_err(|error| in_out(&plan.out, error))?;
    let own = logs.iter().position(|path| *path == log_path).unwrap_or_default() as u16;
    let mut known: HashMap<[u8; 16], (u16, u64)> = HashMap::new();
    let mut ends: HashMap<String, u64> = HashMap::new();
    let mut taken = Taken::new();
    let mut archives: HashSet<Arc<str>> = HashSet::new();
    for (number, path) in logs.iter().enumerate() {
        let read = log::read(path, |place, entry| {
            if let Some((archive, end)) = entry.shard {
                if let (Some(_), Answer::Done(done)) = (plan.archive_size, &entry.answer) {
                    let name = archives.get(&*archive).cloned().unwrap_or_else(|| {
                        let name = Arc::from(&*archive);
                        archives.insert(Arc::clone(&name));
                        name
                    });
                    taken.insert(done.key.short(), (name, end));
                }
                let known = ends.entry(archive).or_default();
                *known = end.max(*known);
            }
            match entry.answer {
                Answer::Done(_) => known.insert(entry.task.short(), (number as u16, place)),
                Answer::Failed(_) => None,
            };
        });
        read.map_err(|error| in_out(path, error))?;
    }
    let mut logs: Vec<BufReader<File>> = logs
        .iter()
        .map(|path| File::open(path).map(BufReader::new).map_err(|error| in_out(path, error)))
        .collect::<Result<_, _>>()?;
    let mut shards = match plan.archive_size {
        Some(size) => {
            let prefix = format!("outputs{name}-");
            let shards = Shards::new(&plan.out, prefix, size, &ends, taken);
            Some(shards.map_err(|error| in_out(&plan.out, error))?)
        }
        None => None,
    };

    let folder = plan.list.folder();
    let list_name = plan.list.name();
    let mut broken: Vec<FailedTask> = Vec::new();
    let mut states: Vec<State> = Vec::new();
    let mut ids: HashSet<[u8; 16]> = HashSet::new();
    for line in plan.list.lines().map_err(RunError::List)? {
        let line = line.map_err(RunError::List)?;
        let number = line.0;
        let state = match read_head(&line, &mut ids) {
            Err((id, error)) => {
                broken.push(FailedTask { id, error: format!("{list_name}:{number}: {error}") });
                State::Broken(broken.len() as u32 - 1)
            }
            Ok((id, _)) if plan.share.is_some_and(|share| !share.holds(&id)) => State::Elsewhere,
            Ok((_, text)) => match known.get(&task_digest(text, &plan.version).short()) {
                Some(&(log, place)) => State::Known { log, place },
                None => State::Open,
            },
        };
        states.push(state);
    }
    drop(ids);
    drop(known);
    for state in &mut states {
        if let State::Known { log, place } = *state {
            let entry = log::entry_at(&mut logs[usize::from(log)], place);
            let is_whole = entry.is_ok_and(|entry| is_whole(&entry, &plan.out, &folder, &ends));
            if !is_whole {
                *state = State::Open;
            }
        }
    }
    let count =
        |wanted: fn(&State) -> bool| states.iter().filter(|state| wanted(state)).count() as u64;
    let mut summary = Summary {
        tasks: count(|state| *state != State::Elsewhere),
        whole: count(|state| matches!(state, State::Known { .. })),
        drawn: 0,
        failed: 0,
        manifest: None,
    };
    watch(&Event::Begun { tasks: summary.tasks, whole: summary.whole });
    for task in &broken {
        summary.failed += 1;
        watch(&Event::Failed { id: task.id.as_deref(), error: &task.error });
    }

    let mut errors: HashMap<usize, FailedTask> = HashMap::new();
    // Outputs of archives lie aside until they are moved in.
    let root = if shards.is_some() { parts.join("outputs") } else { plan.out.clone() };
    let failure = draw_open(plan, &mut states, stop, &root, &parts, &mut |drawn, states| {
        let Drawn { index, number, id, text, answer } = drawn;
        let mut entry = Entry { task: task_digest(&text, &plan.version), id, answer, shard: None };
        match &mut entry.answer {
            Answer::Done(done) => {
                if let Some(shards) = &mut shards {
                    let place = shards.take(&root, &done.key, &mut done.outputs);
                    entry.shard = Some(place.map_err(|error| in_out(&plan.out, error))?);
                }
                summary.drawn += 1;
                watch(&Event::Drawn { id: &entry.id, outputs: done.outputs.len() });
            }
            Answer::Failed(Failed { error, is_in_list }) => {
                if *is_in_list {
                    *error = format!("{list_name}:{number}: {error}");
                }
                summary.failed += 1;
                watch(&Event::Failed { id: Some(&entry.id), error });
                let failed = FailedTask { id: Some(entry.id.clone()), error: error.clone() };
                errors.insert(index, failed);
            }
        }
        let place = log.append(&entry).map_err(|error| in_out(&log_path, error))?;
        if matches!(entry.answer, Answer::Done(_)) {
            states[index] = State::Known { log: own, place };
        }
        Ok(())
    })
    .err();
    if let Some(shards) = shards {
        shards.finish().map_err(|error| in_out(&plan.out, error))?;
    }
    if let Some(failure) = failure {
        return Err(failure);
    }
    let is_left =
        |(index, state): (usize, &State)| *state == State::Open && !errors.contains_key(&index);
    if !states.iter().enumerate().any(is_left) {
        let target = plan.out.join(manifest_name);
        let written = write_manifest(&states, &mut logs, broken, errors, &parts, &target);
        summary.manifest = Some((target.clone(), written.map_err(|error| in_out(&target, error))?));
    }
    let _ = fs::remove_dir_all(&parts);
    Ok(summary)
}

/// The id and the text of a line, or what is wrong with it.
fn read_head<'l>(
    (_, text): &'l Line,
    ids: &mut HashSet<[u8; 16]>,
) -> Result<(String, &'l str), (Option<String>, String)> {
    let text = text.as_deref().map_err(|error| (None, error.to_owned()))?;
    let id = id_of(text).map_err(|error| (None, error.text))?;
    if !ids.insert(Digest::of(id.as_bytes()).short()) {
        let error = format!("the id `{id}` is there twice: give each task its own");
        return Err((Some(id), error));
    }
    Ok((id, text))
}

/// What a task is found by in logs.
fn task_digest(text: &str, version: &str) -> Digest {
    Digest::of_parts(&[version.as_bytes(), b"\n", text.as_bytes()])
}

/// A task that a worker has answered.
struct Drawn {
    index: usize,
    number: u64,
    id: String,
    text: String,
    answer: Answer,
}

/// A task on its way to a worker: its place in the list, the line's number, and its text.
type Task = (usize, u64, String);

/// What takes an answered task and marks its state.
type Take<'t> = dyn FnMut(Drawn, &mut [State]) -> Result<(), RunError> + 't;

/// Has all open tasks drawn, and gives what becomes of them to `take`.
fn draw_open(
    plan: &Plan,
    states: &mut [State],
    stop: &AtomicBool,
    root: &Path,
    parts: &Path,
    take: &mut Take<'_>,
) -> Result<(), RunError> {
    let open: Vec<bool> = states.iter().map(|state| *state == State::Open).collect();
    let count = open.iter().filter(|open| **open).count();
    if count == 0 {
        return Ok(());
    }
    let workers = plan.workers.clamp(1, count);
    let mut line = plan.worker.clone();
    line.extend([root.into(), parts.into()]);
    let (give, tasks) = mpsc::sync_channel::<Task>(workers);
    let tasks = Mutex::new(tasks);
    let (done, answers) = mpsc::sync_channel(2 * workers);
    let halt = AtomicBool::new(false);
    let is_over = || stop.load(Ordering::Relaxed) || halt.load(Ordering::Relaxed);
    std::thread::scope(|scope| {
        let (is_over, tasks, open) = (&is_over, &tasks, &open);
        let lister = scope.spawn(move || -> io::Result<()> {
            for (index, task) in plan.list.lines()?.enumerate() {
                let (number, text) = task?;
                if is_over() {
                    break;
                }
                // A list that has grown meanwhile has tasks for the next run.
                if let (Some(true), Ok(text)) = (open.get(index), text)
                    && give.send((index, number, text)).is_err()
                {
                    break;
                }
            }
            Ok(())
        });
        for _ in 0..workers {
            let (done, line) = (done.clone(), line.clone());
            scope.spawn(move || {
                let mut seat = Seat::new(line, plan.limits.clone());
                loop {
                    let next = tasks.lock().unwrap_or_else(PoisonError::into_inner).recv();
                    let Ok((index, number, text)) = next else { return };
                    if is_over() {
                        continue;
                    }
                    let drawn = seat.draw(&text).map(|answer| {
                        let id = id_of(&text).unwrap_or_default();
                        Drawn { index, number, id, text, answer }
                    });
                    if done.send(drawn).is_err() {
                        return;
                    }
                }
            });
        }
        drop(done);
        let mut failure = None;
        for drawn in answers {
            let taken = match drawn {
                Ok(drawn) => take(drawn, states),
                Err(error) => Err(RunError::Worker(error)),
            };
            if let (Err(error), None) = (taken, &failure) {
                // Nothing more is begun; what is at work ends, unlogged.
                halt.store(true, Ordering::Relaxed);
                failure = Some(error);
            }
        }
        let listed = lister.join().unwrap_or(Ok(()));
        match failure {
            Some(error) => Err(error),
            None => listed.map_err(RunError::List),
        }
    })
}

/// Whether the outputs of an entry are there, and its inputs still those that they were made of.
fn is_whole(entry: &Entry, out: &Path, folder: &Path, ends: &HashMap<String, u64>) -> bool {
    let Answer::Done(Done { inputs, outputs, .. }) = &entry.answer else { return false };
    let is_same = |input: &Input| Input::of(folder, &input.path) == *input;
    let length = |path: &Path| fs::metadata(path).ok().map(|metadata| metadata.len());
    let is_there = |output: &Output| length(&out.join(&output.path)) == Some(output.bytes);
    let are_there = match &entry.shard {
        Some((archive, end)) => {
            ends.contains_key(archive) && length(&out.join(archive)).is_some_and(|has| has >= *end)
        }
        None => outputs.iter().all(is_there),
    };
    inputs.iter().all(is_same) && are_there
}

impl Input {
    /// A file as it is now; its path is relative to a folder, or absolute.
    #[must_use]
    pub fn of(folder: &Path, path: &str) -> Self {
        let metadata = fs::metadata(folder.join(path)).ok();
        let since = |time: std::time::SystemTime| {
            let nanoseconds = time.duration_since(UNIX_EPOCH).ok()?.as_nanos();
            i64::try_from(nanoseconds).ok()
        };
        Self {
            path: path.to_owned(),
            bytes: metadata.as_ref().map(fs::Metadata::len),
            mtime: metadata.and_then(|of| since(of.modified().ok()?)),
        }
    }
}

fn write_manifest(
    states: &[State],
    logs: &mut [BufReader<File>],
    mut broken: Vec<FailedTask>,
    mut errors: HashMap<usize, FailedTask>,
    parts: &Path,
    target: &Path,
) -> io::Result<Digest> {
    let mut manifest = ManifestWriter::new(&parts.join("outputs.part"))?;
    for (index, state) in states.iter().enumerate() {
        match *state {
            State::Elsewhere => {}
            State::Broken(number) => {
                let task = FailedTask { id: None, error: String::new() };
                manifest.failed(std::mem::replace(&mut broken[number as usize], task));
            }
            State::Open => {
                if let Some(failed) = errors.remove(&index) {
                    manifest.failed(failed);
                }
            }
            State::Known { log, place } => {
                let entry = log::entry_at(&mut logs[usize::from(log)], place)?;
                let Answer::Done(Done { outputs, .. }) = entry.answer else { continue };
                for Output { view, name, layer, path, sha256, .. } in outputs {
                    let task = entry.id.clone();
                    manifest.output(&Listed { task, view, name, layer, path, sha256 })?;
                }
            }
        }
    }
    let (root, ..) = manifest.finish(&parts.join("manifest.part"), target)?;
    Ok(root)
}
