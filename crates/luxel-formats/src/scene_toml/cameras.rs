//! `[[cameras]]`: placement and lens.

use super::document::{Document, Table};
use super::keys::CAMERAS;
use super::nodes::Nodes;
use crate::Error;
use crate::values::{fov, intrinsics, point, positive, up, view_matrix};
use glam::DMat4;
use luxel_scene::{Camera, Lens, Scene, SceneCamera};
use std::collections::HashSet;

/// The default angle of view from bottom to top, in degrees.
const DEFAULT_FOV_DEGREES: f64 = 45.0;

/// The cameras of the file, in order.
pub(super) fn read(
    document: &Document<'_>,
    nodes: &Nodes,
    scene: &Scene,
) -> Result<Vec<SceneCamera>, Error> {
    let mut names = HashSet::new();
    let mut cameras = Vec::new();
    for table in document.tables(&CAMERAS)? {
        let name = table.text("name")?.unwrap_or_default().to_owned();
        if !names.insert(name.clone()) {
            let message = format!("two cameras have the name `{name}`: rename one");
            return Err(table.error_at("name", message));
        }
        let node = match table.path("node")? {
            Some(path) => Some(nodes.find(scene, &table, "node", &path)?),
            None => None,
        };
        let view_from_node = pose(&table, scene)?;
        cameras.push(SceneCamera { name, node, view_from_node, lens: lens(&table)?, planes: None });
    }
    Ok(cameras)
}

fn pose(table: &Table<'_>, scene: &Scene) -> Result<DMat4, Error> {
    if let Some(matrix) = table.value("view-matrix", view_matrix)? {
        if let Some(other) = ["eye", "target", "up"].into_iter().find(|key| table.has(key)) {
            let message = format!("`{other}` and `view-matrix` exclude each other");
            return Err(table.error_at(other, message));
        }
        return Ok(matrix);
    }
    let eye = table.value("eye", point)?;
    let target = table.value("target", point)?;
    let up = table.value("up", up)?.unwrap_or(scene.up);
    match (eye, target) {
        (Some(eye), Some(target)) if eye == target => {
            Err(table.error_at("eye", "eye and target are the same point: move one of them"))
        }
        (Some(eye), Some(target)) => Ok(Camera::look_at(eye, target, up)),
        (None, None) if table.has("node") => Ok(DMat4::IDENTITY),
        _ => Err(table.error("a camera needs eye and target, a view-matrix, or a node")),
    }
}

fn lens(table: &Table<'_>) -> Result<Lens, Error> {
    let given: Vec<_> =
        ["fov", "ortho", "intrinsics"].into_iter().filter(|key| table.has(key)).collect();
    if let [first, second, ..] = given[..] {
        let message = format!("`{first}` and `{second}` exclude each other");
        return Err(table.error_at(second, message));
    }
    if let Some([fx, fy, cx, cy]) = table.value("intrinsics", intrinsics)? {
        return Ok(Lens::Intrinsics { fx, fy, cx, cy });
    }
    if let Some(height) = table.value("ortho", positive)? {
        return Ok(Lens::Orthographic { height });
    }
    let degrees = table.value("fov", fov)?.unwrap_or(DEFAULT_FOV_DEGREES);
    Ok(Lens::Perspective { fov_y_radians: degrees.to_radians() })
}
