//! A cluster of which a sample sees a triangle.

use crate::cluster::{
    Block, CLUSTER_VERTICES, Clusters, Instance, Instances, ShadingVertex, corners,
};
use crate::types::TriangleId;
use luxel_math::{LANES, Lanes};
use luxel_scene::Mesh;

/// A cluster of a frame, of which something is seen.
pub struct SeenCluster<'f> {
    instance: usize,
    mesh: &'f Mesh,
    clusters: &'f Clusters,
    /// Its number among them.
    within: usize,
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
        Self { instance, mesh, clusters, within, block: clusters.kept(within) }
    }

    /// The lanes, as bits, whose triangles belong to the cluster of `id`; `simd` selects the lane type.
    #[must_use]
    #[inline(always)]
    pub fn lanes_of<N: Lanes>(simd: N, ids: &[u32; LANES], id: TriangleId) -> u32 {
        let mut clusters = [0; LANES];
        for (cluster, &id) in clusters.iter_mut().zip(ids) {
            *cluster = TriangleId(id).cluster();
        }
        simd.eq_mask(&clusters, id.cluster())
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
        self.clusters.headers[self.within].part as usize
    }

    /// The place in the mesh of a triangle of it.
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn triangle(&self, id: TriangleId) -> u32 {
        self.clusters.numbers(self.within).of(id.slot())
    }

    /// The positions of the corners of a triangle of it, about the mesh's
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

    /// What the corners of its triangles carry, if that is kept.
    #[must_use]
    #[inline(always)]
    pub fn shading_corners(&self) -> Option<ShadingCorners<'f>> {
        let Block { triangles, shading_vertices, .. } = self.block?;
        shading_vertices.map(|vertices| ShadingCorners { triangles, vertices })
    }
}

/// What the corners of a cluster's triangles carry.
#[derive(Clone, Copy)]
pub struct ShadingCorners<'f> {
    triangles: &'f [u32],
    vertices: &'f [ShadingVertex; CLUSTER_VERTICES],
}

impl<'f> ShadingCorners<'f> {
    /// Of a triangle of the cluster.
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn of(&self, id: TriangleId) -> [&'f ShadingVertex; 3] {
        let word = self.triangles[id.slot()];
        let of = |corner: u32| &self.vertices[(corner & 255) as usize];
        [of(word), of(word >> 8), of(word >> 16)]
    }
}
