//! Errors of the library as exceptions.

use luxel::formats;
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyOSError, PyValueError};
use pyo3::prelude::*;
use std::fmt::Display;

create_exception!(luxel, Error, PyException, "What luxel can't do; the base of its exceptions.");
create_exception!(
    luxel,
    LoadError,
    Error,
    "A model that can't be read. `file` is its path or None, `place` where in the file (a line, a byte, a \
     JSON pointer), `reason` the cause without either."
);

/// A model can't be read: a [`LoadError`] with its place, or the system's own error.
pub(crate) fn load_error(py: Python<'_>, error: &formats::Error) -> PyErr {
    match &error.kind {
        formats::ErrorKind::Stopped => return PyKeyboardInterrupt::new_err(()),
        formats::ErrorKind::Io(cause) => {
            let path = error.file.as_ref().map(|file| file.to_string_lossy().into_owned());
            return match (cause.raw_os_error(), path) {
                (Some(code), Some(path)) => PyOSError::new_err((code, cause.to_string(), path)),
                _ => PyOSError::new_err(error.to_string()),
            };
        }
        _ => {}
    }
    let raised = LoadError::new_err(error.to_string());
    let value = raised.value(py);
    let file = error.file.as_ref().map(|file| file.to_string_lossy().into_owned());
    let place = error.place.to_string();
    let set = value
        .setattr("file", file)
        .and_then(|()| value.setattr("place", place.trim_start_matches(':').trim()))
        .and_then(|()| value.setattr("reason", error.kind.to_string()));
    match set {
        Ok(()) => raised,
        Err(other) => other,
    }
}

/// The renderer or the picker can't do what is asked.
pub(crate) fn error(cause: impl Display) -> PyErr {
    Error::new_err(cause.to_string())
}

/// An argument is not what it should be: its name, and what is expected.
pub(crate) fn argument(name: &str, expected: impl Display) -> PyErr {
    PyValueError::new_err(format!("{name}: {expected}"))
}
