//! What goes with a path that is being typed: the folders and models that it may become. Without a
//! window; the dialog is `opener/dialog.rs`.

mod dialog;

pub(crate) use dialog::{Answer, dialog};
use luxel::formats::Format;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// Entries of a folder that are looked at: more can't be chosen from.
const MOST: usize = 10_000;

/// A path that is being typed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Opener {
    text: String,
    /// What the folder held when it was last looked at.
    folder: PathBuf,
    entries: Vec<Entry>,
    /// Those of the entries that go with what is typed, the best first.
    found: Vec<usize>,
    /// The one of those that Enter takes.
    chosen: Option<usize>,
    /// Why there is nothing to be seen.
    trouble: Option<String>,
    /// Whether it has not been shown yet.
    is_new: bool,
    /// Whether the chosen entry is to be scrolled to.
    is_moved: bool,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Entry {
    name: OsString,
    /// As it is shown and searched.
    text: String,
    is_folder: bool,
}

/// What comes of Enter.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Taken {
    /// A model to be opened.
    Model(PathBuf),
    /// Another folder, or nothing, is looked at.
    Nothing,
}

impl Opener {
    /// In the folder of a file; in the one that the program was started in, if it is no file.
    pub(crate) fn beside(file: &OsStr) -> Self {
        let here = std::env::current_dir().unwrap_or_default();
        let is_file = file != "-" && !file.to_string_lossy().starts_with("demo:");
        let folder = Path::new(file).parent().filter(|_| is_file).map(|folder| here.join(folder));
        let mut opener = Self { is_new: true, ..Self::default() };
        opener.enter(&folder.unwrap_or(here));
        opener
    }

    /// Goes into a folder.
    fn enter(&mut self, folder: &Path) {
        let mut text = folder.to_string_lossy().into_owned();
        if !text.ends_with(std::path::is_separator) {
            text.push(std::path::MAIN_SEPARATOR);
        }
        self.text = text;
        self.typed();
    }

    /// The folder that is typed, and the beginning of a name in it.
    fn parts(&self) -> (PathBuf, &str) {
        let end = self.text.rfind(std::path::is_separator).map_or(0, |at| at + 1);
        let (folder, name) = self.text.split_at(end);
        let home = folder.strip_prefix("~/").zip(std::env::home_dir());
        let folder = home.map_or_else(|| PathBuf::from(folder), |(rest, home)| home.join(rest));
        (if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder }, name)
    }

    /// Something else is typed than before.
    fn typed(&mut self) {
        let (folder, name) = self.parts();
        let name = name.to_lowercase();
        if folder != self.folder || self.is_new {
            let looked = entries(&folder);
            self.trouble = looked.as_ref().err().map(|error| {
                // The system's words, without its number.
                let text = error.to_string();
                text.split(" (os error").next().unwrap_or_default().to_owned()
            });
            (self.entries, self.folder) = (looked.unwrap_or_default(), folder);
        }
        let rank = |entry: &Entry| {
            let text = entry.text.to_lowercase();
            let is_hidden = text.starts_with('.') && !name.starts_with('.') && text != "..";
            match text.find(&name) {
                _ if is_hidden => None,
                // What is typed begins it, or is within it.
                Some(at) => Some((at > 0, !entry.is_folder && name.is_empty())),
                None => None,
            }
        };
        let ranked = self.entries.iter().enumerate();
        let mut found: Vec<_> = ranked.filter_map(|(at, entry)| Some((rank(entry)?, at))).collect();
        found.sort();
        self.found = found.into_iter().map(|(_, at)| at).collect();
        self.chosen = (!name.is_empty() && !self.found.is_empty()).then_some(0);
        self.is_moved = true;
    }

    /// Chooses the next entry, or the one before.
    fn step(&mut self, is_down: bool) {
        let count = self.found.len();
        if count == 0 {
            return;
        }
        self.chosen = Some(match self.chosen {
            None if is_down => 0,
            None => count - 1,
            Some(at) if is_down => (at + 1) % count,
            Some(at) => (at + count - 1) % count,
        });
        self.is_moved = true;
    }

    /// Goes on with what all that is found begins with.
    fn complete(&mut self) {
        let (_, name) = self.parts();
        let length = name.len();
        let lower = name.to_lowercase();
        let begins = |entry: &&Entry| entry.text.to_lowercase().starts_with(&lower);
        let mut fitting = self.found.iter().map(|at| &self.entries[*at]).filter(begins);
        let Some(first) = fitting.next() else { return };
        let mut common: Vec<char> = first.text.chars().collect();
        let mut is_alone = true;
        for entry in fitting {
            is_alone = false;
            let same = common.iter().zip(entry.text.chars());
            let same = same.take_while(|(a, b)| a.to_lowercase().eq(b.to_lowercase())).count();
            common.truncate(same);
        }
        let is_folder = first.is_folder && is_alone;
        let common: String = common.into_iter().collect();
        if common.chars().count() > name.chars().count() {
            self.text.truncate(self.text.len() - length);
            self.text.push_str(&common);
        }
        if is_folder {
            self.text.push(std::path::MAIN_SEPARATOR);
        }
        self.typed();
    }

    /// Takes the chosen entry, or what is typed.
    fn take(&mut self) -> Taken {
        let chosen = self.chosen.and_then(|at| self.found.get(at)).map(|at| &self.entries[*at]);
        let path = match chosen {
            Some(entry) => self.folder.join(&entry.name),
            None => {
                let (folder, name) = self.parts();
                if name.is_empty() { folder } else { folder.join(name) }
            }
        };
        if chosen.is_some_and(|entry| entry.text == "..") {
            let folder = std::path::absolute(&self.folder).unwrap_or_else(|_| self.folder.clone());
            self.enter(folder.parent().unwrap_or(&folder));
            return Taken::Nothing;
        }
        if path.is_dir() {
            self.enter(&path);
            return Taken::Nothing;
        }
        if path.is_file() {
            return Taken::Model(path);
        }
        self.trouble = Some("there is no such file".to_owned());
        Taken::Nothing
    }
}

