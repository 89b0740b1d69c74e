//! The file of key bindings, if there is one.

use crate::failure::Failure;
use luxel_viewer::Keys;
use std::ffi::OsStr;
use std::io::Read;
use std::path::{Path, PathBuf};

/// More than any table of keys takes.
const MOST_BYTES: u64 = 1 << 20;

/// The bindings of a file, or of the user's own; the default ones without either.
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

/// The user's own file, as the XDG base directory specification has it: an empty or relative folder
/// counts as none.
fn own_file(
    config: Option<impl Into<PathBuf>>,
    home: Option<impl Into<PathBuf>>,
) -> Option<PathBuf> {
    let config = config.map(Into::into).filter(|folder: &PathBuf| folder.is_absolute());
    let folder = config.or_else(|| Some(home?.into().join(".config")))?;
    Some(folder.join("luxel").join("keys.toml"))
}

fn read(path: &Path) -> Result<Keys, Failure> {
    let remedy = "correct the line; docs/viewer.md lists what keys can do";
    let invalid = |what: String| Failure::work(format!("{}{what}", path.display()), remedy);
    let mut text = String::new();
    let opened = std::fs::File::open(path);
    let taken = opened.and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text));
    match taken {
        Err(error) => {
            let what = format!("{}: {error}", path.display());
            Err(Failure::work(what, "name a file of keys, as docs/viewer.md describes it"))
        }
        Ok(taken) if taken as u64 > MOST_BYTES => {
            Err(invalid(": this is too long for keys".to_owned()))
        }
        Ok(_) => Keys::read(&text).map_err(|error| invalid(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_user_s_own_file_is_where_the_specification_has_it() {
        let of = |config: Option<&str>, home: Option<&str>| own_file(config, home);
        let at = |path: &str| Some(PathBuf::from(path));
        assert_eq!(of(Some("/c"), Some("/h")), at("/c/luxel/keys.toml"));
        assert_eq!(of(Some(""), Some("/h")), at("/h/.config/luxel/keys.toml"));
        assert_eq!(of(Some("relative"), Some("/h")), at("/h/.config/luxel/keys.toml"));
        assert_eq!(of(None, None), None);
    }
}
