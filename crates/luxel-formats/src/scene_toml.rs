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

use crate::environment::{LoadedEnvironment, open_environment};
use crate::memory::Memory;
use crate::values::{background, color, finite, fog_of, surroundings, up};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Format, Limits, Loaded, files};
use document::{Document, Table};
pub use keys::{Key, Section, Shape, sections};
use luxel_scene::{EnvironmentChoice, Scene, SceneMaterial, Viewpoint};
pub use settings::{Setting, SettingValue, scene_settings};
use std::path::Path;
use std::sync::Arc;
pub use write::{SceneModels, SceneText, SurfaceChange};

/// Reads a scene file, with its models from `folder`.
pub(crate) fn read(bytes: &[u8], folder: Option<&Path>, limits: &Limits) -> Result<Loaded, Error> {
    let memory = Memory::new(limits);
    let mut warnings = Warnings::default();
    let document = Document::parse(bytes, &memory)?;
    let root = document.root()?;
    let mut models = models::read(&document, folder, &memory, &mut warnings)?;
    materials::apply(&document, &mut models, &memory)?;
    let from = (folder, &memory);
    read_surroundings(&document, &root, &mut models.scene, from, &mut warnings)?;
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
    (folder, memory): (Option<&Path>, &Memory<'_>),
    warnings: &mut Warnings,
) -> Result<(), Error> {
    scene.up = root.value("up", up)?.unwrap_or(scene.up);
    scene.ambient = root.value("ambient", color)?.or(scene.ambient);
    let rotation_degrees = root.value("environment_rotation", finite)?.unwrap_or_default();
    if let Some(surroundings) = root.value("environment", surroundings)? {
        scene.environment = Some(match surroundings.environment(scene.up) {
            Ok(choice) => choice,
            Err(name) => {
                let name = name.to_string_lossy();
                let at = |message: String| root.error_at("environment", message);
                let path = files::referenced(folder, &name, memory.given())
                    .map_err(|refusal| at(refusal.message))?;
                let opened = open_environment(&path, &memory.left());
                let LoadedEnvironment { map, warnings: odd } =
                    opened.map_err(|error| match error.kind {
                        ErrorKind::Io(io) => at(format!("{}: {io}", path.display())),
                        kind => Error { kind, ..error },
                    })?;
                for warning in odd {
                    warnings.push(warning.at(&name));
                }
                let frame = Viewpoint::frame(scene.up);
                EnvironmentChoice::of_map(Arc::new(map), frame, rotation_degrees)
            }
        });
    }
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
