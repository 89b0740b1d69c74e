//! The corpus that fuzzing has kept, in `fuzz/corpus`: a folder a target.

use std::fs;
use std::path::Path;

/// Passes every file of a target's corpus to the target's entry, in the order of names.
///
/// # Panics
/// If the folder has no files, or if the entry panics: the last name printed is that of the file.
pub fn each_file(target: &str, entry: impl Fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    let files = fs::read_dir(&folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = files.map(|file| file.path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "{} has no files", folder.display());
    for path in paths {
        println!("{}", path.display());
        let bytes = fs::read(&path);
        assert!(bytes.is_ok(), "{}: {bytes:?}", path.display());
        entry(&bytes.unwrap_or_default());
    }
}
