//! Failures of the program, and the exit status of each.

use crate::flag_words::error_text;
use luxel::formats::{Error, ErrorKind, Place};
use std::path::Path;
use std::process::ExitCode;

/// The status of a program that was interrupted, as shells report it: 128 and the number of the
/// signal.
pub(crate) const INTERRUPTED: u8 = 130;

/// Why the work was not done.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The flags make no sense together: status 2.
    Usage(String),
    /// The work could not be done: status 1.
    Work {
        /// What is wrong, with its place.
        what: String,
        /// The remedy; empty if `what` contains it.
        remedy: String,
    },
    /// A check has reported findings: status 3.
    Findings,
    /// The reader of the standard output has closed it: no error.
    OutputClosed,
    /// A signal has interrupted the program, which has cleaned up: status 130.
    #[cfg(feature = "viewer")]
    Interrupted,
}

impl Failure {
    /// Work that could not be done.
    pub(crate) fn work(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Work { what: what.into(), remedy: remedy.into() }
    }

    /// A file that a flag names, and that could not be written.
    pub(crate) fn writing(path: &Path, error: &std::io::Error, flag: &str) -> Self {
        Self::work(
            format!("{}: can't be written: {error}", path.display()),
            format!("choose another place with {flag}, or free the one chosen"),
        )
    }

    /// The standard output failed.
    pub(crate) fn standard_output(error: &std::io::Error) -> Self {
        if error.kind() == std::io::ErrorKind::BrokenPipe {
            Self::OutputClosed
        } else {
            Self::work(format!("standard output: {error}"), "free what it is written to")
        }
    }

    /// The status with which the program ends.
    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::Usage(_) => ExitCode::from(2),
            Self::Work { .. } => ExitCode::FAILURE,
            Self::Findings => ExitCode::from(3),
            Self::OutputClosed => ExitCode::SUCCESS,
            #[cfg(feature = "viewer")]
            Self::Interrupted => ExitCode::from(INTERRUPTED),
        }
    }

    /// The lines for the standard error.
    pub(crate) fn lines(&self) -> Vec<&str> {
        match self {
            Self::Usage(what) => vec![what, "for more, try `luxel help`"],
            Self::Work { what, remedy } if remedy.is_empty() => vec![what],
            Self::Work { what, remedy } => vec![what, remedy],
            Self::Findings | Self::OutputClosed => Vec::new(),
            #[cfg(feature = "viewer")]
            Self::Interrupted => Vec::new(),
        }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        let remedy = match &error.kind {
            ErrorKind::Io(io) if io.kind() == std::io::ErrorKind::NotFound => {
                "check the name; `luxel demos` lists the scenes that need no file"
            }
            ErrorKind::Io(io) if io.kind() == std::io::ErrorKind::IsADirectory => {
                "choose a model file in it"
            }
            ErrorKind::Io(_) => "check that it is a file that you may read",
            ErrorKind::Malformed(_) if matches!(error.place, Place::LineColumn(..)) => {
                "docs/scene-files.md and `luxel schema` say what may stand in a scene file"
            }
            ErrorKind::Malformed(_) | ErrorKind::OutOfRange { .. } => {
                "the file is damaged or written wrongly: export it again"
            }
            ErrorKind::Truncated(_) => "the file is incomplete: copy or export it again",
            ErrorKind::Unsupported(_) | ErrorKind::UnknownFormat(_) => {
                "export it in another way: glb, gltf, obj, stl or ply"
            }
            // The message contains the remedy.
            _ => "",
        };
        Self::work(error_text(&error), remedy)
    }
}
