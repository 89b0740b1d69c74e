//! Warnings of readers.

use crate::{ErrorKind, Hint};
use std::fmt;

/// A part of a file that was left out or replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Warning {
    /// The message, with the place in the file.
    pub message: String,
    /// A remedy that the message leaves out.
    pub hint: Option<Hint>,
}

impl Warning {
    /// Prefixes the place or the file.
    #[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
    pub(crate) fn at(self, place: impl fmt::Display) -> Self {
        let message = format!("{place}: {}", self.message);
        Self { message, ..self }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

/// Compares the message.
impl PartialEq<&str> for Warning {
    fn eq(&self, message: &&str) -> bool {
        self.message == *message
    }
}

impl From<String> for Warning {
    fn from(message: String) -> Self {
        Self { message, hint: None }
    }
}

impl From<&str> for Warning {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}

impl From<ErrorKind> for Warning {
    fn from(kind: ErrorKind) -> Self {
        Self { message: kind.to_string(), hint: kind.hint() }
    }
}

/// Maximum number of warnings: a file may have a million faults.
const MOST: usize = 64;

/// Collects warnings.
#[derive(Debug, Default)]
pub(crate) struct Warnings {
    list: Vec<Warning>,
    dropped: u64,
}

impl Warnings {
    /// Adds a warning unless the list has it.
    pub(crate) fn push(&mut self, warning: impl Into<Warning>) {
        let warning = warning.into();
        if self.list.contains(&warning) {
            return;
        }
        if self.list.len() < MOST {
            self.list.push(warning);
        } else {
            self.dropped += 1;
        }
    }

    /// All warnings; the last one counts those beyond the limit.
    pub(crate) fn finish(mut self) -> Vec<Warning> {
        if self.dropped > 0 {
            self.list.push(format!("{} more warnings", self.dropped).into());
        }
        self.list
    }
}

/// One warning for all faces that can't be drawn.
#[cfg(any(feature = "obj", feature = "ply", feature = "stl"))]
pub(crate) fn warn_of_faces_left_out(count: u64, warnings: &mut Warnings) {
    match count {
        0 => {}
        1 => warnings.push("1 face with a corner that is not finite was left out".to_owned()),
        _ => warnings.push(format!("{count} faces with a corner that is not finite were left out")),
    }
}
