//! The list of files that the window steps through.

use std::ffi::{OsStr, OsString};
use std::path::Path;

/// An ordered list of files, with the one requested last and the one on display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FileList {
    names: Vec<OsString>,
    requested: usize,
    shown: usize,
}

impl FileList {
    /// Starts with a request for the first file.
    pub(crate) fn new(names: Vec<OsString>) -> Self {
        Self { names, requested: 0, shown: 0 }
    }

    /// The file requested last.
    pub(crate) fn requested(&self) -> &OsStr {
        self.names.get(self.requested).map_or(OsStr::new(""), OsString::as_os_str)
    }

    /// The file on display.
    pub(crate) fn shown(&self) -> &OsStr {
        self.names.get(self.shown).map_or(OsStr::new(""), OsString::as_os_str)
    }

    /// The requested file is now on display.
    pub(crate) fn set_shown(&mut self) {
        self.shown = self.requested;
    }

    /// Requests the file on display again.
    pub(crate) fn request_shown(&mut self) {
        self.requested = self.shown;
    }

    /// Requests the next or previous file, cyclically; false if there is no other.
    pub(crate) fn step(&mut self, is_forward: bool) -> bool {
        let count = self.names.len();
        if count < 2 {
            return false;
        }
        self.requested = (self.requested + if is_forward { 1 } else { count - 1 }) % count;
        true
    }

    /// Requests another file, inserted after the last request unless the list has it already.
    pub(crate) fn add(&mut self, name: OsString) {
        if let Some(at) = self.names.iter().position(|one| *one == name) {
            self.requested = at;
            return;
        }
        let place = (self.requested + 1).min(self.names.len());
        self.names.insert(place, name);
        if self.shown >= place {
            self.shown += 1;
        }
        self.requested = place;
    }

    /// The number of the file on display and the count, if there are several.
    pub(crate) fn position(&self) -> Option<[usize; 2]> {
        (self.names.len() > 1).then_some([self.shown + 1, self.names.len()])
    }

    /// A file's name in the window's title.
    pub(crate) fn title(name: &OsStr) -> String {
        part(name, Path::file_name)
    }

    /// The stem of a file's screenshots.
    pub(crate) fn stem(name: &OsStr) -> String {
        part(name, Path::file_stem)
    }
}

/// The scene that opens without a file, and its title.
pub(crate) const WELCOME: (&str, &str) = ("demo:welcome", "teapot");

fn part(name: &OsStr, of: fn(&Path) -> Option<&OsStr>) -> String {
    let name = name.to_string_lossy();
    let name = if name == WELCOME.0 { WELCOME.1.into() } else { name };
    let file = name.strip_prefix("demo:").unwrap_or(&name);
    of(Path::new(file)).unwrap_or("model".as_ref()).to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(names: &[&str]) -> FileList {
        FileList::new(names.iter().map(OsString::from).collect())
    }

    #[test]
    fn next_and_previous_go_round_and_one_file_has_neither() {
        let mut three = files(&["a", "b", "c"]);
        assert!(three.step(false));
        assert_eq!((three.requested(), three.shown()), (OsStr::new("c"), OsStr::new("a")));
        assert!(three.step(true) && three.step(true));
        three.set_shown();
        assert_eq!((three.shown(), three.position()), (OsStr::new("b"), Some([2, 3])));
        let mut one = files(&["a"]);
        assert!(!one.step(true));
        assert_eq!(one.position(), None);
    }

    #[test]
    fn a_file_that_cannot_be_read_is_passed_by() {
        let mut three = files(&["a", "broken", "c"]);
        three.step(true);
        // It is never loaded; the first file stays on display.
        assert_eq!(three.shown(), OsStr::new("a"));
        three.step(true);
        three.set_shown();
        assert_eq!(three.shown(), OsStr::new("c"));
    }

    #[test]
    fn a_file_that_is_dropped_comes_next_and_only_once() {
        let mut two = files(&["a", "b"]);
        two.add("new".into());
        two.add("newer".into());
        assert_eq!((two.requested(), two.shown()), (OsStr::new("newer"), OsStr::new("a")));
        two.set_shown();
        assert_eq!(two.position(), Some([3, 4]));
        two.add("a".into());
        two.set_shown();
        assert_eq!((two.shown(), two.position()), (OsStr::new("a"), Some([1, 4])));
        two.add("between".into());
        assert_eq!(two.shown(), OsStr::new("a"));
    }

    #[test]
    fn titles_and_pictures_are_named_after_files_and_demos() {
        for (name, title, stem) in [
            ("models/cup.v2.glb", "cup.v2.glb", "cup.v2"),
            ("demo:plane", "plane", "plane"),
            ("demo:welcome", "teapot", "teapot"),
            ("..", "model", "model"),
        ] {
            let name = OsStr::new(name);
            assert_eq!((FileList::title(name), FileList::stem(name)), (title.into(), stem.into()));
        }
    }
}
