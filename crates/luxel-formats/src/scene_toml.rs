//! Scene files: TOML that combines models, materials, lights and cameras.
//!
//! `keys` lists all sections and keys: readers, the JSON schema and the documentation use that
//! table. Values are parsed by [`values`](crate::values): the keys of a light are the fields of
//! [`values::light`](crate::values::light()). `[render]` holds settings of the rendering program;
//! [`scene_settings`] returns them as [`Setting`]s.

mod cameras;
mod document;
mod keys;
mod lights;
mod materials;
mod models;
mod nodes;
mod settings;
mod transform;
mod write;

use crate::memory::Memory;
use crate::values::{background, color, fog_of, surroundings, up};
use crate::warnings::Warnings;
use crate::{Error, Format, Limits, Loaded};
use document::{Document, Table};
pub use keys::{Key, Section, Shape, sections};
use luxel_scene::{Scene, SceneMaterial};
pub use settings::{Setting, SettingValue, scene_settings};
use std::path::Path;
pub use write::{SceneModels, SceneText, SurfaceChange};

/// Reads a scene file, with its models from `folder`.
pub(crate) fn read(bytes: &[u8], folder: Option<&Path>, limits: &Limits) -> Result<Loaded, Error> {
    let memory = Memory::new(limits);
    let mut warnings = Warnings::default();
    let document = Document::parse(bytes, &memory)?;
    let root = document.root()?;
    let mut models = models::read(&document, folder, &memory, &mut warnings)?;
    materials::apply(&document, &mut models, &memory)?;
    read_surroundings(&document, &root, &mut models.scene)?;
    let lights = lights::read(&document, &models.nodes, &models.scene)?;
    let cameras = cameras::read(&document, &models.nodes, &models.scene)?;
    let mut scene = models.scene;
    scene.lights = if lights.is_empty() { models.lights } else { lights };
    scene.cameras = cameras;
    scene.cameras.extend(models.cameras);
    if scene.materials.is_empty() {
        scene.materials.push(SceneMaterial::default());
    }
    Ok(Loaded { scene, format: Format::Toml, warnings: warnings.finish() })
}

/// Reads the scene-wide keys: up, ambient light, environment, background, fog.
fn read_surroundings(
    document: &Document<'_>,
    root: &Table<'_>,
    scene: &mut Scene,
) -> Result<(), Error> {
    scene.up = root.value("up", up)?.unwrap_or(scene.up);
    scene.ambient = root.value("ambient", color)?.or(scene.ambient);
    let environment = root.value("environment", surroundings)?;
    let environment = environment.map(|surroundings| surroundings.environment(scene.up));
    scene.environment = environment.or(scene.environment);
    scene.background = root.value("background", background)?.or(scene.background);
    for table in document.tables(&keys::FOG)? {
        let fields = table.fields(&[])?;
        let fog = fog_of(fields.iter().map(|(key, value)| (*key, value.as_str())).collect());
        scene.fog = Some(fog.map_err(|error| match &error.key {
            Some(key) => table.error_at(key, error.to_string()),
            None => table.error(error.to_string()),
        })?);
    }
    Ok(())
}

#[cfg(test)]
mod tests;
