//! Completion of a typed path: the matching folders and models. It knows no window.

use luxel::formats::Format;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// The most entries of a folder that are listed.
const MAX_ENTRIES: usize = 10_000;

/// A typed path with its completions.
#[derive(Clone, Debug, Default)]
pub(crate) struct PathCompletion {
    pub(super) text: String,
    folder: PathBuf,
    /// The folder's entries when it was last read.
    pub(super) entries: Vec<Entry>,
    /// Indices of the entries that match the text, the best first.
    pub(super) matches: Vec<usize>,
    /// The match that Enter accepts.
    pub(super) selected: Option<usize>,
    /// Why the folder can't be read, or the path can't be opened.
    pub(super) error: Option<String>,
    /// Whether the dialog has not been shown yet.
    pub(super) is_new: bool,
    /// Whether the list scrolls to the selected match.
    pub(super) scrolls_to_selected: bool,
}

/// An entry of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    name: OsString,
    /// The name as it is shown and matched.
    pub(super) text: String,
    pub(super) is_folder: bool,
}

/// The effect of Enter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Accepted {
    /// A model to open.
    Model(PathBuf),
    /// The dialog continues, perhaps in another folder.
    Continue,
}

impl PathCompletion {
    /// Starts in the folder of a file; in the working directory for demos and the standard input.
    pub(crate) fn beside(file: &OsStr) -> Self {
        let here = std::env::current_dir().unwrap_or_default();
        let is_file = file != "-" && !file.to_string_lossy().starts_with("demo:");
        let folder = Path::new(file).parent().filter(|_| is_file).map(|folder| here.join(folder));
        let mut completion = Self { is_new: true, ..Self::default() };
        completion.enter(&folder.unwrap_or(here));
        completion
    }

    /// Enters a folder.
    fn enter(&mut self, folder: &Path) {
        let mut text = folder.to_string_lossy().into_owned();
        if !text.ends_with(std::path::is_separator) {
            text.push(std::path::MAIN_SEPARATOR);
        }
        self.text = text;
        self.update();
    }

    /// The typed folder, and the beginning of a name in it.
    fn parts(&self) -> (PathBuf, &str) {
        let end = self.text.rfind(std::path::is_separator).map_or(0, |at| at + 1);
        let (folder, name) = self.text.split_at(end);
        let home = folder.strip_prefix("~/").zip(std::env::home_dir());
        let folder = home.map_or_else(|| PathBuf::from(folder), |(rest, home)| home.join(rest));
        (if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder }, name)
    }

    /// Matches the text anew, after it has changed.
    pub(super) fn update(&mut self) {
        let (folder, name) = self.parts();
        let name = name.to_lowercase();
        if folder != self.folder || self.is_new {
            let listed = entries(&folder);
            self.error = listed.as_ref().err().map(|error| {
                // The system's message without its number.
                let text = error.to_string();
                text.split(" (os error").next().unwrap_or_default().to_owned()
            });
            (self.entries, self.folder) = (listed.unwrap_or_default(), folder);
        }
        let rank = |entry: &Entry| {
            let text = entry.text.to_lowercase();
            let is_hidden = text.starts_with('.') && !name.starts_with('.') && text != "..";
            match text.find(&name) {
                _ if is_hidden => None,
                // Prefixes rank before other substrings.
                Some(at) => Some((at > 0, !entry.is_folder && name.is_empty())),
                None => None,
            }
        };
        let ranked = self.entries.iter().enumerate();
        let mut matches: Vec<_> =
            ranked.filter_map(|(at, entry)| Some((rank(entry)?, at))).collect();
        matches.sort();
        self.matches = matches.into_iter().map(|(_, at)| at).collect();
        self.selected = (!name.is_empty() && !self.matches.is_empty()).then_some(0);
        self.scrolls_to_selected = true;
    }

    /// Takes over an edit of the text. A path from the root that was pasted replaces all of the text, and
    /// one that was typed behind a separator replaces what is before it. Returns whether it did.
    pub(super) fn edited(&mut self, pasted: Option<&str>) -> bool {
        let separators =
            self.text.char_indices().rev().filter(|(_, c)| std::path::is_separator(*c));
        let mut ends = separators.map(|(at, separator)| &self.text[at + separator.len_utf8()..]);
        let typed = ends.find(|end| is_from_root(end));
        let whole = pasted.filter(|text| is_from_root(text)).or(typed).map(str::to_owned);
        let is_replaced = whole.is_some();
        if let Some(whole) = whole {
            self.text = whole;
        }
        self.update();
        is_replaced
    }

    /// Selects the next or previous match.
    pub(super) fn step(&mut self, is_down: bool) {
        let count = self.matches.len();
        if count == 0 {
            return;
        }
        self.selected = Some(match self.selected {
            None if is_down => 0,
            None => count - 1,
            Some(at) if is_down => (at + 1) % count,
            Some(at) => (at + count - 1) % count,
        });
        self.scrolls_to_selected = true;
    }

    /// Completes the text to the longest common prefix of all matches.
    pub(super) fn complete(&mut self) {
        let (_, name) = self.parts();
        let length = name.len();
        let lower = name.to_lowercase();
        let begins = |entry: &&Entry| entry.text.to_lowercase().starts_with(&lower);
        let mut prefixed = self.matches.iter().map(|at| &self.entries[*at]).filter(begins);
        let Some(first) = prefixed.next() else { return };
        let mut common: Vec<char> = first.text.chars().collect();
        let mut is_single = true;
        for entry in prefixed {
            is_single = false;
            let same = common.iter().zip(entry.text.chars());
            let same = same.take_while(|(a, b)| a.to_lowercase().eq(b.to_lowercase())).count();
            common.truncate(same);
        }
        let is_folder = first.is_folder && is_single;
        let common: String = common.into_iter().collect();
        if common.chars().count() > name.chars().count() {
            self.text.truncate(self.text.len() - length);
            self.text.push_str(&common);
        }
        if is_folder {
            self.text.push(std::path::MAIN_SEPARATOR);
        }
        self.update();
    }

    /// Accepts the selected match, or the text.
    pub(super) fn accept(&mut self) -> Accepted {
        let selected =
            self.selected.and_then(|at| self.matches.get(at)).map(|at| &self.entries[*at]);
        let path = match selected {
            Some(entry) => self.folder.join(&entry.name),
            None => {
                let (folder, name) = self.parts();
                if name.is_empty() { folder } else { folder.join(name) }
            }
        };
        if selected.is_some_and(|entry| entry.text == "..") {
            let folder = std::path::absolute(&self.folder).unwrap_or_else(|_| self.folder.clone());
            self.enter(folder.parent().unwrap_or(&folder));
            return Accepted::Continue;
        }
        if path.is_dir() {
            self.enter(&path);
            return Accepted::Continue;
        }
        if path.is_file() {
            return Accepted::Model(path);
        }
        self.error = Some("there is no such file".to_owned());
        Accepted::Continue
    }
}

