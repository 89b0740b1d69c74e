//! The manifest: what there is of a list, and the digest of it all.

use crate::{Digest, root};
use serde::{Deserialize, Serialize};
use std::collections::HashSet;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// The version of the manifest's format.
pub const MANIFEST_VERSION: u32 = 1;

/// A manifest.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// The version of the format.
    pub version: u32,
    /// The root of the Merkle tree over the sorted digests of all outputs.
    pub root: Digest,
    /// The outputs, in the order of the list, of views and of layers.
    pub outputs: Vec<Listed>,
    /// The tasks that failed, in the order of the list.
    pub failed: Vec<FailedTask>,
}

/// An output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Listed {
    /// The id of its task.
    pub task: String,
    /// The number of the view, from 0.
    pub view: u32,
    /// The view's name, if it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The layer.
    pub layer: String,
    /// Where it is, below the folder of outputs.
    pub path: String,
    /// The digest of its bytes.
    pub sha256: Digest,
}

/// A task without outputs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FailedTask {
    /// Its id, as far as its line has one.
    pub id: Option<String>,
    /// Why.
    pub error: String,
}

impl Manifest {
    /// The root that the outputs have.
    #[must_use]
    pub fn root_of_outputs(&self) -> Digest {
        root(self.outputs.iter().map(|output| output.sha256))
    }

    /// The ids of the tasks with outputs, in order.
    #[must_use]
    pub fn drawn_tasks(&self) -> Vec<&str> {
        let mut seen = HashSet::new();
        let ids = self.outputs.iter().map(|output| output.task.as_str());
        ids.filter(|id| seen.insert(*id)).collect()
    }
}

/// Writes a manifest entry by entry, so that long ones take no memory but their digests.
pub(crate) struct ManifestWriter {
    body: BufWriter<File>,
    digests: Vec<Digest>,
    failed: Vec<FailedTask>,
}

impl ManifestWriter {
    /// Begins with the outputs, in a file of their own: the root stands before them, and is known last.
    pub(crate) fn new(body: &Path) -> io::Result<Self> {
        let body = File::options().read(true).write(true).create(true).truncate(true).open(body)?;
        Ok(Self { body: BufWriter::new(body), digests: Vec::new(), failed: Vec::new() })
    }

    pub(crate) fn output(&mut self, output: &Listed) -> io::Result<()> {
        let separator: &[u8] = if self.digests.is_empty() { b"\n" } else { b",\n" };
        self.body.write_all(separator)?;
        serde_json::to_writer(&mut self.body, output)?;
        self.digests.push(output.sha256);
        Ok(())
    }

    pub(crate) fn failed(&mut self, failed: FailedTask) {
        self.failed.push(failed);
    }

    /// Writes the manifest; its root, and the numbers of outputs and of failed tasks.
    pub(crate) fn finish(self, part: &Path, target: &Path) -> io::Result<(Digest, usize, usize)> {
        use std::io::{Seek, SeekFrom, copy};
        let Self { body, digests, failed } = self;
        let mut body = body.into_inner().map_err(io::IntoInnerError::into_error)?;
        let outputs = digests.len();
        let root = root(digests);
        let mut file = BufWriter::new(File::create(part)?);
        write!(file, "{{\"version\":{MANIFEST_VERSION},\"root\":\"{root}\",\"outputs\":[")?;
        body.seek(SeekFrom::Start(0))?;
        copy(&mut body, &mut file)?;
        file.write_all(b"],\"failed\":[")?;
        for (number, task) in failed.iter().enumerate() {
            file.write_all(if number == 0 { b"\n" } else { b",\n" })?;
            serde_json::to_writer(&mut file, task)?;
        }
        file.write_all(b"]}\n")?;
        file.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
        std::fs::rename(part, target)?;
        Ok((root, outputs, failed.len()))
    }
}
