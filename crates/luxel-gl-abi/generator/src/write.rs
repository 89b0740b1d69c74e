//! The text of the generated files.

use crate::plan::{Action, Entry, Plan, Room};
use crate::registry::Prototype;
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

/// What every file begins with.
const HEAD: &str = "// Written by ../../generator from gl.xml and commands.toml: change these.\n";

/// File names and texts.
pub fn files(plan: &Plan) -> Result<Vec<(String, String)>, String> {
    let mut files = Vec::new();
    for room in &plan.rooms {
        let text = if room.entries.iter().all(|entry| is_listed(&entry.action)) {
            listed(room)
        } else {
            formatted(&commands(room)?)?
        };
        files.push((format!("{}.rs", room.name), text));
    }
    files.push(("mod.rs".to_owned(), formatted(&index(plan))?));
    files.push(("table.rs".to_owned(), table(plan)));
    Ok(files)
}

/// Whether the macro `unsupported!` or `silent!` makes the command from its prototype alone.
fn is_listed(action: &Action) -> bool {
    matches!(action, Action::Unsupported | Action::Silent)
}

/// The entry points of a file with commands that do something, and after them their aliases.
fn commands(room: &Room) -> Result<String, String> {
    let mut body = String::new();
    let mut aliases = String::new();
    for entry in &room.entries {
        match &entry.action {
            Action::Expression(call) => {
                body.push('\n');
                body.push_str(&carried_out(entry, call));
            }
            Action::Alias(target) => aliases.push_str(&alias(entry, target)),
            Action::Unsupported | Action::Silent => {
                return Err(format!("{}: {} does nothing", room.name, entry.name));
            }
        }
    }
    if !aliases.is_empty() {
        let _ = write!(body, "\naliases! {{\n{aliases}}}\n");
    }
    let mut text = format!("{HEAD}\n//! {}.\n\nuse crate::prelude::*;\n", room.title);
    for (word, path) in [("c_char", "std::ffi::c_char"), ("c_void", "std::ffi::c_void")] {
        if body.contains(word) {
            let _ = writeln!(text, "use {path};");
        }
    }
    Ok(text + &body)
}

/// The functions of `memory` and `returned` that read or write the caller's memory, and fail for null pointers.
const READERS: [&str; 10] = [
    "array",
    "few",
    "copied",
    "bytes",
    "bytes_mut",
    "caller_memory",
    "optional_bytes",
    "store",
    "store_all",
    "returned",
];

/// Whether an expression calls a function of that name, which is no method.
fn calls(expression: &str, function: &str) -> bool {
    expression.match_indices(function).any(|(at, _)| {
        let is_part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '.';
        let alone = !expression[..at].ends_with(is_part);
        alone && expression[at + function.len()..].starts_with('(')
    })
}

/// A command that an expression carries out.
fn carried_out(entry: &Entry, call: &str) -> String {
    let foreign = READERS.iter().any(|reader| calls(call, reader));
    let client = if call.contains("client.") || call.contains("client,") { "client" } else { "_" };
    let caller = if !foreign && is_frequent(&entry.name) { "call_uncaught" } else { "call" };
    let semicolon = if entry.prototype.result.is_none() { ";" } else { "" };
    let body = if foreign {
        let caller =
            if is_frequent(&entry.name) { "call_with_memory_uncaught" } else { "call_with_memory" };
        let call = match entry.prototype.result {
            Some(_) => format!("Some({call})"),
            None if call.trim_end().ends_with('}') => format!("{call}\nSome(())"),
            None => format!("{call};\nSome(())"),
        };
        format!(
            "// SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.\n    \
             {caller}(|gl, {client}| unsafe {{ {call} }}){semicolon}"
        )
    } else {
        format!("{caller}(|gl, {client}| {call}){semicolon}")
    };
    format!("{} {{\n    {body}\n}}\n", signature(entry))
}

/// Whether programs call the command for each vertex: a panic, impossible by all that is known, ends the process there.
fn is_frequent(name: &str) -> bool {
    ["glVertex", "glColor3", "glColor4", "glNormal3", "glTexCoord", "glMultiTexCoord"]
        .iter()
        .any(|start| name.starts_with(start) && !name.contains("Pointer"))
}

/// A line of `aliases!`: a command that is another one.
fn alias(entry: &Entry, target: &str) -> String {
    let unsafe_ = if takes_pointers(&entry.prototype) { "unsafe " } else { "" };
    format!("    {unsafe_}{} = {target}{};\n", entry.name, parameters_and_result(&entry.prototype))
}

