//! The short way in: a path becomes a scene.

use luxel_formats::{Error, Limits, Loaded};
use std::path::Path;

/// Reads a model file within the default [`Limits`]; its extension tells the format.
///
/// # Errors
/// [`Error`] with file and place, if the file can't be read, is damaged or asks for too much.
pub fn load(path: impl AsRef<Path>) -> Result<Loaded, Error> {
    luxel_formats::open(path.as_ref(), &Limits::default())
}
