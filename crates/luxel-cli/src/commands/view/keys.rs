//! The file of key bindings.

use crate::failure::Failure;
use crate::model;
use luxel_viewer::Keys;
use std::ffi::OsStr;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Maximum size of a file of key bindings.
const MOST_BYTES: u64 = 1 << 20;

/// The bindings of a file, else of the user's file, else the default ones.
///
/// # Errors
/// [`Failure::Work`] with the line, if the file can't be read or is invalid.
pub(super) fn keys(file: Option<&OsStr>) -> Result<Keys, Failure> {
    let own = own_file(std::env::var_os("XDG_CONFIG_HOME"), std::env::var_os("HOME"));
    match (file, own) {
        (Some(file), _) => read(Path::new(file)),
        (None, Some(own)) if own.exists() => read(&own),
        (None, _) => Ok(Keys::default()),
    }
}

/// The user's file by the XDG base directory specification: an empty or relative folder
/// counts as unset.
fn own_file(
    config: Option<impl Into<PathBuf>>,
    home: Option<impl Into<PathBuf>>,
) -> Option<PathBuf> {
    let config = config.map(Into::into).filter(|folder: &PathBuf| folder.is_absolute());
    let folder = config.or_else(|| Some(home?.into().join(".config")))?;
    Some(folder.join("luxel").join("keys.toml"))
}

fn read(path: &Path) -> Result<Keys, Failure> {
    let remedy = "correct the line; docs/viewer.md lists the actions of keys";
    let invalid = |what: String| Failure::work(format!("{}{what}", path.display()), remedy);
    let mut text = String::new();
    let opened = model::open_regular(path);
    let taken = opened.and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text));
    match taken {
        Err(error) => {
            let what = format!("{}: {error}", path.display());
            Err(Failure::work(what, "docs/viewer.md describes files of key bindings"))
        }
        Ok(taken) if taken as u64 > MOST_BYTES => {
            Err(invalid(": the file is too large for key bindings".to_owned()))
        }
        Ok(_) => Keys::read(&text).map_err(|error| invalid(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_key_file_follows_the_xdg_specification() {
        let of = |config: Option<&str>, home: Option<&str>| own_file(config, home);
        let at = |path: &str| Some(PathBuf::from(path));
        assert_eq!(of(Some("/c"), Some("/h")), at("/c/luxel/keys.toml"));
        assert_eq!(of(Some(""), Some("/h")), at("/h/.config/luxel/keys.toml"));
        assert_eq!(of(Some("relative"), Some("/h")), at("/h/.config/luxel/keys.toml"));
        assert_eq!(of(None, None), None);
    }
}