fn takes_pointers(prototype: &Prototype) -> bool {
    prototype.parameters.iter().any(|parameter| parameter.kind.pointer)
}

fn signature(entry: &Entry) -> String {
    let Entry { name, is_exported, prototype, .. } = entry;
    let exported = if *is_exported { "#[unsafe(no_mangle)]\n" } else { "" };
    let unsafe_ = if takes_pointers(prototype) { "unsafe " } else { "" };
    let types = parameters_and_result(prototype);
    format!("{exported}pub(crate) {unsafe_}extern \"C\" fn {name}{types}")
}

fn parameters_and_result(prototype: &Prototype) -> String {
    let parameters: Vec<String> = prototype
        .parameters
        .iter()
        .map(|parameter| format!("{}: {}", parameter.name, parameter.kind.rust))
        .collect();
    let result =
        prototype.result.as_ref().map_or(String::new(), |kind| format!(" -> {}", kind.rust));
    format!("({}){result}", parameters.join(", "))
}

/// A file of commands that do nothing.
fn listed(room: &Room) -> String {
    let mut text = format!("{HEAD}\n//! {}.\n\n", room.title);
    let all: String =
        room.entries.iter().map(|entry| parameters_and_result(&entry.prototype)).collect();
    for (word, path) in [("c_char", "std::ffi::c_char"), ("c_void", "std::ffi::c_void")] {
        if all.contains(word) {
            let _ = writeln!(text, "use {path};");
        }
    }
    for (name, silent) in [("unsupported", false), ("silent", true)] {
        let entries: Vec<&Entry> = room
            .entries
            .iter()
            .filter(|entry| matches!(entry.action, Action::Silent) == silent)
            .collect();
        if entries.is_empty() {
            continue;
        }
        let _ = writeln!(text, "\ncrate::entry::{name}! {{");
        for entry in entries {
            let _ =
                writeln!(text, "    {}{};", entry.name, parameters_and_result(&entry.prototype));
        }
        text.push_str("}\n");
    }
    text
}

/// `mod.rs`.
fn index(plan: &Plan) -> String {
    let mut text = format!(
        "{HEAD}\n//! The entry points of OpenGL, one file for each subject, and their addresses by name.\n\n\
         #![allow(non_snake_case, reason = \"the names are OpenGL's\")]\n\
         #![allow(clippy::too_many_arguments, reason = \"the parameters are OpenGL's\")]\n\
         #![allow(clippy::semicolon_if_nothing_returned, reason = \"expressions stand as in commands.toml\")]\n\n"
    );
    let mut names: Vec<&str> = plan.rooms.iter().map(|room| room.name.as_str()).collect();
    names.push("table");
    names.sort_unstable();
    for name in &names {
        let visible = if *name == "table" { "pub(crate) " } else { "" };
        let _ = writeln!(text, "{visible}mod {name};");
    }
    text
}

/// `table.rs`: all names, sorted.
fn table(plan: &Plan) -> String {
    let mut text = format!("{HEAD}\n//! The address of each entry point by its name.\n\n");
    let mut names: Vec<&str> = plan.rooms.iter().map(|room| room.name.as_str()).collect();
    names.sort_unstable();
    for name in names {
        let _ = writeln!(text, "use super::{name}::*;");
    }
    text.push_str("use crate::entry::entries;\n\nentries! {\n");
    let mut line = "   ".to_owned();
    for name in &plan.names {
        if line.len() + 1 + name.len() > 100 {
            let _ = writeln!(text, "{line}");
            line = "   ".to_owned();
        }
        line.push(' ');
        line.push_str(name);
    }
    let _ = writeln!(text, "{line}\n}}");
    text
}

/// `text` as rustfmt writes it.
fn formatted(text: &str) -> Result<String, String> {
    let failed = |error: std::io::Error| format!("rustfmt: {error}");
    let mut child = Command::new("rustfmt")
        .args(["--edition", "2024", "--config", "max_width=100,use_small_heuristics=Max"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(failed)?;
    let mut input = child.stdin.take().ok_or("rustfmt takes no input")?;
    input.write_all(text.as_bytes()).map_err(failed)?;
    drop(input);
    let output = child.wait_with_output().map_err(failed)?;
    if !output.status.success() {
        return Err(format!("rustfmt fails on:\n{text}"));
    }
    String::from_utf8(output.stdout).map_err(|error| format!("rustfmt: {error}"))
}
