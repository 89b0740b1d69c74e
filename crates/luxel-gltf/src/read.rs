//! From JSON text to a document, or to the place of what is wrong with it.

use crate::Document;
use crate::place::pointer_at;
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
