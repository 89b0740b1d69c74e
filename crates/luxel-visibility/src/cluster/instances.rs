//! Instances of meshes before a camera, and the numbers of their clusters and triangles.
//!
//! Clusters are numbered through all instances; an id holds such a number and a slot.

use super::clusters::Clusters;
use crate::types::{Coverage, PartUse, SLOT_BITS, TriangleId, WindowTransform};
use glam::DMat4;
use luxel_scene::{Mesh, Projection, Size};

/// A mesh in its place.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The mesh, cut into clusters.
    pub clusters: &'a Clusters,
    /// From the mesh's own space to the camera's.
    pub view_from_mesh: DMat4,
    /// How each part of the mesh is drawn.
    pub parts: Vec<PartUse>,
}

/// A triangle by what a scene calls it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleOf {
    /// The instance, by its place in the list.
    pub instance: usize,
    /// The triangle, by its place in the mesh.
    pub triangle: u32,
    /// The part of the mesh.
    pub part: usize,
}

impl Instance<'_> {
    /// From coordinates about the mesh's origin to view space.
    pub(crate) fn view_from_local(&self) -> DMat4 {
        self.view_from_mesh * DMat4::from_translation(self.mesh.origin)
    }
}

/// More clusters than ids can number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the scene has {clusters} clusters of triangles; ids can tell {limit} apart")]
pub struct TooManyTriangles {
    /// Clusters of all instances.
    pub clusters: u64,
    /// The most.
    pub limit: u64,
}

/// The instances of a view.
pub(crate) struct Instances<'a> {
    pub(crate) list: Vec<Instance<'a>>,
    /// From each instance's coordinates to the window.
    pub(crate) transforms: Vec<WindowTransform>,
    /// The number of each instance's first cluster, and after them the number of all.
    pub(crate) first_clusters: Vec<u32>,
}

impl<'a> Instances<'a> {
    /// Numbers the clusters of all instances.
    pub(crate) fn new(
        list: Vec<Instance<'a>>,
        projection: &Projection,
        size: Size,
    ) -> Result<Self, TooManyTriangles> {
        let mut first_clusters = vec![0];
        let mut clusters = 0_u64;
        // The highest number of all stands for nothing.
        let limit = (1 << (u32::BITS - SLOT_BITS)) - 1;
        for instance in &list {
            clusters += instance.clusters.count() as u64;
            first_clusters.push(clusters.min(limit) as u32);
        }
        if clusters > limit {
            return Err(TooManyTriangles { clusters, limit });
        }
        let transforms = list
            .iter()
            .map(|instance| WindowTransform::new(projection, size, &instance.view_from_local()))
            .collect();
        Ok(Self { list, transforms, first_clusters })
    }

    /// Whether an instance repeats the one before it where nothing shows through: it is hidden wherever it
    /// is, as of equally near triangles the first one wins.
    ///
    /// So thousands of nodes that show one mesh in one place, a file of some kilobytes, cost one of them.
    pub(crate) fn is_repeated(&self, instance: usize) -> bool {
        let Some(before) = instance.checked_sub(1).map(|before| &self.list[before]) else {
            return false;
        };
        let own = &self.list[instance];
        std::ptr::eq(own.mesh, before.mesh)
            && own.view_from_mesh == before.view_from_mesh
            && own.parts == before.parts
            && own.parts.iter().all(|part| part.coverage == Coverage::Opaque)
    }

    /// The instance that a cluster belongs to.
    #[inline]
    pub(crate) fn of_cluster(&self, cluster: u32) -> usize {
        if self.list.len() == 1 {
            return 0;
        }
        self.first_clusters.partition_point(|&first| first <= cluster) - 1
    }

    /// A cluster's number within its instance.
    pub(crate) fn within_instance(&self, instance: usize, cluster: u32) -> usize {
        (cluster - self.first_clusters[instance]) as usize
    }

    /// The instance and the triangle of an id; `None` for [`TriangleId::NONE`].
    pub(crate) fn triangle(&self, id: TriangleId) -> Option<TriangleOf> {
        if id == TriangleId::NONE {
            return None;
        }
        let instance = self.of_cluster(id.cluster());
        let clusters = self.list[instance].clusters;
        let cluster = (id.cluster() - self.first_clusters[instance]) as usize;
        let triangle = clusters.original(cluster, id.slot());
        Some(TriangleOf { instance, triangle, part: clusters.headers[cluster].part as usize })
    }

    /// All triangles of all instances: instance by instance, in the order of clusters.
    pub(crate) fn triangle_ids(&self) -> impl Iterator<Item = TriangleId> + '_ {
        self.list.iter().zip(&self.first_clusters).flat_map(|(instance, &first)| {
            let headers = (first..).zip(&instance.clusters.headers);
            headers.flat_map(|(cluster, header)| {
                (0..usize::from(header.triangles)).map(move |slot| TriangleId::new(cluster, slot))
            })
        })
    }

    /// The triangles of a cluster.
    pub(crate) fn triangles_of(&self, cluster: u32) -> impl Iterator<Item = TriangleId> {
        let number = self.of_cluster(cluster);
        let header = &self.list[number].clusters.headers[self.within_instance(number, cluster)];
        (0..usize::from(header.triangles)).map(move |slot| TriangleId::new(cluster, slot))
    }

    /// The place of a triangle in the order in which triangles were submitted.
    pub(crate) fn submitted(&self, id: TriangleId) -> u64 {
        self.triangle(id).map_or(u64::MAX, |of| (of.instance as u64) << 32 | u64::from(of.triangle))
    }

    /// How the part of a cluster is drawn.
    pub(crate) fn part_use(&self, cluster: u32) -> PartUse {
        let instance = self.of_cluster(cluster);
        let within = self.within_instance(instance, cluster);
        let Instance { clusters, parts, .. } = &self.list[instance];
        parts[clusters.headers[within].part as usize]
    }
}
