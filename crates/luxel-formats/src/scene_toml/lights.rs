//! `[[lights]]`: the fields of a light, as keys.

use super::document::{Document, Table};
use super::keys::LIGHTS;
use super::nodes::Nodes;
use crate::Error;
use crate::values::{Fields, light_of};
use luxel_scene::{Placement, Scene, SceneLight};

/// The lights of the file, in order.
pub(super) fn read(
    document: &Document<'_>,
    nodes: &Nodes,
    scene: &Scene,
) -> Result<Vec<SceneLight>, Error> {
    let mut lights: Vec<SceneLight> = Vec::new();
    let mut names = std::collections::HashSet::new();
    for (place, table) in document.tables(&LIGHTS)?.into_iter().enumerate() {
        let light = light(&table, place, nodes, scene)?;
        if !names.insert(light.name.clone()) {
            let message = format!("two lights have the name `{}`: rename one", light.name);
            return Err(table.error_at("name", message));
        }
        lights.push(light);
    }
    Ok(lights)
}

fn light(
    table: &Table<'_>,
    place: usize,
    nodes: &Nodes,
    scene: &Scene,
) -> Result<SceneLight, Error> {
    let kind = table.text("kind")?.unwrap_or_default();
    let fields = table.fields(&["kind", "node"])?;
    let fields: Fields<'_> = fields.iter().map(|(key, value)| (*key, value.as_str())).collect();
    let spec = light_of(kind, fields).map_err(|error| {
        let key = error.key.as_deref().unwrap_or("kind");
        table.error_at(key, error.to_string())
    })?;
    let mut light = spec.named(place);
    if let Some(path) = table.path("node")? {
        if table.has("in") {
            return Err(table.error_at("node", "`node` and `in` exclude each other"));
        }
        light.placement = Placement::Node(nodes.find(scene, table, "node", &path)?);
    }
    Ok(light)
}
