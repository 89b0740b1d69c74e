//! Long lists of tasks over worker processes. Knows nothing of rendering.
//!
//! A [`Plan`] names the list and the folder; [`run`] draws what isn't there. Workers are processes that call [`serve`]
//! with what draws a task ([`Work`]). Outputs are named by the content of what they are made of ([`key`]), a log
//! knows which are whole, and a [`Manifest`] ends with their [`root`].

#![forbid(unsafe_code)]

mod answer;
mod crew;
mod digest;
mod list;
mod log;
mod manifest;
mod merkle;
mod run;
mod shards;
mod store;
mod task;
mod verify;
mod work;
mod worker;

pub use crew::{Limits, Seat};
pub use digest::{Digest, NotADigest};
pub use list::List;
pub use manifest::{FailedTask, Listed, MANIFEST_VERSION, Manifest};
pub use merkle::root;
pub use run::{Event, Plan, RunError, Share, Summary, run};
pub use store::{Output, path_of};
pub use task::{KeyInput, TaskError, canonical, id_of, key, keys_of};
pub use verify::{Difference, VerifyError, VerifyPlan, verify};
pub use work::{Begun, DrawnFile, Finished, Input, Work, WorkError};
pub use worker::{limit_memory, serve};
