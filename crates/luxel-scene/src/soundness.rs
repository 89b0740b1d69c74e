//! What renderers and pickers take for granted of a scene: all that is referred to is there, and lists fit together.

use crate::{EnvironmentChoice, Mesh, Node, NodeId, Placement, Scene, SceneMaterial};
use std::fmt;

/// A scene that refers to what isn't there, or whose lists don't fit together.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{part} {number}: {fault}")]
pub struct UnsoundScene {
    /// What kind of thing it is.
    pub part: ScenePart,
    /// Its number among these.
    pub number: usize,
    /// What is wrong with it.
    pub fault: String,
}

/// The kinds of things in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ScenePart {
    /// [`Scene::meshes`]
    Mesh,
    /// [`Scene::materials`]
    Material,
    /// [`Scene::nodes`]
    Node,
    /// [`Scene::cameras`]
    Camera,
    /// [`Scene::lights`]
    Light,
    /// [`Scene::environment`], which has number 0.
    Environment,
}

impl fmt::Display for ScenePart {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Mesh => "mesh",
            Self::Material => "material",
            Self::Node => "node",
            Self::Camera => "camera",
            Self::Light => "light",
            Self::Environment => "environment",
        })
    }
}

/// What is wrong; `Ok` if nothing is.
type Outcome = Result<(), String>;

/// Numbers that are checked at a time.
const RUN: usize = 1 << 16;

impl Scene {
    /// Checks what types don't ensure: that all numbers refer to something, that lists of a mesh fit together, and that
    /// nodes have roots. Readers make sound scenes; renderers and pickers refuse others. Positions may be anything.
    ///
    /// # Errors
    /// The first thing that isn't sound.
    pub fn check(&self) -> Result<(), UnsoundScene> {
        fn each<T>(
            part: ScenePart,
            things: impl IntoIterator<Item = T>,
            check: impl Fn(T) -> Outcome,
        ) -> Result<(), UnsoundScene> {
            things.into_iter().enumerate().try_for_each(|(number, thing)| {
                check(thing).map_err(|fault| UnsoundScene { part, number, fault })
            })
        }
        let is_node = |node: Option<NodeId>| match node {
            Some(node) => below(node.index(), self.nodes.len(), "node"),
            None => Ok(()),
        };
        each(ScenePart::Mesh, self.meshes.iter(), |mesh| check_mesh(mesh, self.materials.len()))?;
        each(ScenePart::Material, &self.materials, |material| {
            check_material(material, self.textures.len())
        })?;
        each(ScenePart::Node, &self.nodes, |node| self.check_node(node))?;
        self.check_roots()?;
        each(ScenePart::Camera, &self.cameras, |camera| is_node(camera.node))?;
        each(ScenePart::Light, &self.lights, |light| match light.placement {
            Placement::Node(node) => is_node(Some(node)),
            Placement::World | Placement::Camera => Ok(()),
        })?;
        each(ScenePart::Environment, &self.environment, check_environment)
    }

    fn check_node(&self, node: &Node) -> Outcome {
        if let Some(parent) = node.parent {
            below(parent.index(), self.nodes.len(), "node")?;
        }
        let Some(mesh) = node.mesh else { return Ok(()) };
        below(mesh.index(), self.meshes.len(), "mesh")?;
        // A mesh of one object has none of its own.
        let sections = self.meshes[mesh.index()].sections.len().max(1);
        below(node.section as usize, sections, "section")
    }

    /// Checks that every node has a root above it. Parents must be there.
    fn check_roots(&self) -> Result<(), UnsoundScene> {
        let mut has_root = vec![false; self.nodes.len()];
        let mut path = Vec::new();
        for start in 0..self.nodes.len() {
            let mut at = Some(start);
            while let Some(node) = at.filter(|&node| !has_root[node]) {
                path.push(node);
                if path.len() > self.nodes.len() {
                    let fault = "it is above itself".to_owned();
                    return Err(UnsoundScene { part: ScenePart::Node, number: node, fault });
                }
                at = self.nodes[node].parent.map(NodeId::index);
            }
            path.drain(..).for_each(|node| has_root[node] = true);
        }
        Ok(())
    }
}

/// Checks that there is a thing with that number.
fn below(number: usize, count: usize, what: &str) -> Outcome {
    if number < count { Ok(()) } else { Err(format!("there is no {what} {number}")) }
}

