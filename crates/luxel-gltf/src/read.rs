//! From JSON text to a document, or to the place of what is wrong with it.

use crate::place::pointer_at;
use crate::{Asset, Document};
use serde::Deserialize;
use serde_json::error::Category;
use std::fmt;

/// Text that is not a glTF document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// What kind of fault, and where.
    pub fault: Fault,
    /// What is wrong, without the place.
    pub message: String,
}

/// What can be wrong with a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The text is not JSON.
    Syntax {
        /// The line, from 1.
        line: usize,
        /// The byte of the line, from 1; 0 for the end of the line before.
        column: usize,
        /// Whether the text ends too early.
        is_end: bool,
    },
    /// A value is of the wrong type, or is missing.
    Value {
        /// Where it stands (RFC 6901).
        pointer: String,
    },
}

impl fmt::Display for ReadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.fault {
            Fault::Syntax { line, column, .. } => {
                write!(formatter, "line {line}, column {column}: {}", self.message)
            }
            Fault::Value { pointer } => write!(formatter, "{pointer}: {}", self.message),
        }
    }
}

impl std::error::Error for ReadError {}

/// Reads a document.
///
/// # Errors
/// [`ReadError`] if the text is not JSON, or a value has the wrong type.
pub fn read(json: &[u8]) -> Result<Document, ReadError> {
    let mut deserializer = serde_json::Deserializer::from_slice(json);
    let document =
        Document::deserialize(&mut deserializer).map_err(|error| error_of(json, &error))?;
    deserializer.end().map_err(|error| syntax_error(&error))?;
    Ok(document)
}

/// The asset of a document whose other values may have other types, such as one of glTF 1.0; `None` where it has none.
#[must_use]
pub fn read_asset(json: &[u8]) -> Option<Asset> {
    #[derive(Deserialize)]
    struct Versioned {
        asset: Asset,
    }
    serde_json::from_slice(json).ok().map(|document: Versioned| document.asset)
}

/// A value of the wrong type is told by its pointer, bad syntax by its line.
fn error_of(json: &[u8], error: &serde_json::Error) -> ReadError {
    if error.classify() != Category::Data {
        return syntax_error(error);
    }
    let pointer = pointer_at(json, error.line(), error.column());
    ReadError { fault: Fault::Value { pointer }, message: message_of(error) }
}

fn syntax_error(error: &serde_json::Error) -> ReadError {
    let fault =
        Fault::Syntax { line: error.line(), column: error.column(), is_end: error.is_eof() };
    ReadError { fault, message: message_of(error) }
}

/// The message without the line and column, which the fault tells.
fn message_of(error: &serde_json::Error) -> String {
    let message = error.to_string();
    message.split(" at line ").next().unwrap_or(&message).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pointer to what is wrong with a document.
    fn pointer(json: &str) -> String {
        match read(json.as_bytes()).unwrap_err().fault {
            Fault::Value { pointer } => pointer,
            fault @ Fault::Syntax { .. } => panic!("{json}: {fault:?}"),
        }
    }

    #[test]
    fn the_pointer_leads_to_the_value_of_the_wrong_type() {
        for (json, expected) in [
            (r#"{"nodes": [{}, {"mesh": "first"}]}"#, "/nodes/1/mesh"),
            (r#"{"nodes": [{"mesh": -1}]}"#, "/nodes/0/mesh"),
            (r#"{"nodes": [{"mesh": []}]}"#, "/nodes/0/mesh"),
            ("{\"nodes\": [{\"mesh\"  :\n  {\"a\": [1]}}]}", "/nodes/0/mesh"),
            (r#"{"nodes": {}}"#, "/nodes"),
            (r#"{"nodes": [{"translation": [1, 2, null]}]}"#, "/nodes/0/translation/2"),
            (r#"{"nodes": [{"translation": [1, 2]}]}"#, "/nodes/0/translation"),
            ("7", ""),
        ] {
            assert_eq!(pointer(json), expected, "{json}");
        }
    }

    #[test]
    fn a_missing_value_is_the_fault_of_its_object_and_so_is_a_key_given_twice() {
        assert_eq!(pointer(r#"{"asset": {"generator": "a \" }"}}"#), "/asset");
        assert_eq!(pointer(r#"{"scenes": [{"nodes": [], "nodes": []}]}"#), "/scenes/0");
    }

    #[test]
    fn keys_are_escaped_and_strings_hold_any_bracket() {
        let json =
            r#"{"extras": "]}\\", "meshes": [{"primitives": [{"attributes": {"\"A/~": "x"}}]}]}"#;
        assert_eq!(pointer(json), "/meshes/0/primitives/0/attributes/\"A~1~0");
    }
}
