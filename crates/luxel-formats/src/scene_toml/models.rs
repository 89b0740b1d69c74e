//! `[[models]]`: joins files and demos into one scene.

use super::document::{Document, Table};
use super::keys::MODELS;
use super::nodes::Nodes;
use super::transform::transform;
use crate::memory::Memory;
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Format, files, model_file};
use luxel_scene::{
    MaterialId, Mesh, MeshId, Node, NodeId, Placement, Scene, SceneCamera, SceneLight, TextureId,
    demos,
};
use std::collections::HashMap;
use std::path::Path;

/// All models, with the data that other tables need.
pub(super) struct Models {
    /// Meshes, materials, textures and nodes of all models.
    pub(super) scene: Scene,
    /// Its nodes by their names.
    pub(super) nodes: Nodes,
    /// Each model's nodes, and its material.
    pub(super) list: Vec<Model>,
    /// The lights and cameras of the models that enable them.
    pub(super) lights: Vec<SceneLight>,
    pub(super) cameras: Vec<SceneCamera>,
}

/// One model in the scene.
pub(super) struct Model {
    /// The name of its first node, the ancestor of all others.
    pub(super) name: String,
    /// The range of its nodes, end exclusive.
    pub(super) nodes: std::ops::Range<usize>,
    /// The material for the whole model, and the place of its key.
    pub(super) material: Option<(String, crate::Place)>,
}

/// A file or demo, read once: the part that each of its uses adds to the scene.
struct Source {
    nodes: Vec<Node>,
    lights: Vec<SceneLight>,
    cameras: Vec<SceneCamera>,
    /// The index of its first mesh in the scene.
    first_mesh: u32,
}

/// Reads all models of the file.
pub(super) fn read(
    document: &Document<'_>,
    folder: Option<&Path>,
    memory: &Memory<'_>,
    warnings: &mut Warnings,
) -> Result<Models, Error> {
    let mut models = Models {
        scene: Scene::default(),
        nodes: Nodes::default(),
        list: Vec::new(),
        lights: Vec::new(),
        cameras: Vec::new(),
    };
    let mut sources: HashMap<String, Source> = HashMap::new();
    for table in document.tables(&MODELS)? {
        let name = table.text("source")?.unwrap_or_default();
        if !sources.contains_key(name) {
            let read = open_source(&table, name, folder, memory, warnings)?;
            let is_first = sources.is_empty();
            memory.take(&format!("`{name}`"), bytes_of(&read), 1, table.place_of("source"))?;
            sources.insert(name.to_owned(), models.take(read, is_first));
        }
        let source = &sources[name];
        memory.take("the nodes", source.nodes.len() as u64 + 1, 192, table.place_of("source"))?;
        models.place(&table, name, source)?;
    }
    Ok(models)
}

/// Reads the file or demo that a name refers to.
fn open_source(
    table: &Table<'_>,
    name: &str,
    folder: Option<&Path>,
    memory: &Memory<'_>,
    warnings: &mut Warnings,
) -> Result<Scene, Error> {
    if let Some(name) = name.strip_prefix("demo:") {
        return demos::demo(name).ok_or_else(|| {
            let names: Vec<_> = demos::names().into_iter().map(|(name, _)| name).collect();
            let message = format!("there is no demo `{name}`: use {}", names.join(", "));
            table.error_at("source", message)
        });
    }
    let path = files::referenced(folder, name, memory.given())
        .map_err(|refusal| table.error_at("source", refusal.message))?;
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        let message =
            format!("`{name}` is a scene file, and scene files can't contain scene files");
        return Err(table.error_at("source", message));
    }
    let loaded = model_file::open(&path, &memory.left()).map_err(|error| match error.kind {
        // The error of a missing file points to the key that names it.
        ErrorKind::Io(io) if error.file.as_deref() == Some(&path) => {
            table.error_at("source", format!("{}: {io}", path.display()))
        }
        kind => Error { kind, ..error },
    })?;
    debug_assert!(loaded.format != Format::Toml, "scene files can't contain scene files");
    for warning in loaded.warnings {
        warnings.push(warning.at(name));
    }
    Ok(loaded.scene)
}

