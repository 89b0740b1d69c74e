//! The files that can be looked at, and whether the one that is has changed: without a window.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Files in their order, which of them was asked for last, and which is seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Files {
    names: Vec<OsString>,
    asked: usize,
    seen: usize,
}

impl Files {
    /// With the first of them asked for.
    pub(crate) fn new(names: Vec<OsString>) -> Self {
        Self { names, asked: 0, seen: 0 }
    }

    /// The file that was asked for last.
    pub(crate) fn asked(&self) -> &OsStr {
        self.names.get(self.asked).map_or(OsStr::new(""), OsString::as_os_str)
    }

    /// The file that is seen.
    pub(crate) fn seen(&self) -> &OsStr {
        self.names.get(self.seen).map_or(OsStr::new(""), OsString::as_os_str)
    }

    /// What was asked for is seen.
    pub(crate) fn arrived(&mut self) {
        self.seen = self.asked;
    }

    /// What is seen is asked for again.
    pub(crate) fn again(&mut self) {
        self.asked = self.seen;
    }

    /// Asks for the next file, or the one before, round and round; whether there is one.
    pub(crate) fn step(&mut self, is_forward: bool) -> bool {
        let count = self.names.len();
        if count < 2 {
            return false;
        }
        self.asked = (self.asked + if is_forward { 1 } else { count - 1 }) % count;
        true
    }

    /// Asks for another file, behind the one that was asked for; for its old place, if it has one.
    pub(crate) fn add(&mut self, name: OsString) {
        if let Some(at) = self.names.iter().position(|one| *one == name) {
            self.asked = at;
            return;
        }
        let place = (self.asked + 1).min(self.names.len());
        self.names.insert(place, name);
        if self.seen >= place {
            self.seen += 1;
        }
        self.asked = place;
    }

    /// How many the file is of how many, if there are several.
    pub(crate) fn place(&self) -> Option<[usize; 2]> {
        (self.names.len() > 1).then_some([self.seen + 1, self.names.len()])
    }

    /// What a file is called in the window's title.
    pub(crate) fn title(name: &OsStr) -> String {
        part(name, Path::file_name)
    }

    /// The beginning of the names of its pictures.
    pub(crate) fn stem(name: &OsStr) -> String {
        part(name, Path::file_stem)
    }
}

/// The scene that is shown where no file is named, and what it is called: by what is seen.
pub(crate) const WELCOME: (&str, &str) = ("demo:welcome", "teapot");

fn part(name: &OsStr, of: fn(&Path) -> Option<&OsStr>) -> String {
    let name = name.to_string_lossy();
    let name = if name == WELCOME.0 { WELCOME.1.into() } else { name };
    let file = name.strip_prefix("demo:").unwrap_or(&name);
    of(Path::new(file)).unwrap_or("model".as_ref()).to_string_lossy().into_owned()
}

/// When a file was written, and how long it is.
pub(crate) type Stamp = (SystemTime, u64);

/// Finds out when a file has become another one, by looking again and again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watch {
    path: Option<PathBuf>,
    known: Option<Stamp>,
    /// What is new, but may still be being written.
    changing: Option<Stamp>,
}

impl Watch {
    /// Of a file as it is now. What the program holds itself does not change.
    pub(crate) fn of(name: &OsStr) -> Self {
        let is_file = name != "-" && !name.to_string_lossy().starts_with("demo:");
        let path = is_file.then(|| PathBuf::from(name));
        let known = path.as_deref().and_then(stamp);
        Self { path, known, changing: None }
    }

    /// Whether there is anything to look at.
    pub(crate) fn is_needed(&self) -> bool {
        self.path.is_some()
    }

    /// Looks; whether the file is another one than it was, and completely there.
    pub(crate) fn look(&mut self) -> bool {
        let now = self.path.as_deref().and_then(stamp);
        self.learn(now)
    }

    fn learn(&mut self, now: Option<Stamp>) -> bool {
        // A file that is not there is often about to be replaced by another.
        let is_new = now.is_some() && now != self.known;
        // Seen twice alike: whoever writes it has come to an end.
        let is_whole = is_new && now == self.changing;
        if is_whole {
            self.known = now;
        }
        self.changing = if is_new && !is_whole { now } else { None };
        is_whole
    }
}

fn stamp(path: &Path) -> Option<Stamp> {
    let about = std::fs::metadata(path).ok()?;
    Some((about.modified().ok()?, about.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    fn files(names: &[&str]) -> Files {
        Files::new(names.iter().map(OsString::from).collect())
    }

    #[test]
    fn next_and_previous_go_round_and_one_file_has_neither() {
        let mut three = files(&["a", "b", "c"]);
        assert!(three.step(false));
        assert_eq!((three.asked(), three.seen()), (OsStr::new("c"), OsStr::new("a")));
        assert!(three.step(true) && three.step(true));
        three.arrived();
        assert_eq!((three.seen(), three.place()), (OsStr::new("b"), Some([2, 3])));
        let mut one = files(&["a"]);
        assert!(!one.step(true));
        assert_eq!(one.place(), None);
    }

    #[test]
    fn a_file_that_cannot_be_read_is_passed_by() {
        let mut three = files(&["a", "broken", "c"]);
        three.step(true);
        // It never arrives; what is seen is still what was seen.
        assert_eq!(three.seen(), OsStr::new("a"));
        three.step(true);
        three.arrived();
        assert_eq!(three.seen(), OsStr::new("c"));
    }

    #[test]
    fn a_file_that_is_dropped_comes_next_and_only_once() {
        let mut two = files(&["a", "b"]);
        two.add("new".into());
        two.add("newer".into());
        assert_eq!((two.asked(), two.seen()), (OsStr::new("newer"), OsStr::new("a")));
        two.arrived();
        assert_eq!(two.place(), Some([3, 4]));
        two.add("a".into());
        two.arrived();
        assert_eq!((two.seen(), two.place()), (OsStr::new("a"), Some([1, 4])));
        two.add("between".into());
        assert_eq!(two.seen(), OsStr::new("a"));
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
            assert_eq!((Files::title(name), Files::stem(name)), (title.into(), stem.into()));
        }
    }

    #[test]
    fn a_file_is_another_one_when_it_is_written_and_not_while() {
        let at =
            |second, length| Some((SystemTime::UNIX_EPOCH + Duration::from_secs(second), length));
        let mut watch = Watch { known: at(1, 10), ..Watch::default() };
        let looks = [
            (at(1, 10), false),
            (at(2, 3), false),
            (at(2, 7), false),
            (None, false),
            (at(2, 12), false),
            (at(2, 12), true),
            (at(2, 12), false),
            (at(3, 12), false),
            (at(3, 12), true),
            // Put back at once to what is shown.
            (at(4, 1), false),
            (at(3, 12), false),
            (at(3, 12), false),
        ];
        for (step, (now, expected)) in looks.into_iter().enumerate() {
            assert_eq!(watch.learn(now), expected, "look {step}");
        }
    }
}
