//! Instances of meshes before a camera, and the numbers of their clusters and triangles.
//!
//! Clusters are numbered through all instances; an id holds such a number and a slot.

use super::block::Numbers;
use super::clusters::Clusters;
use super::window_transforms::WindowTransforms;
use crate::types::{Coverage, PartUse, SLOT_BITS, TriangleId, ViewFromLocal, WindowTransform};
use luxel_scene::{Mesh, Projection, Size, rank_of};
use std::sync::Arc;

/// A mesh in its place.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The mesh, cut into clusters.
    pub clusters: &'a Clusters,
    /// From the mesh's coordinates about its origin to the camera's.
    pub view_from_local: &'a ViewFromLocal,
    /// How each part of the mesh is drawn.
    pub parts: Arc<[PartUse]>,
    /// The triangles that lie in the plane of an earlier instance's, and their
    /// [ranks](luxel_scene::CoplanarRanks): by their places in the mesh, in ascending order.
    pub ranks: &'a [(u32, u8)],
    /// Whether it [repeats](crate::PlacedScene::is_repeated) the instance before it, and isn't drawn.
    pub is_repeated: bool,
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

/// The ranks of a cluster's triangles.
#[derive(Clone, Copy)]
pub(crate) struct ClusterRanks<'a> {
    numbers: Numbers<'a>,
    ranks: &'a [(u32, u8)],
}

impl ClusterRanks<'_> {
    /// The rank of the triangle in a slot.
    #[inline(always)]
    pub(crate) fn of(&self, slot: usize) -> u8 {
        if self.ranks.is_empty() { 0 } else { rank_of(self.ranks, self.numbers.of(slot)) }
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
    /// To the window: one for all instances that follow one another in the same place.
    transforms: WindowTransforms,
    transform_of: Vec<u32>,
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
        // A list that grows leaves the memory of its shorter lengths behind.
        let mut first_clusters = Vec::with_capacity(list.len() + 1);
        first_clusters.push(0);
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
        let mut transforms = WindowTransforms::with_capacity(list.len());
        let mut transform_of = Vec::with_capacity(list.len());
        let mut before: Option<&Instance<'_>> = None;
        for instance in &list {
            let view_from_local = instance.view_from_local;
            if before.is_none_or(|before| before.view_from_local != view_from_local) {
                transforms.push(&WindowTransform::new(projection, size, &view_from_local.matrix()));
            }
            transform_of.push(transforms.len() as u32 - 1);
            before = Some(instance);
        }
        transforms.shrink_to_fit();
        Ok(Self { list, transforms, transform_of, first_clusters })
    }

    /// The place of an instance's transforms among them.
    #[inline]
    pub(crate) fn transform_of(&self, instance: usize) -> usize {
        self.transform_of[instance] as usize
    }

    /// From an instance's coordinates to the window.
    #[inline]
    pub(crate) fn window_from_local(&self, instance: usize) -> WindowTransform {
        self.transforms.get(self.transform_of(instance))
    }

    /// Whether a cluster of an instance, by its number within it, repeats the one before it where nothing
    /// shows through.
    pub(crate) fn is_cluster_repeated(&self, instance: usize, within: usize) -> bool {
        let Instance { clusters, parts, .. } = &self.list[instance];
        if !clusters.is_repeated(within) {
            return false;
        }
        let [before, own] = [within - 1, within].map(|cluster| {
            (parts[clusters.headers[cluster].part as usize], self.ranks(instance, cluster))
        });
        let slots = 0..usize::from(clusters.headers[within].triangles);
        before.0 == own.0
            && own.0.coverage == Coverage::Opaque
            && slots.into_iter().all(|slot| before.1.of(slot) == own.1.of(slot))
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

    /// The ranks of a cluster's triangles.
    #[inline(always)]
    pub(crate) fn ranks(&self, instance: usize, within: usize) -> ClusterRanks<'_> {
        let Instance { clusters, ranks, .. } = &self.list[instance];
        ClusterRanks { numbers: clusters.numbers(within), ranks }
    }

    /// How the part of a cluster is drawn.
    pub(crate) fn part_use(&self, cluster: u32) -> PartUse {
        let instance = self.of_cluster(cluster);
        let within = self.within_instance(instance, cluster);
        let Instance { clusters, parts, .. } = &self.list[instance];
        parts[clusters.headers[within].part as usize]
    }
}
