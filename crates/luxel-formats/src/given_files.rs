//! Files in memory, in place of those on a disk.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Files that the caller has in memory: a model and what it refers to, by their paths. Readers take them
/// instead of files on a disk, of which they see nothing then. Clones share the bytes.
///
/// ```
/// # #[cfg(feature = "obj")] {
/// use luxel_formats::{GivenFiles, Limits, open};
/// use std::path::Path;
///
/// let files = GivenFiles::new([
///     ("part/part.obj", b"mtllib part.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec()),
///     ("part/part.mtl", b"newmtl red\nKd 1 0 0\n".to_vec()),
/// ]);
/// let limits = Limits { given: Some(files), ..Limits::default() };
/// let model = open(Path::new("part/part.obj"), &limits).unwrap();
/// assert_eq!(model.scene.materials[0].constants.diffuse, [1.0, 0.0, 0.0]);
/// # }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GivenFiles(Arc<BTreeMap<PathBuf, Vec<u8>>>);

impl GivenFiles {
    /// Files by their paths. Of two with the same path the later one counts.
    pub fn new<P: Into<PathBuf>>(files: impl IntoIterator<Item = (P, Vec<u8>)>) -> Self {
        let files = files.into_iter().map(|(path, bytes)| (path.into(), bytes));
        Self(Arc::new(files.collect()))
    }

    /// The bytes of a file.
    #[must_use]
    pub fn get(&self, path: &Path) -> Option<&[u8]> {
        self.0.get(path).map(Vec::as_slice)
    }
}
