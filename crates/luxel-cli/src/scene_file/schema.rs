//! The JSON schema of scene files, generated from the tables of keys and options.

use super::flags;
use crate::flag_words::about;
use clap::{Arg, ArgAction, Command};
use luxel::formats::{Key, Section, Shape, sections};
use serde_json::{Map, Value, json};

/// The schema (JSON Schema, draft 2020-12), for editors that check TOML.
pub(crate) fn schema(render: &Command) -> Value {
    let [root, tables @ ..] = sections();
    let mut properties = properties_of(root);
    for section in tables {
        let table = table_of(section);
        let value = if section.repeated {
            json!({ "type": "array", "items": table, "description": about(section) })
        } else {
            table
        };
        properties.insert(section.name.to_owned(), value);
    }
    let settings: Map<String, Value> = flags::keys(render)
        .filter_map(|arg| Some((arg.get_long()?.to_owned(), value_of_flag(arg))))
        .collect();
    properties.insert(
        "render".to_owned(),
        json!({
            "type": "object",
            "description": "Flags of `luxel render`; the command line overrides them",
            "properties": settings,
            "additionalProperties": false,
        }),
    );
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "luxel scene file, version 1",
        "type": "object",
        "properties": properties,
        "required": required_of(root),
        "additionalProperties": false,
    })
}

fn table_of(section: &Section) -> Value {
    json!({
        "type": "object",
        "description": about(section),
        "properties": properties_of(section),
        "required": required_of(section),
        "additionalProperties": false,
    })
}

fn required_of(section: &Section) -> Vec<&'static str> {
    section.keys.iter().filter(|key| key.required).map(|key| key.name).collect()
}

fn properties_of(section: &Section) -> Map<String, Value> {
    let property = |key: &Key| {
        let mut value = value_of(key.shape);
        value["description"] = json!(key.about);
        (key.name.to_owned(), value)
    };
    section.keys.iter().map(property).collect()
}

fn value_of(shape: Shape) -> Value {
    match shape {
        Shape::Exactly(text) => json!({ "const": text }),
        Shape::One => json!({ "const": 1 }),
        Shape::Text => json!({ "type": "string" }),
        Shape::Choice(texts) => json!({ "enum": texts }),
        Shape::Number => number(),
        Shape::Numbers(count) => any_of(&[numbers(count, count), text()]),
        Shape::ThreeOrFour => any_of(&[numbers(3, 4), text()]),
        Shape::NumbersOr(texts) => any_of(&[numbers(3, 3), json!({ "enum": texts }), text()]),
        Shape::OneOrThree => any_of(&[json!({ "type": "number" }), numbers(3, 3), text()]),
        Shape::Switch => json!({ "type": "boolean" }),
        Shape::Node => {
            let list = json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 });
            any_of(&[text(), list])
        }
        Shape::Table(section) => table_of(section),
    }
}

fn any_of(values: &[Value]) -> Value {
    json!({ "anyOf": values })
}

fn text() -> Value {
    json!({ "type": "string" })
}

fn number() -> Value {
    json!({ "type": ["number", "string"] })
}

fn numbers(least: usize, most: usize) -> Value {
    json!({
        "type": "array",
        "items": { "type": "number" },
        "minItems": least,
        "maxItems": most,
    })
}

/// The schema of the value of a flag.
fn value_of_flag(arg: &Arg) -> Value {
    let mut value = if matches!(arg.get_action(), ArgAction::SetTrue) {
        json!({ "type": "boolean" })
    } else {
        let choices: Vec<_> =
            arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
        let one = if choices.is_empty() {
            json!({ "type": ["number", "string"] })
        } else {
            json!({ "enum": choices })
        };
        let name = arg.get_value_names().and_then(<[_]>::first).map_or("", |name| name.as_str());
        let list = json!({ "type": "array", "items": { "type": ["number", "string"] } });
        let may_lack_value = arg.get_num_args().is_some_and(|count| count.min_values() == 0);
        if may_lack_value {
            any_of(&[one, json!({ "type": "boolean" })])
        } else if matches!(arg.get_action(), ArgAction::Append) || name.contains(',') {
            any_of(&[one, list])
        } else {
            one
        }
    };
    value["description"] = json!(help_of(arg));
    value
}

/// The help of a flag, in one line.
pub(crate) fn help_of(arg: &Arg) -> String {
    let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
    let mut help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    let default = arg.get_default_values().first().map(|value| value.to_string_lossy());
    if let Some(default) = default.filter(|_| !help.contains("[default:") && takes_value(arg)) {
        help.push_str(&format!(" [default: {default}]"));
    }
    help
}

fn takes_value(arg: &Arg) -> bool {
    !matches!(arg.get_action(), ArgAction::SetTrue)
}
