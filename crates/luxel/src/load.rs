//! Loads a model file and prepares it for drawing.

use luxel_formats::{Error, Limits, Loaded};
use luxel_scene::NormalOptions;
use std::path::Path;

/// Reads a model file within the default [`Limits`]; its extension is the format. Normals and
/// tangents that the file lacks are computed.
///
/// # Errors
/// [`Error`] with file and place, if the file can't be read, is damaged or exceeds the limits.
pub fn load(path: impl AsRef<Path>) -> Result<Loaded, Error> {
    let mut loaded = luxel_formats::open(path.as_ref(), &Limits::default())?;
    loaded.scene.compute_normals(&NormalOptions::default());
    loaded.scene.compute_tangents();
    Ok(loaded)
}
