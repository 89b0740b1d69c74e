//! Failures of the program, and the exit status of each.

use crate::flag_words::error_text;
use luxel::formats::{Error, ErrorKind, Place};
use luxel::render::RenderError;
use std::path::Path;

/// The status of a program that was interrupted, as shells report it: 128 and the number of the
/// signal.
pub(crate) const INTERRUPTED: u8 = 130;

/// The reason of a failure.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Contradictory flags: status 2.
    Usage(String),
    /// The work failed: status 1.
    Work {
        /// The problem, with its place.
        what: String,
        /// The remedy; empty if `what` contains it.
        remedy: String,
    },
    /// A check reported findings: status 3.
    Findings,
    /// The reader closed the standard output: not an error.
    OutputClosed,
    /// A signal interrupted the program, which cleaned up: status 130.
    Interrupted,
}

impl Failure {
    /// A failure of the work.
    pub(crate) fn work(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Work { what: what.into(), remedy: remedy.into() }
    }

    /// A failure to write the file that a flag names.
    pub(crate) fn writing(path: &Path, error: &std::io::Error, flag: &str) -> Self {
        Self::work(
            format!("{}: can't be written: {error}", path.display()),
            format!("choose another file with {flag}, or make this one writable"),
        )
    }

    /// The standard output failed.
    pub(crate) fn standard_output(error: &std::io::Error) -> Self {
        if error.kind() == std::io::ErrorKind::BrokenPipe {
            Self::OutputClosed
        } else {
            Self::work(
                format!("standard output: {error}"),
                "check the program or device that receives it",
            )
        }
    }

    /// The exit status of the program.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Work { .. } => 1,
            Self::Findings => 3,
            Self::OutputClosed => 0,
            Self::Interrupted => INTERRUPTED,
        }
    }

    /// The lines to print to the standard error.
    pub(crate) fn lines(&self) -> Vec<&str> {
        match self {
            Self::Usage(what) => vec![what, "for more, try `luxel help`"],
            Self::Work { what, remedy } if remedy.is_empty() => vec![what],
            Self::Work { what, remedy } => vec![what, remedy],
            Self::Findings | Self::OutputClosed => Vec::new(),
            Self::Interrupted => Vec::new(),
        }
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        let remedy = match &error {
            RenderError::TreesTooLarge { .. } => {
                "raise the limit with --max-memory, or leave out --shadows, --ao and --ground"
            }
            // The message contains the remedy.
            _ => "",
        };
        Self::work(error.to_string(), remedy)
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        let remedy = match &error.kind {
            // The hint is the remedy.
            _ if error.hint().is_some() => "",
            ErrorKind::Reference(_) => {
                "put a regular file in the model's folder or below, and name it there"
            }
            ErrorKind::Io(io)
                if io.kind() == std::io::ErrorKind::NotFound
                    && matches!(error.place, Place::Pointer(_)) =>
            {
                "the model needs this file: put it where the name says, beside the model"
            }
            ErrorKind::Io(io)
                if io.kind() == std::io::ErrorKind::NotFound
                    && error.file.as_deref().is_some_and(luxel::formats::is_environment) =>
            {
                "check the name of the environment"
            }
            ErrorKind::Io(io) if io.kind() == std::io::ErrorKind::NotFound => {
                "check the name; `luxel demos` lists the built-in scenes"
            }
            ErrorKind::Io(io) if io.kind() == std::io::ErrorKind::IsADirectory => {
                "choose a model file in it"
            }
            ErrorKind::Io(_) => "check that it is a file that you have permission to read",
            ErrorKind::Malformed(_) if matches!(error.place, Place::LineColumn(..)) => {
                "docs/scene-files.md and `luxel schema` describe scene files"
            }
            ErrorKind::Malformed(_) | ErrorKind::OutOfRange { .. } => {
                "the file is damaged or its exporter is faulty: export it again"
            }
            ErrorKind::Truncated(_) => "the file is incomplete: copy or export it again",
            ErrorKind::Unsupported(_)
                if error.file.as_deref().is_some_and(luxel::formats::is_environment) =>
            {
                "an environment is a regular file: .hdr with rows from the top, or .exr of one part, \
                 compressed without loss or with PXR24 or B44"
            }
            ErrorKind::Unsupported(_) | ErrorKind::UnknownFormat(_) => {
                "export it in another format or with other settings: glb, gltf, obj, stl or ply"
            }
            // The message contains the remedy.
            _ => "",
        };
        Self::work(error_text(&error), remedy)
    }
}
