//! The tables of `docs/scene-files.md`, generated from the tables of keys and options.
//!
//! `LUXEL_BLESS=1` writes page and schema instead of comparing them, and fails.

use super::Cli;
use crate::commands;
use crate::flag_words::about;
use crate::scene_file::{flags, schema};
use clap::CommandFactory;
use luxel::formats::{Key, Section, Shape, sections};
use luxel::lighting::{REFLECTION_MODELS, ReflectionModel};
use luxel_testing::blessing;
use std::fmt::Write;
use std::path::PathBuf;

const BEGIN: &str = "<!-- keys: begin -->\n";
const END: &str = "<!-- keys: end -->\n";

fn docs(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name)
}

#[track_caller]
fn assert_is_up_to_date(name: &str, expected: &str) {
    let is = std::fs::read_to_string(docs(name)).unwrap_or_default();
    if blessing::is_blessing() && is != expected {
        std::fs::write(docs(name), expected).unwrap();
    }
    if blessing::is_blessing() {
        blessing::fail(&docs(name));
    }
    assert!(is == expected, "docs/{name} is out of date: run this test with LUXEL_BLESS=1");
}

#[test]
fn the_committed_schema_is_up_to_date() {
    assert_is_up_to_date("scene.schema.json", &commands::schema::text(Cli::command()));
}

#[test]
fn the_page_lists_every_key() {
    let page = std::fs::read_to_string(docs("scene-files.md")).unwrap();
    let (before, rest) = page.split_once(BEGIN).unwrap();
    let (_, behind) = rest.split_once(END).unwrap();
    assert_is_up_to_date("scene-files.md", &format!("{before}{BEGIN}{}{END}{behind}", tables()));
}

fn tables() -> String {
    let mut text = String::new();
    for section in sections() {
        table(section, &mut text);
    }
    let mut program = Cli::command();
    program.build();
    text.push_str(
        "\n### `[render]`\n\nFlags of `luxel render`; the command line overrides them.\n\n",
    );
    text.push_str("| key | meaning |\n| --- | --- |\n");
    for arg in flags::keys(program.find_subcommand("render").unwrap()) {
        let (name, help) = (arg.get_long().unwrap(), schema::help_of(arg).replace('|', "\\|"));
        writeln!(text, "| `{name}` | {help} |").unwrap();
    }
    models(&mut text);
    text.push('\n');
    text
}

fn models(text: &mut String) {
    text.push_str(
        "\n### Reflection models\n\nWhat `reflection` takes. `mixed:NAME=W,...` is a weighted sum of \
         them. A model's formula is what it sends to the eye of a light of intensity 1, after \
         attenuation; highlights shine where N.L > 0 only.\n\n",
    );
    text.push_str("| name | what it shows | formula | source | keys |\n");
    text.push_str("| --- | --- | --- | --- | --- |\n");
    for ReflectionModel { name, help, formula, source, parameters, own, .. } in REFLECTION_MODELS {
        let own = own.iter().map(|own| own.parameter.name);
        let keys: Vec<_> = parameters.iter().map(|parameter| parameter.name).chain(own).collect();
        let keys = keys.join("`, `");
        writeln!(text, "| `{name}` | {help} | {formula} | {source} | `{keys}` |").unwrap();
    }
}

fn table(section: &Section, text: &mut String) {
    let title = match (section.name, section.repeated) {
        ("", _) => "Top level".to_owned(),
        (name, true) => format!("`[[{name}]]`"),
        (name, false) => format!("`[{name}]`"),
    };
    write!(text, "\n### {title}\n\n{}.\n\n", about(section)).unwrap();
    text.push_str("| key | meaning | example |\n| --- | --- | --- |\n");
    for Key { name, shape, required, about, example } in section.keys {
        let mark = if *required { " (required)" } else { "" };
        writeln!(text, "| `{name}`{mark} | {about} | `{name} = {example}` |").unwrap();
        if let Shape::Table(inner) = shape {
            for key in inner.keys {
                writeln!(text, "| `{name}.{}` | {} | |", key.name, key.about).unwrap();
            }
        }
    }
}
