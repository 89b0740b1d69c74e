//! What is wrong with a file, and where.

use std::fmt;
use std::path::PathBuf;

/// Where in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A byte, counted from 0.
    Byte(u64),
    /// A line, counted from 1.
    Line(u64),
    /// A line and a column in it, both counted from 1.
    LineColumn(u64, u64),
    /// A value in a JSON document (RFC 6901), as `/meshes/0/primitives/1`.
    Pointer(String),
}

/// An error with its place.
#[derive(Debug, thiserror::Error)]
#[error("{}{place}: {kind}", file.as_deref().map_or_else(|| "<input>".into(), |file| file.to_string_lossy()))]
pub struct Error {
    /// The file, if it isn't the standard input.
    pub file: Option<PathBuf>,
    /// Where in it.
    pub place: Place,
    /// What.
    #[source]
    pub kind: ErrorKind,
}

/// What is wrong.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The system can't read the file.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// The file breaks the rules of its format.
    #[error("{0}")]
    Malformed(String),
    /// The file ends too early.
    #[error("the file ends here, in the middle of {0}")]
    Truncated(String),
    /// A number points to something that isn't there.
    #[error("{what} {index} doesn't exist: there are {count}")]
    OutOfRange {
        /// What kind of thing.
        what: &'static str,
        /// The number as the file counts.
        index: i64,
        /// How many there are.
        count: u64,
    },
    /// The file needs something that luxel can't do.
    #[error("{0}")]
    Unsupported(String),
    /// This build lacks what reads the file.
    #[error("{what} can't be read: luxel-formats was built without its feature `{feature}`")]
    MissingFeature {
        /// What can't be read.
        what: String,
        /// The cargo feature that reads it.
        feature: &'static str,
    },
    /// The file asks for more than the limits allow.
    #[error("{what} would take {needed} bytes; the limit is {limit}: raise it with --max-memory")]
    TooLarge {
        /// What asks.
        what: String,
        /// Bytes asked for.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
    },
    /// Whoever watches the reading has stopped it.
    #[error("reading was stopped")]
    Stopped,
}

impl Error {
    /// An error at a place of the input being read; [`Error::in_file`] adds the file.
    #[must_use]
    pub const fn at(place: Place, kind: ErrorKind) -> Self {
        Self { file: None, place, kind }
    }

    /// Names the file, unless a nested file has been named already.
    #[must_use]
    pub fn in_file(mut self, file: impl Into<PathBuf>) -> Self {
        self.file.get_or_insert_with(|| file.into());
        self
    }
}

/// What a file needs, and this build lacks.
#[allow(dead_code, reason = "a build with all features lacks nothing")]
pub(crate) fn missing_feature(what: impl Into<String>, feature: &'static str) -> ErrorKind {
    ErrorKind::MissingFeature { what: what.into(), feature }
}

impl Place {
    /// The line and the column of a byte of a text, from 1; columns are counted in characters.
    #[must_use]
    pub fn in_text(text: &str, byte: usize) -> Self {
        let byte = byte.min(text.len());
        let before = text.as_bytes().get(..byte).unwrap_or_default();
        let line_start = before.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        // Bytes that go on with a character don't count.
        let column = before[line_start..].iter().filter(|&&byte| byte & 0xc0 != 0x80).count() + 1;
        Self::LineColumn(line as u64, column as u64)
    }
}

impl fmt::Display for Place {
    /// As compilers write places: nothing for the file itself, `:12` for a line, `:12:5` with a
    /// column, else in words.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Byte(byte) => write!(formatter, ": byte {byte}"),
            Self::Line(line) => write!(formatter, ":{line}"),
            Self::LineColumn(line, column) => write!(formatter, ":{line}:{column}"),
            Self::Pointer(pointer) => write!(formatter, ": {pointer}"),
        }
    }
}
