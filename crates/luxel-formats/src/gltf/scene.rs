//! From the document to the scene: the shown nodes with their meshes, cameras and lights.

use super::buffers::{Buffers, item, malformed};
use super::instancing;
use super::materials;
use super::mesh::{self, DefaultMaterials};
use super::pose::Pose;
use super::textures::Textures;
use super::tree::Tree;
use super::{accessor, cameras, lights};
use crate::warnings::Warnings;
use crate::{Error, Place};
use glam::{DMat4, DVec3};
use luxel_gltf::{Index, Node as FileNode};
use luxel_scene::{
    MeshId, Name, Node, NodeId, Placement, Scene, SceneCamera, SceneLight, SharedMatrix,
};
use std::collections::HashMap;

/// Builds the scene that the document shows.
pub(crate) fn build(buffers: &Buffers<'_>, warnings: &mut Warnings) -> Result<Scene, Error> {
    let document = buffers.document();
    let tree = Tree::grow(document, &buffers.memory().left(), warnings)?;
    let mut builder = Builder {
        buffers,
        tree: &tree,
        scene: Scene::default(),
        shared_meshes: HashMap::new(),
        default_materials: DefaultMaterials {
            in_file: document.materials.len() as u32,
            ..DefaultMaterials::default()
        },
        warnings,
    };
    // Nodes come first, so that instances don't shift their numbers.
    builder.scene.nodes.reserve_exact(tree.shown.len());
    for shown in &tree.shown {
        let file_node = &document.nodes[shown.node as usize];
        builder.scene.nodes.push(Node {
            parent: shown.parent.map(NodeId),
            parent_from_node: tree.parent_from_nodes[shown.node as usize].clone(),
            ..Node::root(name(buffers, file_node, shown.node), None)
        });
    }
    for (place, shown) in tree.shown.iter().enumerate() {
        builder.fill(NodeId(place as u32), shown.node)?;
    }
    let Builder { mut scene, default_materials, .. } = builder;
    let mut textures = Textures::new(buffers);
    for (index, material) in document.materials.iter().enumerate() {
        scene.materials.push(materials::convert(material, index, &mut textures, warnings)?);
    }
    scene.materials.extend(materials::defaults(&default_materials));
    scene.textures = textures.load(&mut scene.materials, warnings)?;
    Ok(scene)
}

/// The node's name, else its mesh's, else `node` with its number.
fn name(buffers: &Buffers<'_>, node: &FileNode, index: Index) -> Name {
    let meshes = &buffers.document().meshes;
    let of_mesh = || node.mesh.and_then(|mesh| meshes.get(mesh as usize)?.name.as_deref());
    let given = |name: &&str| !name.is_empty();
    let name = node.name.as_deref().filter(given).or_else(|| of_mesh().filter(given));
    name.map_or_else(|| format!("node_{index}").into(), Name::from)
}

struct Builder<'b, 'd> {
    buffers: &'b Buffers<'d>,
    tree: &'b Tree,
    scene: Scene,
    /// Undeformed meshes, which nodes share.
    shared_meshes: HashMap<Index, MeshId>,
    default_materials: DefaultMaterials,
    warnings: &'b mut Warnings,
}

impl Builder<'_, '_> {
    /// Attaches mesh, camera and light to a node.
    fn fill(&mut self, id: NodeId, index: Index) -> Result<(), Error> {
        let document = self.buffers.document();
        let node = &document.nodes[index as usize];
        if let Some(mesh) = node.mesh {
            let mesh = self.mesh(node, index, mesh)?;
            match &node.more().extensions.instancing {
                Some(instancing) => {
                    let pointer = format!("/nodes/{index}/extensions/EXT_mesh_gpu_instancing");
                    let places = instancing::places(self.buffers, instancing, &pointer)?;
                    self.add_instances(id, mesh, &places);
                }
                None => self.scene.nodes[id.index()].mesh = Some(mesh),
            }
        }
        if let Some(camera) = node.more().camera {
            let pointer = || format!("/nodes/{index}/camera");
            let file_camera = item(&document.cameras, camera, "camera", &pointer)?;
            let (lens, planes) = cameras::convert(file_camera, camera)?;
            let name =
                self.name_of_attached(&file_camera.name, node, || format!("camera_{camera}"));
            let planes = Some(planes);
            let node = Some(id);
            let view_from_node = DMat4::IDENTITY;
            self.scene.cameras.push(SceneCamera { name, node, view_from_node, lens, planes });
        }
        if let Some(light) = &node.more().extensions.light {
            let number = light.light;
            let pointer = || format!("/nodes/{index}/extensions/KHR_lights_punctual/light");
            let lights = document.extensions.lights.as_ref();
            let lights = lights.map_or(&[][..], |extension| &extension.lights);
            let file_light = item(lights, number, "light", &pointer)?;
            let light = lights::convert(file_light, number)?;
            self.scene.lights.push(SceneLight {
                name: self.name_of_attached(&file_light.name, node, || format!("light_{number}")),
                light,
                placement: Placement::Node(id),
                position: DVec3::ZERO,
                direction: DVec3::NEG_Z,
            });
        }
        Ok(())
    }

