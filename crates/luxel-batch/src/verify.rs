//! Verification: outputs against their digests, and a sample of tasks against what is drawn again.

use crate::answer::{Answer, Done, Failed};
use crate::crew::{Limits, Seat};
use crate::list::List;
use crate::shards::digests_of_entries;
use crate::{Digest, Manifest, id_of};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What is to be verified.
#[derive(Clone, Debug)]
pub struct VerifyPlan {
    /// The tasks.
    pub list: List,
    /// The folder of outputs with its manifest.
    pub out: PathBuf,
    /// How many tasks are drawn again; `None` for all.
    pub sample: Option<usize>,
    /// Which ones: the same seed chooses the same tasks.
    pub seed: u64,
    /// The line that starts a worker, as in a plan.
    pub worker: Vec<OsString>,
    /// How tasks are tried.
    pub limits: Limits,
    /// An empty folder for what is drawn again.
    pub scratch: PathBuf,
}

/// What is not as the manifest says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Where: a path, a task, or the manifest.
    pub place: String,
    /// What.
    pub what: String,
}

/// Why nothing could be verified.
#[derive(Debug)]
pub enum VerifyError {
    /// The list can't be read.
    List(io::Error),
    /// The manifest can't be read.
    Manifest(io::Error),
    /// Workers can't be started, or their outputs can't be read.
    Worker(io::Error),
}

/// Compares the manifest with its root, all outputs with their digests, and a sample of tasks with what they are when
/// they are drawn again. The differences, and how many tasks were drawn again.
///
/// # Errors
/// [`VerifyError`]
pub fn verify(plan: &VerifyPlan) -> Result<(Vec<Difference>, usize), VerifyError> {
    let path = plan.out.join("manifest.json");
    let manifest = fs::read(&path).and_then(|bytes| Ok(serde_json::from_slice(&bytes)?));
    let manifest: Manifest = manifest.map_err(|error: io::Error| {
        VerifyError::Manifest(io::Error::new(error.kind(), format!("{}: {error}", path.display())))
    })?;
    let mut differences = Vec::new();
    let root = manifest.root_of_outputs();
    if root != manifest.root {
        let what = format!("its root is {}, but its outputs have {root}", manifest.root);
        differences.push(Difference { place: "manifest.json".to_owned(), what });
    }
    let mut digests = Digests { out: &plan.out, archives: HashMap::new() };
    for output in &manifest.outputs {
        let what = match digests.of(&output.path) {
            Ok(found) if found == output.sha256 => continue,
            Ok(found) => format!("its SHA-256 is {found}, not {}", output.sha256),
            Err(error) => error.to_string(),
        };
        differences.push(Difference { place: output.path.clone(), what });
    }
    let drawn = draw_again(plan, &manifest, &mut differences)?;
    Ok((differences, drawn))
}

/// The digests of outputs, by their paths.
struct Digests<'o> {
    out: &'o Path,
    /// Those of archives that have been read, by their names.
    archives: HashMap<String, HashMap<String, Digest>>,
}

impl Digests<'_> {
    /// The digest of an output: a file, or an entry of an archive.
    fn of(&mut self, path: &str) -> io::Result<Digest> {
        let Some((archive, entry)) = path.split_once(".tar/") else {
            return Ok(Digest::of_reader(fs::File::open(self.out.join(path))?)?.0);
        };
        let name = format!("{archive}.tar");
        if !self.archives.contains_key(&name) {
            let entries = digests_of_entries(&self.out.join(&name))?;
            self.archives.insert(name.clone(), entries);
        }
        let found = self.archives.get(&name).and_then(|entries| entries.get(entry)).copied();
        found
            .ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "the archive has no such entry"))
    }
}

fn draw_again(
    plan: &VerifyPlan,
    manifest: &Manifest,
    differences: &mut Vec<Difference>,
) -> Result<usize, VerifyError> {
    let mut ids = manifest.drawn_tasks();
    if let Some(sample) = plan.sample {
        // By the digest of seed and id: on every machine the same.
        let place = |id: &&str| Digest::of_parts(&[&plan.seed.to_le_bytes(), id.as_bytes()]);
        ids.sort_by_cached_key(place);
        ids.truncate(sample);
    }
    let chosen: HashSet<&str> = ids.iter().copied().collect();
    let mut listed: HashMap<&str, BTreeMap<(u32, &str), Vec<Digest>>> = HashMap::new();
    for output in manifest.outputs.iter().filter(|output| chosen.contains(output.task.as_str())) {
        let views = listed.entry(&output.task).or_default();
        views.entry((output.view, &output.layer)).or_default().push(output.sha256);
    }
    let parts = plan.scratch.join(".parts");
    fs::create_dir_all(&parts).map_err(VerifyError::Worker)?;
    let mut line = plan.worker.clone();
    line.extend([plan.scratch.clone().into(), parts.into()]);
    let mut seat = Seat::new(line, plan.limits.clone());
    let mut drawn = 0;
    for task in plan.list.lines().map_err(VerifyError::List)? {
        let (_, text) = task.map_err(VerifyError::List)?;
        let Ok(text) = text else { continue };
        let Ok(id) = id_of(&text) else { continue };
        let Some(expected) = listed.remove(id.as_str()) else { continue };
        drawn += 1;
        let found = match seat.draw(&text).map_err(VerifyError::Worker)? {
            Answer::Done(Done { outputs, .. }) => outputs,
            Answer::Failed(Failed { error, .. }) => {
                differences.push(Difference { place: format!("task {id}"), what: error });
                continue;
            }
        };
        let mut again: BTreeMap<(u32, &str), Vec<Digest>> = BTreeMap::new();
        for output in &found {
            again.entry((output.view, &output.layer)).or_default().push(output.sha256);
            let _ = fs::remove_file(plan.scratch.join(&output.path));
        }
        for key in expected.keys().chain(again.keys()).collect::<std::collections::BTreeSet<_>>() {
            if expected.get(key) != again.get(key) {
                let place = format!("task {id}, view {}, {}", key.0, key.1);
                let what = "drawn again, it has other bytes than the manifest says".to_owned();
                differences.push(Difference { place, what });
            }
        }
    }
    for id in listed.keys() {
        let what = "the list has no such task".to_owned();
        differences.push(Difference { place: format!("task {id}"), what });
    }
    Ok(drawn)
}
