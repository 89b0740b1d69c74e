//! The tree of nodes, and the numbers by which things of a scene are named.

use glam::DMat4;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub u32);

        impl $name {
            /// The place in its list.
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id!(
    /// A node, by its place in [`Scene::nodes`](crate::Scene::nodes).
    NodeId
);
id!(
    /// A mesh, by its place in [`Scene::meshes`](crate::Scene::meshes).
    MeshId
);
id!(
    /// A material, by its place in [`Scene::materials`](crate::Scene::materials).
    MaterialId
);
id!(
    /// A texture, by its place in [`Scene::textures`](crate::Scene::textures).
    TextureId
);
id!(
    /// A camera, by its place in [`Scene::cameras`](crate::Scene::cameras).
    CameraId
);
id!(
    /// A light, by its place in [`Scene::lights`](crate::Scene::lights).
    LightId
);

/// A place in the hierarchy. Cameras and lights name the node they hang on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Node {
    /// The file's name, or one made of the node's number or the file's stem.
    pub name: String,
    /// The parent; its index may be higher or lower. Never part of a cycle.
    pub parent: Option<NodeId>,
    /// From this node's coordinates to its parent's (to the world's, for a root).
    pub parent_from_node: DMat4,
    /// The mesh to draw.
    pub mesh: Option<MeshId>,
}

impl Node {
    /// A root in world coordinates.
    #[must_use]
    pub fn root(name: impl Into<String>, mesh: Option<MeshId>) -> Self {
        Self { name: name.into(), parent: None, parent_from_node: DMat4::IDENTITY, mesh }
    }
}