    /// The name of a camera or light, else of its node, else its number.
    fn name_of_attached(
        &self,
        own: &Option<String>,
        node: &FileNode,
        by_number: impl FnOnce() -> String,
    ) -> String {
        let given = |name: &&str| !name.is_empty();
        let name = own.as_deref().filter(given).or(node.name.as_deref().filter(given));
        name.map_or_else(by_number, str::to_owned)
    }

    /// The mesh of a node, in that node's pose.
    fn mesh(&mut self, node: &FileNode, index: Index, number: Index) -> Result<MeshId, Error> {
        let meshes = &self.buffers.document().meshes;
        let pointer = || format!("/nodes/{index}/mesh");
        let file_mesh = item(meshes, number, "mesh", &pointer)?;
        let more = node.more();
        let is_shared = more.weights.is_none() && more.skin.is_none();
        if let Some(&mesh) = self.shared_meshes.get(&number).filter(|_| is_shared) {
            return Ok(mesh);
        }
        let weights = more.weights.as_ref().or(file_mesh.weights.as_ref());
        let pose = Pose {
            weights: weights.map_or_else(Vec::new, |weights| weights.to_vec()),
            joints: match more.skin {
                Some(skin) => self.joints(skin, index)?,
                None => None,
            },
        };
        let materials = &mut self.default_materials;
        let mesh = mesh::build(self.buffers, number, &pose, materials, self.warnings)?;
        let id = MeshId(self.scene.meshes.len() as u32);
        self.scene.meshes.push(mesh);
        if is_shared {
            self.shared_meshes.insert(number, id);
        }
        Ok(id)
    }

    /// For each joint of a skin, from the bind pose to the node that shows the skinned mesh.
    fn joints(&mut self, number: Index, node: Index) -> Result<Option<Vec<DMat4>>, Error> {
        let document = self.buffers.document();
        let skin = item(&document.skins, number, "skin", &|| format!("/nodes/{node}/skin"))?;
        let pointer = || format!("/skins/{number}/inverseBindMatrices");
        let joints = skin.joints.len();
        let place = || Place::Pointer(format!("/skins/{number}/joints"));
        self.buffers.memory().take("joints", joints as u64, 384, place())?;
        let inverse_bind: Vec<[f64; 16]> = match skin.inverse_bind_matrices {
            Some(index) => {
                let elements = accessor::elements(self.buffers, index, &pointer)?;
                self.buffers.memory().take("joints", elements.count as u64, 128, place())?;
                elements.vectors().map_err(|message| malformed(pointer(), message))?
            }
            None => vec![DMat4::IDENTITY.to_cols_array(); joints],
        };
        if inverse_bind.len() < joints {
            let message = format!("there are {} for {joints} joints", inverse_bind.len());
            return Err(malformed(pointer(), message));
        }
        let world_from_node = self.tree.world_from_node(node);
        let node_from_world = world_from_node.inverse();
        if !node_from_world.is_finite() {
            let message = "the skin is left out: the node's transform has no inverse";
            self.warnings.push(format!("/nodes/{node}: {message}"));
            return Ok(None);
        }
        let mut matrices = Vec::with_capacity(joints);
        for (place, (&joint, bind)) in skin.joints.iter().zip(&inverse_bind).enumerate() {
            let pointer = || format!("/skins/{number}/joints/{place}");
            item(&document.nodes, joint, "node", &pointer)?;
            let world_from_joint = self.tree.world_from_node(joint);
            let joint_from_mesh = DMat4::from_cols_array(bind);
            matrices.push(node_from_world * (world_from_joint * joint_from_mesh));
        }
        Ok(Some(matrices))
    }

    /// Instances of a mesh below a node, one per transform.
    fn add_instances(&mut self, parent: NodeId, mesh: MeshId, places: &[DMat4]) {
        let name = self.scene.nodes[parent.index()].name.clone();
        let mut last = SharedMatrix::default();
        let nodes = places.iter().enumerate().map(|(number, parent_from_node)| {
            let name = format!("{name}_{number}");
            last = SharedMatrix::sharing(parent_from_node, &last);
            Node::root(name, Some(mesh)).at(Some(parent), last.clone())
        });
        self.scene.nodes.extend(nodes);
    }
}
