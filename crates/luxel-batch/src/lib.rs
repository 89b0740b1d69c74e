//! Long lists of tasks over worker processes. Knows nothing of rendering.

#![forbid(unsafe_code)]

mod digest;
mod merkle;
mod task;
mod work;

pub use digest::{Digest, NotADigest};
pub use merkle::root;
pub use task::{KeyInput, TaskError, canonical, id_of, key, keys_of};
pub use work::{Begun, DrawnFile, Finished, Input, Work, WorkError};
