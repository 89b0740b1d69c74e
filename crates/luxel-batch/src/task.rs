//! A task of the list: its id, the text that its name by content is made of, and the name.

use crate::Digest;
use serde::Deserialize;
use serde_json::{Map, Value};

/// What goes before the parts of a key, so that it equals no other digest.
const KEY_DOMAIN: &[u8] = b"luxel batch task\n";

/// Why a task failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TaskError {
    /// What is wrong, where, and what to do.
    pub text: String,
    /// Whether the line of the list is wrong, which then is its place.
    pub is_in_list: bool,
}

impl TaskError {
    /// An error in the line of the list.
    pub fn in_list(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_in_list: true }
    }

    /// An error of the work that the line asks for.
    pub fn of_work(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_in_list: false }
    }
}

/// The part of a task that the list needs; all else is only checked to be JSON.
#[derive(Deserialize)]
struct Head {
    #[serde(default)]
    id: Option<Value>,
}

/// The id of a task.
///
/// # Errors
/// [`TaskError`] if the line is not a JSON object with a string `id`.
pub fn id_of(line: &str) -> Result<String, TaskError> {
    if !line.trim_start().starts_with('{') {
        return Err(TaskError::in_list("a task is a JSON object: {\"id\": .., \"model\": ..}"));
    }
    match serde_json::from_str(line).map_err(|error| syntax_error(&error))? {
        Head { id: Some(Value::String(id)) } => Ok(id),
        Head { id: None } => Err(TaskError::in_list("`id` is missing: give each task its own")),
        Head { id: Some(other) } => {
            Err(TaskError::in_list(format!("`id` is {other}: it must be a string")))
        }
    }
}

/// The keys and values of a task.
///
/// # Errors
/// [`TaskError`] if the line is not a JSON object.
pub fn keys_of(line: &str) -> Result<Map<String, Value>, TaskError> {
    match serde_json::from_str(line).map_err(|error| syntax_error(&error))? {
        Value::Object(keys) => Ok(keys),
        _ => Err(TaskError::in_list("a task is a JSON object: {\"id\": .., \"model\": ..}")),
    }
}

fn syntax_error(error: &serde_json::Error) -> TaskError {
    let text = error.to_string();
    let what = text.split(" at line ").next().unwrap_or(&text);
    TaskError::in_list(format!("not JSON at column {}: {what}", error.column()))
}

/// A task without what doesn't affect the outputs, `id` and `model`, as one text: keys sorted, with
/// hyphens, no blanks.
#[must_use]
pub fn canonical(task: &Map<String, Value>) -> String {
    let kept = task.iter().filter(|(key, _)| !matches!(key.as_str(), "id" | "model"));
    let kept: Map<_, _> = kept.map(|(key, value)| (key.clone(), value.clone())).collect();
    sorted(&Value::Object(kept)).to_string()
}

/// The value with sorted keys, whether or not maps keep the order of insertion.
fn sorted(value: &Value) -> Value {
    match value {
        Value::Object(map) => {
            let mut keys: Vec<_> =
                map.iter().map(|(key, value)| (key.replace('_', "-"), sorted(value))).collect();
            keys.sort_by(|(one, _), (other, _)| one.cmp(other));
            Value::Object(keys.into_iter().collect())
        }
        Value::Array(values) => Value::Array(values.iter().map(sorted).collect()),
        one => one.clone(),
    }
}

/// A file that outputs are made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyInput {
    /// Its part in the task: the name by which the model refers to it.
    pub name: String,
    /// Its digest; `None` if it isn't there.
    pub digest: Option<Digest>,
}

/// The name by content of a task's outputs: the same program makes the same bytes of the same key.
///
/// It is the digest of the program's version, the canonical task, and the name and digest of each input,
/// each preceded by its length.
#[must_use]
pub fn key(version: &str, canonical: &str, inputs: &[KeyInput]) -> Digest {
    let mut text = KEY_DOMAIN.to_vec();
    let mut add = |part: &[u8]| {
        text.extend_from_slice(&(part.len() as u64).to_le_bytes());
        text.extend_from_slice(part);
    };
    add(version.as_bytes());
    add(canonical.as_bytes());
    for KeyInput { name, digest } in inputs {
        add(name.as_bytes());
        add(digest.as_ref().map_or(&[], |digest| digest.as_bytes()));
    }
    Digest::of(&text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_lines_are_refused_with_their_place() {
        for (line, expected) in [
            ("", "JSON object"),
            ("[1]", "JSON object"),
            ("7", "JSON object"),
            ("{\"id\": \"a\"", "column 10: EOF"),
            ("{\"id\": \"a\", \"size\": 1 2}", "column 23: expected `,` or `}`"),
            ("{\"id\": \"a\"} x", "column 13: trailing"),
            ("{\"model\": \"a\"}", "`id` is missing"),
            ("{\"id\": 7}", "`id` is 7: it must be a string"),
            ("{\"id\": \"a\", \"id\": \"b\"}", "duplicate field `id`"),
        ] {
            let error = id_of(line).unwrap_err();
            assert!(error.is_in_list && error.text.contains(expected), "{line}: {}", error.text);
        }
        assert_eq!(id_of(" {\"model\": {\"deep\": []}, \"id\": \"\\u00e4\"} ").unwrap(), "ä");
    }

    #[test]
    fn a_key_depends_on_what_is_drawn_and_on_nothing_else() {
        let key_of = |line: &str, digest: Option<Digest>| {
            let inputs = [KeyInput { name: "model".into(), digest }];
            key("1", &canonical(&keys_of(line).unwrap()), &inputs)
        };
        let model = Some(Digest::of(b"model"));
        let one = key_of(r#"{"id":"a","model":"a.glb","view_matrix":[1],"size":"8x8"}"#, model);
        let same =
            key_of(r#"{"size": "8x8", "id": "b", "view-matrix": [1], "model": "b.glb"}"#, model);
        assert_eq!(one, same);
        for (line, digest) in [
            (r#"{"id":"a","model":"a.glb","view_matrix":[1],"size":"8x9"}"#, model),
            (r#"{"id":"a","model":"a.glb","view_matrix":[1],"size":"8x8"}"#, None),
            (r#"{"id":"a","model":"a.glb","size":"8x8"}"#, model),
        ] {
            assert_ne!(key_of(line, digest), one, "{line}");
        }
        assert_ne!(key("1", "{}", &[]), key("2", "{}", &[]));
    }
}
