//! A cluster of which a sample sees a triangle.

use crate::cluster::{Block, Instance, Instances, Numbers, ShadingVertex, corners};
use crate::types::TriangleId;
use luxel_scene::Mesh;

/// A cluster of a frame, of which something is seen.
pub struct SeenCluster<'f> {
    number: u32,
    instance: usize,
    part: usize,
    numbers: Numbers<'f>,
    mesh: &'f Mesh,
    /// Where it is drawn from, if that is kept.
    block: Option<Block<'f>>,
}

impl<'f> SeenCluster<'f> {
    /// The cluster of a triangle.
    #[inline(always)]
    pub(crate) fn new(instances: &'f Instances<'_>, id: TriangleId) -> Self {
        let number = id.cluster();
        let instance = instances.of_cluster(number);
        let within = instances.within_instance(instance, number);
        let Instance { mesh, clusters, .. } = instances.list[instance];
        Self {
            number,
            instance,
            part: clusters.headers[within].part as usize,
            numbers: clusters.numbers(within),
            mesh,
            block: clusters.kept(within),
        }
    }

    /// Whether a triangle belongs to it.
    #[must_use]
    #[inline(always)]
    pub fn holds(&self, id: TriangleId) -> bool {
        id.cluster() == self.number
    }

    /// The instance that it is part of, by its place in the list.
    #[must_use]
    #[inline(always)]
    pub fn instance(&self) -> usize {
        self.instance
    }

    /// The part of the mesh.
    #[must_use]
    #[inline(always)]
    pub fn part(&self) -> usize {
        self.part
    }

    /// The place in the mesh of a triangle that it [`holds`](Self::holds).
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn triangle(&self, id: TriangleId) -> u32 {
        self.numbers.of(id.slot())
    }

    /// The positions of the corners of a triangle that it [`holds`](Self::holds), about the mesh's
    /// origin: from what it was drawn from, which was in the cache then.
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn positions(&self, id: TriangleId) -> [[f32; 3]; 3] {
        match &self.block {
            Some(block) => block.positions(id.slot()),
            None => corners(self.mesh, self.triangle(id)),
        }
    }

    /// What the corners of a triangle that it [`holds`](Self::holds) carry, if that is kept.
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn shading_vertices(&self, id: TriangleId) -> Option<[&'f ShadingVertex; 3]> {
        self.block?.shading_vertices(id.slot())
    }
}
