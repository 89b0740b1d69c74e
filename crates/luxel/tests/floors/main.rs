//! Imports run one way: from crates and modules that stand later to those that stand earlier.
//!
//! [`CRATES`] orders the crates, [`MODULES`] the top modules of each. The test reads every path in
//! `src` that begins with `crate` or `super`, in `use` lines and elsewhere, tests included. A name
//! that `lib.rs` re-exports counts as an import of the module that defines it.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod order;

use order::{CRATES, MODULES};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Imports that run against the order nevertheless: crate, importing file, imported module.
const EXCEPTIONS: &[(&str, &str, &str)] = &[];

#[test]
fn no_crate_depends_on_a_later_one() {
    let members: BTreeSet<String> = fs::read_dir(crates_folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|folder| folder.join("Cargo.toml").exists())
        .map(|folder| folder.file_name().unwrap().to_str().unwrap().to_owned())
        .collect();
    let listed: BTreeSet<String> = CRATES.iter().map(|&name| name.to_owned()).collect();
    assert_eq!(listed, members, "CRATES (left) lists the crates of the workspace (right)");

    let mut faults = Vec::new();
    for (place, name) in CRATES.iter().enumerate() {
        let manifest = fs::read_to_string(crates_folder().join(name).join("Cargo.toml")).unwrap();
        for dependency in dependencies(&manifest) {
            if !CRATES[..place].contains(&dependency.as_str()) {
                faults.push(format!(
                    "crates/{name}/Cargo.toml depends on crates/{dependency}/Cargo.toml, \
                     which doesn't stand before it in CRATES"
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_architecture_names_the_subject_of_every_crate() {
    let page = fs::read_to_string(crates_folder().join("../ARCHITECTURE.md")).unwrap();
    let named: BTreeSet<&str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split_once("` |"))
        .map(|(name, _)| name)
        .collect();
    assert_eq!(named, CRATES.iter().copied().collect(), "ARCHITECTURE.md names (left) CRATES");
}

#[test]
fn every_crate_has_an_order_of_modules() {
    let ordered: Vec<&str> = MODULES.iter().map(|(name, _)| *name).collect();
    assert_eq!(ordered, CRATES, "MODULES (left) orders the modules of each of CRATES (right)");
}

#[test]
fn no_module_imports_a_later_one() {
    let mut faults = Vec::new();
    let mut used_exceptions = BTreeSet::new();
    for &(name, order) in MODULES {
        let root = crates_folder().join(name).join("src");
        let sources = sources(&root);
        let modules: BTreeSet<&str> =
            sources.iter().filter_map(|source| source.module.first()).map(String::as_str).collect();
        for module in order.iter().filter(|module| !modules.contains(*module)) {
            faults.push(format!("{name}: MODULES lists {module}, which has no file in src"));
        }
        let exported = Exports::of(&sources);
        for source in sources.iter().filter(|source| !source.module.is_empty()) {
            let importer = source.module[0].as_str();
            let Some(own_place) = order.iter().position(|module| module == &importer) else {
                faults.push(format!("{name}: MODULES doesn't list {}", source.path));
                continue;
            };
            for imported in imports(source, &exported) {
                let allowed = imported == importer || order[..own_place].contains(&&*imported);
                let exception = (name, source.path.as_str(), imported.as_str());
                if let Some(exception) = EXCEPTIONS.iter().find(|known| **known == exception) {
                    used_exceptions.insert(exception);
                } else if !allowed {
                    let target = file_of(&sources, &imported);
                    faults.push(format!(
                        "crates/{name}: {} imports {target}, but {imported} doesn't stand before \
                         {importer} in MODULES",
                        source.path,
                    ));
                }
            }
        }
    }
    for exception in EXCEPTIONS.iter().filter(|exception| !used_exceptions.contains(exception)) {
        faults.push(format!("EXCEPTIONS lists {exception:?}, but there is no such import"));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn paths_are_found_wherever_they_stand() {
    let text = r##"
        //! crate::in_a_comment
        use crate::{first, second::{Name, Other as Alias}, super_duper};
        use super::super::third;
        const TEXT: &str = "crate::in_a_string";
        const RAW: &str = r#"crate::in_"a_raw_string"#;
        fn f<'a>(c: char) -> bool { c == '"' || c == '\'' || crate::fourth::f(&'a') }
        pub(crate) fn g() { $crate::in_a_macro!() }
        mod tests { use super::*; use super::super::super::fifth; }
    "##;
    let source = Source {
        path: "own/part.rs".to_owned(),
        module: vec!["own".to_owned(), "part".to_owned()],
        tokens: tokens(text),
    };
    let found = imports(&source, &Exports::default());
    let expected = ["fifth", "first", "fourth", "own", "second", "super_duper", "third"];
    assert_eq!(found.iter().map(String::as_str).collect::<Vec<_>>(), expected);
}

#[test]
fn names_that_the_root_re_exports_are_of_the_module_that_defines_them() {
    let root = Source {
        path: "lib.rs".to_owned(),
        module: Vec::new(),
        tokens: tokens("mod a; mod b; pub use a::{Name as Alias, deep::Other}; pub use b::*;"),
    };
    let user = Source {
        path: "c.rs".to_owned(),
        module: vec!["c".to_owned()],
        tokens: tokens("use crate::{Alias, Other};"),
    };
    let of_glob = Source { tokens: tokens("use crate::Unknown;"), ..user.clone() };
    let a = Source { path: "a.rs".to_owned(), module: vec!["a".to_owned()], tokens: Vec::new() };
    let b = Source { path: "b.rs".to_owned(), module: vec!["b".to_owned()], tokens: Vec::new() };
    let exported = Exports::of(&[root, user.clone(), a, b]);
    assert_eq!(imports(&user, &exported), BTreeSet::from(["a".to_owned()]));
    assert_eq!(imports(&of_glob, &exported), BTreeSet::from(["b".to_owned()]));
}

fn crates_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The crates of the workspace that a manifest lists as dependencies, but for those of tests.
fn dependencies(manifest: &str) -> Vec<String> {
    let mut section = "";
    let mut found = Vec::new();
    for line in manifest.lines() {
        if line.starts_with('[') {
            section = line.trim();
        }
        let name = line.split(['.', ' ', '=']).next().unwrap_or_default();
        let is_dependency = section.ends_with("dependencies]") && !section.contains("dev-");
        if is_dependency && (name == "luxel" || name.starts_with("luxel-")) {
            found.push(name.to_owned());
        }
    }
    found
}

/// A file of a crate.
#[derive(Clone, Debug)]
struct Source {
    /// Its path from `src`.
    path: String,
    /// Its module: nothing for the root.
    module: Vec<String>,
    tokens: Vec<String>,
}

fn sources(root: &Path) -> Vec<Source> {
    let mut all = Vec::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let from_root = path.strip_prefix(root).unwrap().with_extension("");
                let mut module: Vec<String> =
                    from_root.iter().map(|part| part.to_str().unwrap().to_owned()).collect();
                let is_root = module == ["lib"] || module == ["main"];
                if is_root || module.last().is_some_and(|last| last == "mod") {
                    module.pop();
                }
                let path_from_root = path.strip_prefix(root).unwrap().to_str().unwrap();
                all.push(Source {
                    path: format!("src/{}", path_from_root.replace('\\', "/")),
                    module,
                    tokens: tokens(&fs::read_to_string(&path).unwrap()),
                });
            }
        }
    }
    all.sort_by(|a, b| a.path.cmp(&b.path));
    all
}

/// The file of a top module, or the root's for what stands there.
fn file_of(sources: &[Source], module: &str) -> String {
    let file = sources.iter().find(|source| source.module == [module]);
    let in_folder =
        || sources.iter().find(|source| source.module.first().is_some_and(|m| m == module));
    let root = || sources.iter().find(|source| source.module.is_empty());
    file.or_else(in_folder).or_else(root).map_or_else(String::new, |source| source.path.clone())
}

/// The modules that the names of a crate's root come from.
#[derive(Debug, Default)]
struct Exports {
    modules: BTreeMap<String, String>,
    /// The module of which the root re-exports everything.
    whole: Option<String>,
    /// What other crates define.
    foreign: BTreeSet<String>,
}

impl Exports {
    fn of(sources: &[Source]) -> Self {
        let tops: BTreeSet<&String> =
            sources.iter().filter_map(|source| source.module.first()).collect();
        let mut exports = Self::default();
        for source in sources.iter().filter(|source| source.module.is_empty()) {
            for start in 0..source.tokens.len() {
                if source.tokens[start] != "use" {
                    continue;
                }
                for path in paths(&source.tokens[start + 1..]) {
                    let names =
                        path.names.iter().filter(|name| *name != "crate" && *name != "self");
                    let names: Vec<&String> = names.collect();
                    let Some((&first, last)) = names.first().zip(names.last()) else { continue };
                    let name = path.alias.clone().unwrap_or_else(|| (*last).clone());
                    if !tops.contains(first) {
                        // What a prelude repeats, the root has already.
                        if path.names[0] != "crate" {
                            exports.foreign.insert(name);
                        }
                    } else if name == "*" {
                        exports.whole = Some(first.clone());
                    } else {
                        exports.modules.insert(name, first.clone());
                    }
                }
            }
        }
        exports
    }

    /// The module that defines a name of the root.
    fn module(&self, name: &str) -> Option<String> {
        if self.foreign.contains(name) {
            return None;
        }
        let is_module =
            |name: &str| name.chars().all(|c| c.is_lowercase() || c == '_' || c.is_numeric());
        let known = self.modules.get(name).cloned();
        let whole = self.whole.clone().filter(|_| !is_module(name));
        Some(known.or(whole).unwrap_or_else(|| name.to_owned()))
    }
}

/// The top modules that a file imports, its own among them where it names it.
fn imports(source: &Source, exports: &Exports) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    // For each open brace the module that it opens, if it does.
    let mut braces: Vec<Option<String>> = Vec::new();
    let tokens = &source.tokens;
    for at in 0..tokens.len() {
        match tokens[at].as_str() {
            "{" => {
                let is_module = at >= 2 && tokens[at - 2] == "mod";
                braces.push(is_module.then(|| tokens[at - 1].clone()));
            }
            "}" => {
                braces.pop();
            }
            "crate" | "super" if at == 0 || !["$", "::"].contains(&tokens[at - 1].as_str()) => {
                let inline = braces.iter().flatten();
                let here: Vec<&String> = source.module.iter().chain(inline).collect();
                for path in paths(&tokens[at..]) {
                    let ups = path.names.iter().take_while(|name| *name == "super").count();
                    let from_root = path.names[0] == "crate";
                    let base = if from_root { 0 } else { here.len().saturating_sub(ups) };
                    let rest = path.names.get(if from_root { 1 } else { ups });
                    let top = if base > 0 {
                        Some(here[0].clone())
                    } else {
                        rest.and_then(|name| exports.module(name))
                    };
                    found.extend(top);
                }
            }
            _ => {}
        }
    }
    found
}

/// A path, and the name that it is imported by.
#[derive(Debug)]
struct ImportPath {
    names: Vec<String>,
    alias: Option<String>,
}

/// The paths that begin with the first token: several where a part of it is a group.
fn paths(tokens: &[String]) -> Vec<ImportPath> {
    let mut all = Vec::new();
    tree(tokens, 0, &[], &mut all);
    all
}

/// Reads one tree of paths, and returns where it ends.
fn tree(tokens: &[String], start: usize, before: &[String], all: &mut Vec<ImportPath>) -> usize {
    let token = |at: usize| tokens.get(at).map_or("", String::as_str);
    let mut names = before.to_vec();
    let mut at = start;
    loop {
        if token(at) == "{" {
            at += 1;
            while !["}", ";", ""].contains(&token(at)) {
                let end = tree(tokens, at, &names, all);
                // Whatever is no path is passed over.
                at = end.max(at + 1);
                if token(at) == "," {
                    at += 1;
                }
            }
            return at + 1;
        }
        let is_name =
            token(at) == "*" || token(at).starts_with(|c: char| c.is_alphabetic() || c == '_');
        if !is_name {
            break;
        }
        names.push(token(at).to_owned());
        at += 1;
        if token(at) != "::" {
            break;
        }
        at += 1;
    }
    let mut alias = None;
    if token(at) == "as" {
        alias = Some(token(at + 1).to_owned());
        at += 2;
    }
    if names.len() > before.len() {
        // `a::{self}` is `a`.
        if names.last().is_some_and(|last| last == "self") && names.len() > 1 {
            names.pop();
        }
        all.push(ImportPath { names, alias });
    }
    at
}

/// Names, `::` and single signs; without comments, strings, characters and lifetimes.
fn tokens(text: &str) -> Vec<String> {
    let chars: Vec<char> = text.chars().collect();
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let begins = |at: usize, what: &str| {
        what.chars().eq(chars[at..].iter().copied().take(what.chars().count()))
    };
    let find = |from: usize, what: &str| {
        (from..chars.len()).find(|&at| begins(at, what)).unwrap_or(chars.len())
    };
    let mut all = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        let c = chars[at];
        if begins(at, "//") {
            at = find(at, "\n");
        } else if begins(at, "/*") {
            at = find(at, "*/") + 2;
        } else if c == '"' {
            at += 1;
            while at < chars.len() && chars[at] != '"' {
                at += if chars[at] == '\\' { 2 } else { 1 };
            }
            at += 1;
        } else if c == '\'' {
            let is_escape = chars.get(at + 1) == Some(&'\\');
            if is_escape {
                at = find(at + 3, "'") + 1;
            } else if chars.get(at + 2) == Some(&'\'') {
                at += 3;
            } else {
                at += 1;
                while at < chars.len() && is_name(chars[at]) {
                    at += 1;
                }
            }
        } else if is_name(c) {
            let start = at;
            while at < chars.len() && is_name(chars[at]) {
                at += 1;
            }
            let name: String = chars[start..at].iter().collect();
            let hashes = chars[at..].iter().take_while(|&&c| c == '#').count();
            let is_raw = (name == "r" || name == "br") && chars.get(at + hashes) == Some(&'"');
            if is_raw {
                let end = format!("\"{}", "#".repeat(hashes));
                at = find(at + hashes + 1, &end) + end.len();
            } else {
                all.push(name);
            }
        } else if begins(at, "::") {
            all.push("::".to_owned());
            at += 2;
        } else {
            if !c.is_whitespace() {
                all.push(c.to_string());
            }
            at += 1;
        }
    }
    all
}
