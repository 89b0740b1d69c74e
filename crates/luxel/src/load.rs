//! The short way in: a path becomes a scene that is ready to be drawn.

use luxel_formats::{Error, Limits, Loaded};
use luxel_scene::NormalOptions;
use std::path::Path;

/// Reads a model file within the default [`Limits`]; its extension tells the format. Normals and
/// tangents that the file lacks are computed.
///
/// # Errors
/// [`Error`] with file and place, if the file can't be read, is damaged or asks for too much.
pub fn load(path: impl AsRef<Path>) -> Result<Loaded, Error> {
    let mut loaded = luxel_formats::open(path.as_ref(), &Limits::default())?;
    loaded.scene.compute_normals(&NormalOptions::default());
    loaded.scene.compute_tangents();
    Ok(loaded)
}
