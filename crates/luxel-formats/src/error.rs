//! Errors with their place in the file.

use std::fmt;
use std::path::PathBuf;

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
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
    /// The place in the file.
    pub place: Place,
    /// The cause.
    #[source]
    pub kind: ErrorKind,
    /// The hint of another error whose message `kind` repeats.
    pub(crate) hint: Option<Hint>,
}

/// A remedy for an error or a warning.
///
/// Hints are data: each program words them with its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Hint {
    /// Allow more memory: [`Limits::max_memory`](crate::Limits::max_memory).
    RaiseMemoryLimit,
    /// Pass the format to [`read`](crate::read()): the name of the file has no extension.
    PassFormat,
    /// List the objects and materials of the models: the file names one that they lack.
    ListNames,
    /// Build `luxel-formats` with this cargo feature.
    EnableFeature(&'static str),
}

/// The cause of an [`Error`].
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
    /// An index is out of range.
    #[error("{what} {index} doesn't exist: there are {count}")]
    OutOfRange {
        /// The kind of item.
        what: &'static str,
        /// The index as written in the file.
        index: i64,
        /// How many there are.
        count: u64,
    },
    /// The extension of the file is not a format that luxel reads.
    #[error(transparent)]
    UnknownFormat(#[from] UnknownFormat),
    /// The file is text in UTF-16: all text formats are ASCII or UTF-8.
    #[error("the file is text in UTF-16: save it as UTF-8")]
    Utf16,
    /// The file refers to something other than a regular file in its folder or below.
    #[error("{0}")]
    Reference(String),
    /// The file needs something that luxel can't do.
    #[error("{0}")]
    Unsupported(String),
    /// This build lacks a reader that the file needs.
    #[error("{what} can't be read: luxel-formats was built without its feature `{feature}`")]
    MissingFeature {
        /// The unreadable part.
        what: String,
        /// The cargo feature that reads it.
        feature: &'static str,
    },
    /// The file needs more memory than the limits allow.
    #[error("{what} would take {needed} bytes; the limit is {limit}")]
    TooLarge {
        /// The purpose of the memory.
        what: String,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
    },
    /// [`Progress::stop`](crate::Progress::stop) was called.
    #[error("reading was cancelled")]
    Stopped,
}

/// Text that is not the name of a [`Format`](crate::Format).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownFormat {
    /// The text; empty for a file name without an extension.
    pub name: String,
}

impl fmt::Display for UnknownFormat {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name } = self;
        if name.is_empty() {
            return formatter
                .write_str("the file name has no extension, which would give the format");
        }
        write!(
            formatter,
            "`{name}` is not a format that luxel reads: use glb, gltf, obj, stl, ply or toml"
        )
    }
}

impl std::error::Error for UnknownFormat {}

impl UnknownFormat {
    /// The remedy.
    #[must_use]
    pub fn hint(&self) -> Option<Hint> {
        self.name.is_empty().then_some(Hint::PassFormat)
    }
}

impl ErrorKind {
    /// A remedy that the message leaves out.
    #[must_use]
    pub fn hint(&self) -> Option<Hint> {
        match self {
            Self::TooLarge { .. } => Some(Hint::RaiseMemoryLimit),
            Self::MissingFeature { feature, .. } => Some(Hint::EnableFeature(feature)),
            Self::UnknownFormat(unknown) => unknown.hint(),
            _ => None,
        }
    }
}

impl Error {
    /// An error at a place of the input being read; [`Error::in_file`] adds the file.
    #[must_use]
    pub const fn at(place: Place, kind: ErrorKind) -> Self {
        Self { file: None, place, kind, hint: None }
    }

    /// A remedy that the message leaves out.
    #[must_use]
    pub fn hint(&self) -> Option<Hint> {
        self.hint.or_else(|| self.kind.hint())
    }

    /// Adds the hint of another error whose message this one repeats.
    #[cfg(feature = "toml")]
    pub(crate) const fn with_hint(mut self, hint: Option<Hint>) -> Self {
        self.hint = hint;
        self
    }

    /// Names the file, unless a nested file has been named already.
    #[must_use]
    pub fn in_file(mut self, file: impl Into<PathBuf>) -> Self {
        self.file.get_or_insert_with(|| file.into());
        self
    }
}

/// The error of a build that lacks a reader.
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
