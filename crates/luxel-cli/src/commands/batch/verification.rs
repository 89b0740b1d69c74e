//! `luxel batch verify`: outputs against the manifest, and a sample drawn again.

use super::options::BatchExecution;
use super::{limits, list, list_failure, worker_line};
use crate::console::Console;
use crate::failure::Failure;
use crate::output;
use clap::Args;
use luxel_batch::{VerifyError, VerifyPlan, verify};
use serde_json::json;
use std::ffi::OsString;
use std::path::PathBuf;

/// Compare outputs with the manifest, and a random sample of tasks with what they are drawn again
///
/// On any machine the bytes are the same. Exits with status 1 if anything differs. For example: luxel batch
/// verify tasks.jsonl out --sample 20
#[derive(Args, Debug)]
pub(crate) struct VerifyOptions {
    /// The list
    tasks: OsString,

    /// The folder of outputs
    out: PathBuf,

    /// How many tasks to draw again; `all` for all of them, 0 to compare digests only
    #[arg(long, value_name = "N", default_value = "10", value_parser = sample)]
    sample: Sample,

    /// Which tasks: the same number chooses the same ones
    #[arg(long, value_name = "NUMBER", default_value = "0")]
    seed: u64,

    /// Print a JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    execution: BatchExecution,
}

/// How many tasks.
#[derive(Clone, Copy, Debug)]
enum Sample {
    All,
    Some(usize),
}

fn sample(text: &str) -> Result<Sample, String> {
    match text {
        "all" => Ok(Sample::All),
        text => text.parse().map(Sample::Some).map_err(|_| "use a whole number, or all".to_owned()),
    }
}

impl VerifyOptions {
    pub(super) fn run(self, console: Console) -> Result<(), Failure> {
        let Self { tasks, out, sample, seed, json, execution } = self;
        let list = list(&tasks)?;
        let scratch = std::env::temp_dir().join(format!("luxel-verify-{}", std::process::id()));
        let plan = VerifyPlan {
            worker: worker_line(list.folder(), &execution),
            limits: limits(&execution),
            sample: match sample {
                Sample::All => None,
                Sample::Some(count) => Some(count),
            },
            scratch: scratch.clone(),
            seed,
            out,
            list,
        };
        let verified = verify(&plan);
        let _ = std::fs::remove_dir_all(scratch);
        let (differences, drawn) = verified.map_err(|error| match error {
            VerifyError::List(error) => list_failure(&plan.list, &error),
            VerifyError::Manifest(error) => Failure::work(
                error.to_string(),
                "luxel batch writes it when all tasks of the list have been tried",
            ),
            VerifyError::Worker(error) => {
                Failure::work(format!("workers can't be used: {error}"), "")
            }
        })?;
        if json {
            let entries = differences.iter();
            let entries = entries.map(|found| json!({"place": found.place, "what": found.what}));
            output::print_json(&json!({
                "drawn": drawn,
                "differences": entries.collect::<Vec<_>>(),
            }))?;
        } else {
            for difference in &differences {
                output::print(&format!("{}: {}\n", difference.place, difference.what))?;
            }
        }
        match differences.len() {
            0 => {
                console.notice(&format!(
                    "all outputs are as the manifest says; {drawn} tasks drawn again"
                ));
                Ok(())
            }
            1 => Err(Failure::work("1 difference", "")),
            count => Err(Failure::work(format!("{count} differences"), "")),
        }
    }
}