/// Whether a path begins at the root, or in the user's home.
fn is_from_root(text: &str) -> bool {
    Path::new(text).is_absolute() || text.starts_with("~/")
}

/// Whether a file's extension is a model's.
fn is_model(path: &Path) -> bool {
    let ending = path.extension().and_then(OsStr::to_str);
    ending.is_some_and(|ending| ending.parse::<Format>().is_ok())
}

/// The folders and models of a folder, sorted by name, folders first, after the parent folder.
fn entries(folder: &Path) -> std::io::Result<Vec<Entry>> {
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(folder)?.take(MAX_ENTRIES) {
        let Ok(entry) = entry else { continue };
        // Links count as their targets.
        let Ok(about) = std::fs::metadata(entry.path()) else { continue };
        let name = entry.file_name();
        if about.is_dir() || (about.is_file() && is_model(Path::new(&name))) {
            let text = name.to_string_lossy().into_owned();
            entries.push(Entry { name, text, is_folder: about.is_dir() });
        }
    }
    entries.sort_by_cached_key(|entry| {
        (!entry.is_folder, entry.text.to_lowercase(), entry.name.clone())
    });
    let up = Entry { name: "..".into(), text: "..".to_owned(), is_folder: true };
    entries.insert(0, up);
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A temporary folder with models and other files.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let name = format!("luxel-opener-{name}-{}", std::process::id());
            let path = std::env::temp_dir().join(name);
            std::fs::create_dir_all(path.join("bells/deep")).unwrap();
            std::fs::create_dir_all(path.join(".hidden")).unwrap();
            for file in ["bunny.ply", "Bunting.OBJ", "cup.glb", "notes.txt", "bells/ball.stl"] {
                std::fs::write(path.join(file), "").unwrap();
            }
            Self(path)
        }

        fn completion(&self) -> PathCompletion {
            PathCompletion::beside(self.0.join("cup.glb").as_os_str())
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    fn shown(completion: &PathCompletion) -> Vec<&str> {
        completion.matches.iter().map(|at| completion.entries[*at].text.as_str()).collect()
    }

    fn type_text(completion: &mut PathCompletion, text: &str) {
        completion.text.push_str(text);
        completion.update();
    }

    #[test]
    fn folders_and_models_are_found_and_nothing_else() {
        let folder = Folder::new("found");
        let mut completion = folder.completion();
        assert_eq!(shown(&completion), ["..", "bells", "bunny.ply", "Bunting.OBJ", "cup.glb"]);
        assert_eq!(completion.selected, None);
        type_text(&mut completion, "bun");
        assert_eq!(shown(&completion), ["bunny.ply", "Bunting.OBJ"]);
        // Prefixes come before other substrings.
        completion.text.truncate(completion.text.len() - 3);
        type_text(&mut completion, "l");
        assert_eq!(shown(&completion), ["bells", "bunny.ply", "cup.glb"]);
        type_text(&mut completion, "zzz");
        assert_eq!((shown(&completion).len(), completion.selected), (0, None));
        assert_eq!(completion.accept(), Accepted::Continue);
        assert!(completion.error.is_some());
    }

    #[test]
    fn tab_completes_the_common_prefix_and_enters_a_folder() {
        let folder = Folder::new("complete");
        let mut completion = folder.completion();
        let start = completion.text.clone();
        type_text(&mut completion, "B");
        completion.complete();
        assert_eq!(completion.text, format!("{start}B"), "bells, bunny and Bunting");
        type_text(&mut completion, "u");
        completion.complete();
        assert_eq!(completion.text.to_lowercase(), format!("{start}bun").to_lowercase());
        type_text(&mut completion, "n");
        completion.complete();
        assert_eq!(completion.text, format!("{start}bunny.ply"));
        completion.text.clone_from(&start);
        type_text(&mut completion, "be");
        completion.complete();
        assert_eq!(completion.text, format!("{start}bells/"));
        assert_eq!(shown(&completion), ["..", "deep", "ball.stl"]);
    }

    #[test]
    fn a_path_from_the_root_replaces_the_text_and_other_edits_do_not() {
        let folder = Folder::new("root");
        let other = folder.0.join("bells").display().to_string();
        let start = folder.completion().text;
        let home = std::env::home_dir().unwrap_or_default();
        for (before, typed, after) in [
            (start.clone(), "/".to_owned(), "/".to_owned()),
            (start.clone(), other.clone(), other.clone()),
            ("/".to_owned(), other.clone(), other.clone()),
            (start.clone(), "~/".to_owned(), "~/".to_owned()),
            (start.clone(), "bells/".to_owned(), format!("{start}bells/")),
            (start.clone(), "be~".to_owned(), format!("{start}be~")),
        ] {
            let mut completion = folder.completion();
            completion.text = format!("{before}{typed}");
            assert_eq!(completion.edited(None), after == typed, "{before} {typed}");
            assert_eq!(completion.text, after);
        }
        let mut completion = folder.completion();
        completion.text = "~/".to_owned();
        assert!(!completion.edited(None));
        assert_eq!(completion.folder, home);
        // Pasted into the middle of a name.
        completion.text = format!("{start}cu{other}/ball.stlp");
        assert!(completion.edited(Some(&format!("{other}/ball.stl"))));
        assert_eq!(completion.accept(), Accepted::Model(folder.0.join("bells/ball.stl")));
        completion.text = format!("{start}cup.glb");
        assert!(!completion.edited(Some("p.glb")));
        assert_eq!(completion.accept(), Accepted::Model(folder.0.join("cup.glb")));
    }

    #[test]
    fn enter_opens_models_and_enters_folders_up_and_down() {
        let folder = Folder::new("enter");
        let mut completion = folder.completion();
        completion.step(true);
        completion.step(true);
        assert_eq!(completion.accept(), Accepted::Continue);
        assert_eq!(completion.folder, folder.0.join("bells"));
        completion.step(false);
        assert_eq!(completion.accept(), Accepted::Model(folder.0.join("bells/ball.stl")));
        completion.selected = Some(0);
        assert_eq!(completion.accept(), Accepted::Continue);
        assert_eq!(completion.folder, folder.0);
        type_text(&mut completion, "cup.glb");
        assert_eq!(completion.accept(), Accepted::Model(folder.0.join("cup.glb")));
        completion.text = "/there/is/no/such/folder/".to_owned();
        completion.update();
        assert!(completion.error.is_some() && shown(&completion).is_empty());
    }

    #[test]
    fn demos_start_in_the_working_directory() {
        let here = std::env::current_dir().unwrap();
        for name in ["demo:plane", "-"] {
            assert_eq!(PathCompletion::beside(OsStr::new(name)).folder, here);
        }
    }
}
