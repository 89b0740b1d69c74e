//! The fill rule for one sample and the triangles of a cluster.

use super::point_coverage::Probe;
use super::seen_cluster::SeenCluster;
use crate::cluster::{ClusterRanks, Instances};
use crate::types::{CullFaces, TriangleId};

/// A cluster of a frame before the camera, whose triangles are tested for a sample.
pub(crate) struct ProbedCluster<'f> {
    cluster: SeenCluster<'f>,
    probe: Probe,
    cull: CullFaces,
    ranks: ClusterRanks<'f>,
}

impl<'f> ProbedCluster<'f> {
    /// A cluster by its number among those of all instances.
    pub(crate) fn new(instances: &'f Instances<'_>, number: u32) -> Self {
        let cluster = SeenCluster::new(instances, TriangleId::new(number, 0));
        let instance = cluster.instance();
        Self {
            cluster,
            probe: Probe::of(instances.window_from_local(instance)),
            cull: instances.part_use(number).cull,
            ranks: instances.ranks(instance, instances.within_instance(instance, number)),
        }
    }

    /// [`Probe::covers`] of a triangle of it.
    pub(crate) fn covers(&self, id: TriangleId, position: [i32; 2]) -> Option<f32> {
        let (corners, rank) = (self.cluster.positions(id), self.ranks.of(id.slot()));
        self.probe.covers(corners, self.cull, rank, position)
    }
}
