//! The meshes of a scene, with cached measurements.

use crate::extremes::Extremes;
use crate::point_tree::PointTree;
use crate::{Bounds, Mesh, MeshId};
use glam::DMat4;
use luxel_parallel::Memo;
use std::fmt;
use std::ops::{Deref, DerefMut};
use std::sync::{Arc, OnceLock};

/// The meshes of a scene: a `Vec` with cached measurements.
///
/// Bounds and fitted views need the outermost points of meshes. The first of them builds a small
/// tree of boxes for each mesh, of 2 to 6 bytes a position; the next find the same bits by it in
/// some microseconds. Copies share the trees.
///
/// It is used as the `Vec` that it derefs to. Whoever borrows that mutably, for whatever purpose,
/// drops all trees, and nothing else can change a mesh: trees always fit.
///
/// ```
/// use luxel_scene::{Meshes, MeshId, DMat4, primitives, DVec3};
///
/// let mut meshes: Meshes = vec![primitives::cuboid(DVec3::ONE)].into();
/// assert_eq!(meshes.bounds_of(MeshId(0), &DMat4::IDENTITY).max, DVec3::splat(0.5));
/// for position in &mut meshes[0].positions {
///     position[1] += 3.0;
/// }
/// assert_eq!(meshes.bounds_of(MeshId(0), &DMat4::IDENTITY).max.y, 3.5);
/// ```
#[derive(Clone, Default)]
pub struct Meshes {
    list: Vec<Mesh>,
    /// A tree of each mesh. Lists share them only while they hold the same meshes.
    trees: OnceLock<Arc<[Memo<PointTree>]>>,
}

impl Meshes {
    /// The bounds of everything that a mesh draws, in another space; empty if there is nothing.
    ///
    /// # Panics
    /// If there is no such mesh.
    #[must_use]
    pub fn bounds_of(&self, mesh: MeshId, world_from_mesh: &DMat4) -> Bounds {
        let (mesh, tree) = self.with_tree(mesh);
        let object = std::iter::once((mesh, tree, *world_from_mesh));
        Extremes::of_objects(object).bounds(&mut Default::default())
    }

    /// A mesh, with the tree over its drawn points.
    pub(crate) fn with_tree(&self, mesh: MeshId) -> (&Mesh, &PointTree) {
        let index = mesh.index();
        let trees = self.trees.get_or_init(|| self.list.iter().map(|_| Memo::new()).collect());
        let (mesh, tree) = (&self.list[index], &trees[index]);
        (mesh, tree.get_or_compute(|| PointTree::new(mesh)))
    }

    #[cfg(test)]
    fn has_trees(&self) -> bool {
        self.trees.get().is_some_and(|trees| trees.iter().any(|tree| tree.get().is_some()))
    }
}

impl Deref for Meshes {
    type Target = Vec<Mesh>;

    fn deref(&self) -> &Vec<Mesh> {
        &self.list
    }
}

impl DerefMut for Meshes {
    /// Drops the cached measurements.
    fn deref_mut(&mut self) -> &mut Vec<Mesh> {
        self.trees = OnceLock::new();
        &mut self.list
    }
}

impl fmt::Debug for Meshes {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.list.fmt(formatter)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Meshes {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.list.serialize(serializer)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Meshes {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Vec::deserialize(deserializer).map(Self::from)
    }
}

impl PartialEq for Meshes {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list
    }
}

impl From<Vec<Mesh>> for Meshes {
    fn from(list: Vec<Mesh>) -> Self {
        Self { list, trees: OnceLock::new() }
    }
}

impl From<Meshes> for Vec<Mesh> {
    fn from(meshes: Meshes) -> Self {
        meshes.list
    }
}

impl FromIterator<Mesh> for Meshes {
    fn from_iter<I: IntoIterator<Item = Mesh>>(meshes: I) -> Self {
        Vec::from_iter(meshes).into()
    }
}

impl IntoIterator for Meshes {
    type Item = Mesh;
    type IntoIter = std::vec::IntoIter<Mesh>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter()
    }
}

impl<'a> IntoIterator for &'a Meshes {
    type Item = &'a Mesh;
    type IntoIter = std::slice::Iter<'a, Mesh>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}

impl<'a> IntoIterator for &'a mut Meshes {
    type Item = &'a mut Mesh;
    type IntoIter = std::slice::IterMut<'a, Mesh>;

    /// Drops the cached measurements.
    fn into_iter(self) -> Self::IntoIter {
        (**self).iter_mut()
    }
}

#[cfg(test)]
mod tests;
