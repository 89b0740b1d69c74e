//! The tree of nodes, and the numbers by which things of a scene are named.

use crate::{Name, SharedMatrix};

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Node {
    /// The file's name, or one made of the node's number or the file's stem.
    pub name: Name,
    /// The parent; its index may be higher or lower. Never part of a cycle.
    pub parent: Option<NodeId>,
    /// From this node's coordinates to its parent's (to the world's, for a root).
    ///
    /// Nodes may share it: in files of many small objects all are in the same place.
    pub parent_from_node: SharedMatrix,
    /// The mesh to draw.
    pub mesh: Option<MeshId>,
    /// Which of the mesh's [sections](crate::Mesh::sections) it shows; 0 for a mesh without any.
    pub section: u32,
}

impl Node {
    /// A root in world coordinates.
    #[must_use]
    pub fn root(name: impl Into<Name>, mesh: Option<MeshId>) -> Self {
        let parent_from_node = SharedMatrix::default();
        Self { name: name.into(), parent: None, parent_from_node, mesh, section: 0 }
    }

    /// The same node in another place.
    #[must_use]
    pub fn at(self, parent: Option<NodeId>, parent_from_node: impl Into<SharedMatrix>) -> Self {
        Self { parent, parent_from_node: parent_from_node.into(), ..self }
    }
}