/// The memory of a scene in bytes.
fn bytes_of(scene: &Scene) -> u64 {
    let mesh = |mesh: &Mesh| {
        let words = 3 * (mesh.positions.len() + mesh.triangles.len() + mesh.normals.len())
            + 3 * mesh.attribute_corners.as_ref().map_or(0, Vec::len)
            + 4 * (mesh.tangents.len() + mesh.colors.len())
            + 2 * (mesh.uvs[0].len() + mesh.uvs[1].len());
        4 * words as u64
    };
    let texels = |texture: &luxel_scene::Texture| {
        let levels = texture.image.levels.iter();
        4 * levels.map(|level| level.texels.len() as u64).sum::<u64>()
    };
    let meshes: u64 = scene.meshes.iter().map(mesh).sum();
    meshes + scene.textures.iter().map(texels).sum::<u64>() + 192 * scene.nodes.len() as u64
}

impl Models {
    /// Moves a scene's meshes, materials and textures; returns the rest, which its uses add.
    fn take(&mut self, read: Scene, is_first: bool) -> Source {
        let scene = &mut self.scene;
        if is_first {
            scene.up = read.up;
        }
        scene.environment = scene.environment.take().or(read.environment);
        scene.ambient = scene.ambient.or(read.ambient);
        scene.fog = scene.fog.or(read.fog);
        scene.background = scene.background.or(read.background);
        let first_mesh = scene.meshes.len() as u32;
        let first_material = scene.materials.len() as u32;
        let first_texture = scene.textures.len() as u32;
        let material = |id: MaterialId| MaterialId(id.0 + first_material);
        for mut mesh in read.meshes {
            mesh.parts.iter_mut().for_each(|part| part.material = material(part.material));
            mesh.points.iter_mut().for_each(|points| points.material = material(points.material));
            mesh.lines.iter_mut().for_each(|lines| lines.material = material(lines.material));
            scene.meshes.push(mesh);
        }
        for mut material in read.materials {
            for used in material.textures_mut() {
                used.texture = TextureId(used.texture.0 + first_texture);
            }
            scene.materials.push(material);
        }
        scene.textures.extend(read.textures);
        Source { nodes: read.nodes, lights: read.lights, cameras: read.cameras, first_mesh }
    }

    /// Adds a model to the scene.
    fn place(
        &mut self,
        table: &Table<'_>,
        source_name: &str,
        source: &Source,
    ) -> Result<(), Error> {
        let root = self.scene.nodes.len();
        let parent = match table.path("parent")? {
            Some(path) => Some(self.nodes.find(&self.scene, table, "parent", &path)?),
            None => None,
        };
        let stem = Path::new(source_name).file_stem().unwrap_or_default().to_string_lossy();
        let stem = stem.strip_prefix("demo:").unwrap_or(&stem);
        let name = table.text("name")?.unwrap_or(stem).to_owned();
        let parent_from_node = transform(table)?;
        self.scene.nodes.push(Node::root(name.clone(), None).at(parent, parent_from_node));
        let moved = |id: NodeId| NodeId(id.0 + root as u32 + 1);
        for node in &source.nodes {
            self.scene.nodes.push(Node {
                parent: Some(node.parent.map_or(NodeId(root as u32), moved)),
                mesh: node.mesh.map(|mesh| MeshId(mesh.0 + source.first_mesh)),
                ..node.clone()
            });
        }
        self.nodes.add(&self.scene, root);
        if table.switch("lights")?.unwrap_or(true) {
            self.lights.extend(source.lights.iter().map(|light| {
                let placement = match light.placement {
                    Placement::Node(node) => Placement::Node(moved(node)),
                    // Lights in the world space of the model's file move with the model.
                    Placement::World => Placement::Node(NodeId(root as u32)),
                    Placement::Camera => Placement::Camera,
                };
                SceneLight { placement, ..light.clone() }
            }));
        }
        if table.switch("cameras")?.unwrap_or(true) {
            self.cameras.extend(source.cameras.iter().map(|camera| SceneCamera {
                node: Some(camera.node.map_or(NodeId(root as u32), moved)),
                ..camera.clone()
            }));
        }
        let material = table.text("material")?;
        self.list.push(Model {
            name,
            nodes: root..self.scene.nodes.len(),
            material: material.map(|name| (name.to_owned(), table.place_of("material"))),
        });
        Ok(())
    }
}