fn check_material(material: &SceneMaterial, textures: usize) -> Outcome {
    material.textures().try_for_each(|used| {
        below(used.texture.index(), textures, "texture")?;
        below(usize::from(used.uv_set), 2, "set of texture coordinates")
    })
}

fn check_environment(environment: &EnvironmentChoice) -> Outcome {
    if environment.is_sound() { Ok(()) } else { Err("its map lacks texels".to_owned()) }
}

fn check_mesh(mesh: &Mesh, materials: usize) -> Outcome {
    let (positions, triangles) = (mesh.positions.len(), mesh.triangles.len());
    let lists = [
        ("normals", mesh.normals.len()),
        ("tangents", mesh.tangents.len()),
        ("texture coordinates", mesh.uvs[0].len()),
        ("second texture coordinates", mesh.uvs[1].len()),
        ("colours", mesh.colors.len()),
    ];
    let attributes = match mesh.attribute_corners {
        Some(_) => lists.iter().map(|(_, count)| *count).max().unwrap_or_default(),
        None => positions,
    };
    corners_below(&mesh.triangles, positions, "position")?;
    let corners = mesh.attribute_corners();
    as_long("corners of attributes", corners.len(), triangles, "triangles")?;
    corners_below(corners, attributes, "attribute vertex")?;
    for (what, count) in lists.into_iter().filter(|(_, count)| *count > 0) {
        as_long(what, count, attributes, "attribute vertices")?;
    }
    for (what, list) in [("polygons", &mesh.polygons), ("smoothing groups", &mesh.smoothing_groups)]
    {
        let count = list.as_ref().map_or(triangles, Vec::len);
        as_long(what, count, triangles, "triangles")?;
    }
    for fault in &mesh.normal_faults {
        below(fault.position as usize, positions, "position")?;
    }
    check_parts(mesh, materials)?;
    for points in &mesh.points {
        below(points.material.index(), materials, "material")?;
        numbers_below(&points.indices, positions, "position")?;
    }
    for lines in &mesh.lines {
        below(lines.material.index(), materials, "material")?;
        numbers_below(lines.segments.as_flattened(), positions, "position")?;
    }
    check_sections(mesh, attributes)
}

/// Checks that the parts follow one another, and end with the triangles.
fn check_parts(mesh: &Mesh, materials: usize) -> Outcome {
    let mut next = 0;
    for part in &mesh.parts {
        below(part.material.index(), materials, "material")?;
        if u64::from(part.first) != next {
            return Err(format!("a part begins at triangle {}, not at {next}", part.first));
        }
        next += u64::from(part.count);
    }
    let triangles = mesh.triangles.len() as u64;
    if next == triangles {
        return Ok(());
    }
    Err(format!("its parts have {next} triangles, there are {triangles}"))
}

/// Checks that the sections follow one another, and end with the mesh.
fn check_sections(mesh: &Mesh, attributes: usize) -> Outcome {
    let whole = [mesh.triangles.len(), mesh.positions.len(), attributes].map(|count| count as u32);
    let mut before = [0; 3];
    for section in &mesh.sections {
        let ends = [section.triangles, section.positions, section.attributes];
        if ends.iter().zip(before).any(|(end, before)| *end < before) {
            return Err("a section ends before the one before it".to_owned());
        }
        before = ends;
    }
    if mesh.sections.is_empty() || before == whole {
        return Ok(());
    }
    Err("its last section doesn't end where the mesh does".to_owned())
}

fn as_long(what: &str, count: usize, of: usize, others: &str) -> Outcome {
    if count == of { Ok(()) } else { Err(format!("{count} {what} for {of} {others}")) }
}

fn corners_below(corners: &[[u32; 3]], count: usize, what: &str) -> Outcome {
    numbers_below(corners.as_flattened(), count, what)
}

fn numbers_below(numbers: &[u32], count: usize, what: &str) -> Outcome {
    // Folds without a way out, which become vectors.
    let largest = luxel_parallel::map(numbers.len(), RUN, &|run| {
        numbers[run].iter().fold(0, |most: u32, number| most.max(*number))
    });
    largest.into_iter().max().map_or(Ok(()), |largest| below(largest as usize, count, what))
}

#[cfg(test)]
mod tests;
