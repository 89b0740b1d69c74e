//! The scene: everything a file (or a demo) holds, in one place.

use crate::extremes::Extremes;
use crate::{
    Bounds, EnvironmentChoice, MeshId, Meshes, Node, NodeId, SceneCamera, SceneLight,
    SceneMaterial, Texture,
};
use glam::{DMat4, DVec3};
use luxel_lighting::Fog;

/// Everything that can be drawn, lit and picked.
///
/// Only nodes that belong to the shown scene are listed, parents and children in the order of a
/// walk of the tree, so that the order of objects is the order of drawing.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The tree.
    pub nodes: Vec<Node>,
    /// Meshes; several nodes may show one.
    pub meshes: Meshes,
    /// Materials; there is at least one if there is a mesh.
    pub materials: Vec<SceneMaterial>,
    /// Textures.
    pub textures: Vec<Texture>,
    /// Cameras, in the file's order.
    pub cameras: Vec<SceneCamera>,
    /// Lights, in the file's order.
    pub lights: Vec<SceneLight>,
    /// The environment, if the scene has one.
    pub environment: Option<EnvironmentChoice>,
    /// I_a: the scene's ambient light, if it has one.
    pub ambient: Option<[f32; 3]>,
    /// Depth cueing, if there is any.
    pub fog: Option<Fog>,
    /// The background, if the scene has one: linear red, green, blue, and alpha.
    pub background: Option<[f32; 4]>,
    /// The direction that is up: +Y, +Z for STL.
    pub up: DVec3,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            nodes: Vec::new(),
            meshes: Meshes::default(),
            materials: Vec::new(),
            textures: Vec::new(),
            cameras: Vec::new(),
            lights: Vec::new(),
            environment: None,
            ambient: None,
            fog: None,
            background: None,
            up: DVec3::Y,
        }
    }
}

/// A node with a mesh: the unit that `info` lists, layers number and picks return.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// The node.
    pub node: NodeId,
    /// Its mesh.
    pub mesh: MeshId,
    /// From the mesh's coordinates to the world's.
    pub world_from_mesh: DMat4,
}

impl Scene {
    /// The objects, in the order of their nodes.
    #[must_use]
    pub fn objects(&self) -> Vec<Object> {
        let world = self.world_from_nodes();
        let with_mesh = |(index, node): (usize, &Node)| {
            node.mesh.map(|mesh| Object {
                node: NodeId(index as u32),
                mesh,
                world_from_mesh: world[index],
            })
        };
        let count = self.nodes.iter().filter(|node| node.mesh.is_some()).count();
        let mut objects = Vec::with_capacity(count);
        objects.extend(self.nodes.iter().enumerate().filter_map(with_mesh));
        objects
    }

    /// From a node's coordinates to the world's.
    ///
    /// # Panics
    /// If there is no such node.
    #[must_use]
    pub fn world_from_node(&self, node: NodeId) -> DMat4 {
        let parent = |&node: &NodeId| self.nodes[node.index()].parent;
        let chain: Vec<_> = std::iter::successors(Some(node), parent).collect();
        let own = |node: &NodeId| self.nodes[node.index()].parent_from_node;
        chain.iter().rev().map(own).fold(DMat4::IDENTITY, |world, own| world * own)
    }

    /// From each node's coordinates to the world's.
    #[must_use]
    pub fn world_from_nodes(&self) -> Vec<DMat4> {
        let mut world: Vec<Option<DMat4>> = vec![None; self.nodes.len()];
        for start in 0..self.nodes.len() {
            // Climb to the nearest ancestor whose place is known, then come down again.
            let mut chain = Vec::new();
            let mut next = Some(start);
            let mut base = DMat4::IDENTITY;
            while let Some(index) = next {
                if let Some(known) = world[index] {
                    base = known;
                    break;
                }
                chain.push(index);
                next = self.nodes[index].parent.map(NodeId::index);
            }
            for index in chain.into_iter().rev() {
                base *= self.nodes[index].parent_from_node;
                world[index] = Some(base);
            }
        }
        world.into_iter().map(Option::unwrap_or_default).collect()
    }

    /// The names from the root down to a node.
    #[must_use]
    pub fn path(&self, node: NodeId) -> Vec<&str> {
        let mut path = Vec::new();
        let mut next = Some(node);
        while let Some(id) = next {
            let node = &self.nodes[id.index()];
            path.push(node.name.as_str());
            next = node.parent;
        }
        path.reverse();
        path
    }

    /// The bounds of everything drawn, in world space.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds_of(&self.objects())
    }

    /// The bounds of some objects in world space.
    pub(crate) fn bounds_of(&self, objects: &[Object]) -> Bounds {
        let points = Extremes::of_objects(objects.iter().map(|object| {
            let (mesh, tree) = self.meshes.with_tree(object.mesh);
            (mesh, tree, object.world_from_mesh)
        }));
        points.bounds(&mut Default::default())
    }

    /// Whether there is nothing to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.objects().iter().all(|object| self.meshes[object.mesh.index()].is_empty())
    }

    /// The triangles of all objects, a mesh counted as often as it is shown.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        let of = |object: &Object| self.meshes[object.mesh.index()].triangles.len() as u64;
        self.objects().iter().map(of).sum()
    }
}
