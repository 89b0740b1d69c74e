//! What each exported name does.

use crate::registry::{Prototype, Registry};
use crate::variants::Family;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt;

/// `commands.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Commands {
    /// Commands that do nothing and set no error.
    silent: Vec<String>,
    /// Commands that programs find by name alone, as in Mesa's library.
    unexported: Vec<String>,
    file: Vec<File>,
}

/// The commands of one generated file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    title: String,
    #[serde(default)]
    variants: Vec<Family>,
    /// By name, the expression that carries the command out; `gl` is the context.
    #[serde(default)]
    commands: BTreeMap<String, String>,
}

/// How a command is carried out.
pub enum Action {
    /// By an expression.
    Expression(String),
    /// As another command.
    Alias(String),
    /// Not at all: it sets GL_INVALID_OPERATION.
    Unsupported,
    /// Not at all, and without an error.
    Silent,
}

/// A command.
pub struct Entry {
    /// Its name.
    pub name: String,
    /// Whether the library exports it.
    pub is_exported: bool,
    /// Its prototype.
    pub prototype: Prototype,
    /// What it does.
    pub action: Action,
}

/// A generated file and its entries, sorted by name.
pub struct Room {
    /// The file's name without extension.
    pub name: String,
    /// What it holds.
    pub title: String,
    /// Its commands.
    pub entries: Vec<Entry>,
}

/// All generated files.
pub struct Plan {
    /// The files.
    pub rooms: Vec<Room>,
    /// All names, sorted.
    pub names: Vec<String>,
    /// How many of them are exported.
    exported: usize,
    /// Commands of OpenGL 1.5 and their aliases that are not carried out.
    pub missing: Vec<String>,
    variants: usize,
}

impl Plan {
    /// Sorts the names that are `exported`, and those that aren't, into files by `commands.toml`.
    pub fn make(registry: &Registry, exported: &[String], commands: &str) -> Result<Self, String> {
        let commands: Commands =
            toml::from_str(commands).map_err(|error| format!("commands.toml: {error}"))?;
        let mut names = [exported, &commands.unexported].concat();
        names.sort_unstable();
        let mut calls = BTreeMap::new();
        let mut variants = 0;
        let mut rooms: Vec<Room> = Vec::new();
        for (place, file) in commands.file.into_iter().enumerate() {
            let mut own: Vec<(String, String)> = file.commands.into_iter().collect();
            for family in &file.variants {
                let members = family.members(|name| registry.prototype(name))?;
                variants += members.len();
                own.extend(members);
            }
            for (name, call) in own {
                if !names.contains(&name) {
                    return Err(format!("commands.toml: {name} is not among the names"));
                }
                if calls.insert(name.clone(), (place, call)).is_some() {
                    return Err(format!("commands.toml: {name} stands there twice"));
                }
            }
            rooms.push(Room { name: file.name, title: file.title, entries: Vec::new() });
        }
        let unsupported = rooms.len();
        rooms.push(Room {
            name: "unsupported".to_owned(),
            title: "Commands of later versions and other extensions".to_owned(),
            entries: Vec::new(),
        });
        let pending = rooms.len();
        rooms.push(Room {
            name: "pending".to_owned(),
            title: "Commands of OpenGL 1.5 and of framebuffer objects that are not carried out yet"
                .to_owned(),
            entries: Vec::new(),
        });
        let mut missing = Vec::new();
        for name in &names {
            let prototype = registry.prototype(name)?.clone();
            let target = registry.resolve(name, |name| calls.contains_key(name));
            let (place, action) = match target {
                Some(target) if &target == name => {
                    let (place, call) = &calls[name];
                    (*place, Action::Expression(call.clone()))
                }
                Some(target) => (calls[&target].0, Action::Alias(target)),
                None if commands.silent.contains(name) => (unsupported, Action::Silent),
                None => {
                    let core = registry.resolve(name, |name| registry.is_core(name)).is_some();
                    if core || is_of_framebuffer_objects(name) {
                        missing.push(name.clone());
                        (pending, Action::Unsupported)
                    } else {
                        (unsupported, Action::Unsupported)
                    }
                }
            };
            let is_exported = !commands.unexported.contains(name);
            rooms[place].entries.push(Entry { name: name.clone(), is_exported, prototype, action });
        }
        rooms.retain(|room| !room.entries.is_empty());
        Ok(Self { rooms, names, exported: exported.len(), missing, variants })
    }
}

/// Whether `name` comes with `GL_ARB_framebuffer_object` or `GL_EXT_framebuffer_object`, `_blit`, `_multisample`.
fn is_of_framebuffer_objects(name: &str) -> bool {
    let name = name.trim_end_matches("EXT");
    name == "glGenerateMipmap"
        || name == "glBlitFramebuffer"
        || name.starts_with("glRenderbufferStorage")
        || (["Framebuffer", "Renderbuffer"].iter().any(|word| name.contains(word))
            && !["Invalidate", "FramebufferParameteri"].iter().any(|word| name.contains(word))
            && name != "glFramebufferTexture")
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |wanted: fn(&Action) -> bool| {
            self.rooms
                .iter()
                .flat_map(|room| &room.entries)
                .filter(|entry| wanted(&entry.action))
                .count()
        };
        write!(
            f,
            "{} names, {} of them exported: {} commands ({} of them variants by type and width), {} aliases, {} without effect, \
             {} unsupported, {} of OpenGL 1.5 and framebuffer objects among these",
            self.names.len(),
            self.exported,
            count(|action| matches!(action, Action::Expression(_))),
            self.variants,
            count(|action| matches!(action, Action::Alias(_))),
            count(|action| matches!(action, Action::Silent)),
            count(|action| matches!(action, Action::Unsupported)),
            self.missing.len(),
        )
    }
}