/// Whether a file's name is that of a model.
fn is_model(path: &Path) -> bool {
    let ending = path.extension().and_then(OsStr::to_str);
    ending.is_some_and(|ending| ending.parse::<Format>().is_ok())
}

/// The folders and models of a folder, folders first, by name; the way up before them.
fn entries(folder: &Path) -> std::io::Result<Vec<Entry>> {
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(folder)?.take(MOST) {
        let Ok(entry) = entry else { continue };
        // What a link leads to counts.
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

    /// A folder with models and other things in it, gone at the end.
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

        fn opener(&self) -> Opener {
            Opener::beside(self.0.join("cup.glb").as_os_str())
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    fn shown(opener: &Opener) -> Vec<&str> {
        opener.found.iter().map(|at| opener.entries[*at].text.as_str()).collect()
    }

    fn type_text(opener: &mut Opener, text: &str) {
        opener.text.push_str(text);
        opener.typed();
    }

    #[test]
    fn folders_and_models_are_found_and_nothing_else() {
        let folder = Folder::new("found");
        let mut opener = folder.opener();
        assert_eq!(shown(&opener), ["..", "bells", "bunny.ply", "Bunting.OBJ", "cup.glb"]);
        assert_eq!(opener.chosen, None);
        type_text(&mut opener, "bun");
        assert_eq!(shown(&opener), ["bunny.ply", "Bunting.OBJ"]);
        // What it begins with comes before what has it within.
        opener.text.truncate(opener.text.len() - 3);
        type_text(&mut opener, "l");
        assert_eq!(shown(&opener), ["bells", "bunny.ply", "cup.glb"]);
        type_text(&mut opener, "zzz");
        assert_eq!((shown(&opener).len(), opener.chosen), (0, None));
        assert_eq!(opener.take(), Taken::Nothing);
        assert!(opener.trouble.is_some());
    }

    #[test]
    fn tab_goes_as_far_as_names_agree_and_into_a_folder() {
        let folder = Folder::new("complete");
        let mut opener = folder.opener();
        let start = opener.text.clone();
        type_text(&mut opener, "B");
        opener.complete();
        assert_eq!(opener.text, format!("{start}B"), "bells, bunny and Bunting");
        type_text(&mut opener, "u");
        opener.complete();
        assert_eq!(opener.text.to_lowercase(), format!("{start}bun").to_lowercase());
        type_text(&mut opener, "n");
        opener.complete();
        assert_eq!(opener.text, format!("{start}bunny.ply"));
        opener.text.clone_from(&start);
        type_text(&mut opener, "be");
        opener.complete();
        assert_eq!(opener.text, format!("{start}bells/"));
        assert_eq!(shown(&opener), ["..", "deep", "ball.stl"]);
    }

    #[test]
    fn enter_opens_models_and_walks_folders_up_and_down() {
        let folder = Folder::new("enter");
        let mut opener = folder.opener();
        opener.step(true);
        opener.step(true);
        assert_eq!(opener.take(), Taken::Nothing);
        assert_eq!(opener.folder, folder.0.join("bells"));
        opener.step(false);
        assert_eq!(opener.take(), Taken::Model(folder.0.join("bells/ball.stl")));
        opener.chosen = Some(0);
        assert_eq!(opener.take(), Taken::Nothing);
        assert_eq!(opener.folder, folder.0);
        type_text(&mut opener, "cup.glb");
        assert_eq!(opener.take(), Taken::Model(folder.0.join("cup.glb")));
        opener.text = "/there/is/no/such/folder/".to_owned();
        opener.typed();
        assert!(opener.trouble.is_some() && shown(&opener).is_empty());
    }

    #[test]
    fn demos_have_no_folder_of_their_own() {
        let here = std::env::current_dir().unwrap();
        for name in ["demo:plane", "-"] {
            assert_eq!(Opener::beside(OsStr::new(name)).folder, here);
        }
    }
}
