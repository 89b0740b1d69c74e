//! The scene: everything a file (or a demo) holds, in one place.

use crate::extremes::Extremes;
use crate::{
    Background, Bounds, EnvironmentChoice, Mesh, MeshId, Meshes, Node, NodeId, SceneCamera,
    SceneLight, SceneMaterial, SharedMatrix, Texture,
};
use glam::{DMat4, DQuat, DVec3};
use luxel_lighting::Fog;
use std::borrow::Cow;
use std::ops::Range;

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
    /// The background, if the scene has one.
    pub background: Option<Background>,
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
    /// Which of the mesh's [sections](Mesh::sections) it is; 0 for a mesh without any.
    pub section: u32,
    /// From the mesh's coordinates to the world's. Objects that follow one another in the same place
    /// share it.
    pub world_from_mesh: SharedMatrix,
}

impl Object {
    /// Whether it shows the mesh that another one shows, in the same place.
    #[must_use]
    pub fn repeats(&self, other: &Self) -> bool {
        (self.mesh, self.section) == (other.mesh, other.section)
            && self.world_from_mesh.has_bits_of(&other.world_from_mesh.matrix())
    }
}

/// Runs of objects that are drawn as one: sections of one mesh in one place, in their order. All other
/// objects are runs of their own.
pub fn bodies(objects: &[Object]) -> impl Iterator<Item = Range<usize>> {
    let continues = |a: &Object, b: &Object| {
        a.mesh == b.mesh
            && a.section < b.section
            && a.world_from_mesh.is_copy_of(&b.world_from_mesh)
    };
    let mut next = 0;
    objects.chunk_by(continues).map(move |run| {
        let first = next;
        next += run.len();
        first..next
    })
}

impl Scene {
    /// The objects, in the order of their nodes.
    #[must_use]
    pub fn objects(&self) -> Vec<Object> {
        let mut world = self.shared_world_from_nodes();
        let count = self.nodes.iter().filter(|node| node.mesh.is_some()).count();
        let mut objects = Vec::with_capacity(count);
        for (index, node) in self.nodes.iter().enumerate() {
            if let Some(mesh) = node.mesh {
                objects.push(Object {
                    node: NodeId(index as u32),
                    mesh,
                    section: node.section,
                    world_from_mesh: std::mem::take(&mut world[index]).unwrap_or_default(),
                });
            }
        }
        objects
    }

    /// The mesh of an object: the scene's own, or a copy of the object's section.
    ///
    /// # Panics
    /// If the object is of another scene.
    #[must_use]
    pub fn mesh_of(&self, object: &Object) -> Cow<'_, Mesh> {
        self.meshes[object.mesh.index()].section(object.section)
    }

    /// From a node's coordinates to the world's.
    ///
    /// # Panics
    /// If there is no such node.
    #[must_use]
    pub fn world_from_node(&self, node: NodeId) -> DMat4 {
        let parent = |&node: &NodeId| self.nodes[node.index()].parent;
        let chain: Vec<_> = std::iter::successors(Some(node), parent).collect();
        let own = |node: &NodeId| self.nodes[node.index()].parent_from_node.matrix();
        chain.iter().rev().map(own).fold(DMat4::IDENTITY, |world, own| world * own)
    }

    /// From each node's coordinates to the world's.
    #[must_use]
    pub fn world_from_nodes(&self) -> Vec<DMat4> {
        let shared = self.shared_world_from_nodes();
        shared.into_iter().map(|world| world.unwrap_or_default().matrix()).collect()
    }

    /// From each node's coordinates to the world's, one for each. Nodes that follow one another in the same place
    /// share one, and those whose parents change nothing have their own.
    fn shared_world_from_nodes(&self) -> Vec<Option<SharedMatrix>> {
        let mut world: Vec<Option<SharedMatrix>> = vec![None; self.nodes.len()];
        let mut chain = Vec::new();
        let mut last = SharedMatrix::default();
        for start in 0..self.nodes.len() {
            // Climb to the nearest ancestor whose place is known, then come down again.
            let mut next = Some(start);
            let mut base = DMat4::IDENTITY;
            while let Some(index) = next {
                if let Some(known) = &world[index] {
                    base = known.matrix();
                    break;
                }
                chain.push(index);
                next = self.nodes[index].parent.map(NodeId::index);
            }
            for index in chain.drain(..).rev() {
                let own = &self.nodes[index].parent_from_node;
                base *= own.matrix();
                let is_base = |known: &&SharedMatrix| known.has_bits_of(&base);
                let known = [&last, own].into_iter().find(is_base).cloned();
                last = known.unwrap_or_else(|| SharedMatrix::sharing(&base, &last));
                world[index] = Some(last.clone());
            }
        }
        world
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

    /// The bounds of an object in world space; empty if it draws nothing.
    ///
    /// # Panics
    /// If the object is of another scene.
    #[must_use]
    pub fn bounds_of_object(&self, object: &Object) -> Bounds {
        let mesh = &self.meshes[object.mesh.index()];
        if mesh.sections.is_empty() {
            self.meshes.bounds_of(object.mesh, &object.world_from_mesh.matrix())
        } else {
            mesh.section(object.section).bounds(&object.world_from_mesh.matrix())
        }
    }

    /// The bounds of some objects in world space.
    #[must_use]
    pub fn bounds_of(&self, objects: &[Object]) -> Bounds {
        self.extremes(objects, &|world_from_mesh| *world_from_mesh).bounds(&mut Default::default())
    }

    /// How low some objects reach: the least up.p of their drawn points, for `up` of unit length; infinite
    /// if they draw nothing.
    #[must_use]
    pub fn lowest_of(&self, objects: &[Object], up: DVec3) -> f64 {
        let is_axis = up.abs().to_array().iter().filter(|side| **side > 0.0).count() == 1;
        let turn = if is_axis { DQuat::IDENTITY } else { DQuat::from_rotation_arc(up, DVec3::Y) };
        let along = if is_axis { up } else { DVec3::Y };
        let turned = DMat4::from_quat(turn);
        let extremes = self.extremes(objects, &|world_from_mesh| turned * *world_from_mesh);
        let Bounds { min, max } = extremes.bounds(&mut Default::default());
        (along * min).min(along * max).dot(along.abs())
    }

    /// The drawn points of objects in another space. Sections of one mesh in one place are taken
    /// together.
    pub(crate) fn extremes(
        &self,
        objects: &[Object],
        target_from_mesh: &dyn Fn(&DMat4) -> DMat4,
    ) -> Extremes<'_> {
        let of_bodies = bodies(objects).map(|body| {
            let Object { mesh, world_from_mesh, .. } = &objects[body.start];
            let (mesh, tree) = self.meshes.with_tree(*mesh);
            (mesh, tree, target_from_mesh(&world_from_mesh.matrix()))
        });
        Extremes::of_objects(of_bodies)
    }

    /// Whether there is nothing to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let is_empty =
            |node: &Node| node.mesh.is_none_or(|mesh| self.meshes[mesh.index()].is_empty());
        self.nodes.iter().all(is_empty)
    }

    /// The triangles of all objects, a mesh counted as often as it is shown.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        let of = |node: &Node| {
            let mesh = &self.meshes[node.mesh?.index()];
            Some(mesh.range_of(node.section).triangles.len() as u64)
        };
        self.nodes.iter().filter_map(of).sum()
    }
}
