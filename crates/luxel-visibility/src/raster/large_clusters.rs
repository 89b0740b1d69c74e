//! Clusters of large triangles: transformed and set up once a frame, and binned triangle by triangle.
//!
//! A cluster is transformed and sifted again in every tile that it reaches, which is next to nothing
//! where it reaches one or two. One that reaches many has large triangles: each reaches few of these
//! tiles, and many tiles of the cluster's box see none. So these triangles are kept for the frame,
//! nearest first, and tiles that none of them reaches stay empty: they are neither cleared nor shaded.
//! 1 020 triangles in 1920x1080 take 11.7 million instructions instead of 14.2.

use super::setup::Triangle;
use super::tile::corners_of;
use super::transform::{ClusterVertices, transform_cluster};
use crate::cluster::{CLUSTER_TRIANGLES, Instances, TransientBlock};
use crate::cull::{TileLists, Tiles, VisibleCluster, nearest_first};
use crate::types::{Coverage, Region, Samples, TriangleId};
use luxel_math::{Level, dispatch};
use luxel_scene::Size;

/// A cluster that reaches so many tiles has large triangles. With 8, 100 000 triangles in 1920x1080
/// take 54 million instructions, with 12 48, with 16 and 24 45: their clusters are sometimes long.
const LARGE_CLUSTER_TILES: u64 = 24;
/// Clusters that are kept, at most: 13 MiB of triangles.
const MOST_CLUSTERS: usize = 1 << 10;
/// Entries of all tiles together, at most: 16 MiB.
const MOST_ENTRIES: u64 = 1 << 22;
const _: () = assert!(size_of::<LargeTriangle>() * CLUSTER_TRIANGLES * MOST_CLUSTERS <= 13 << 20);

/// A triangle of a cluster that reaches many tiles.
#[derive(Clone, Copy)]
pub(crate) struct LargeTriangle {
    pub(crate) id: TriangleId,
    /// Whether it may have holes.
    pub(crate) has_holes: bool,
    pub(crate) triangle: Triangle,
    tiles: Tiles,
}

/// The triangles of large clusters, nearest first, and for each tile which of them reach it.
pub(crate) struct LargeClusters {
    triangles: Vec<LargeTriangle>,
    /// `None` where there are none.
    lists: Option<TileLists>,
}

impl LargeClusters {
    /// Takes the large ones out of a list of clusters.
    pub(crate) fn taken_from(
        clusters: &mut Vec<VisibleCluster>,
        instances: &Instances<'_>,
        size: Size,
        samples: Samples,
        level: Level,
    ) -> Self {
        let mut large = Vec::new();
        let is_large = |cluster: &VisibleCluster| {
            !cluster.clipped && cluster.tiles().count() >= LARGE_CLUSTER_TILES
        };
        large.extend(clusters.iter().filter(|cluster| is_large(cluster)).take(MOST_CLUSTERS));
        let triangles = luxel_parallel::gather(large.len(), 4, &|run, triangles| {
            let mut vertices = ClusterVertices::new();
            for &cluster in &large[run] {
                set_up(cluster, instances, size, samples, level, &mut vertices, triangles);
            }
        });
        let triangles = nearest_first(&triangles, |large| large.triangle.depth.high);
        let tiles = triangles.iter().map(|large| large.tiles);
        let lists = TileLists::new(tiles, size, MOST_ENTRIES).filter(|_| !large.is_empty());
        if lists.is_some() {
            let last = large.last().map_or(0, |cluster| cluster.cluster);
            clusters.retain(|cluster| !is_large(cluster) || cluster.cluster > last);
        }
        Self { triangles, lists }
    }

    /// The triangles that reach a tile, nearest first.
    pub(crate) fn of_tile(&self, tile: usize) -> impl Iterator<Item = &LargeTriangle> {
        let listed = self.lists.as_ref().map_or(&[][..], |lists| lists.of_tile(tile));
        listed.iter().map(|&number| &self.triangles[number as usize])
    }

    /// How many triangles reach a tile.
    pub(crate) fn load(&self, tile: usize) -> u32 {
        self.lists.as_ref().map_or(0, |lists| lists.of_tile(tile).len() as u32)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.lists.is_none()
    }
}

/// Appends the triangles of a cluster that have an area, on a side that is drawn, and samples of the
/// window in their boxes.
fn set_up(
    visible: &VisibleCluster,
    instances: &Instances<'_>,
    size: Size,
    samples: Samples,
    level: Level,
    vertices: &mut ClusterVertices,
    triangles: &mut Vec<LargeTriangle>,
) {
    let mut transient = TransientBlock::new();
    let number = instances.of_cluster(visible.cluster);
    let instance = &instances.list[number];
    let cluster = instances.within_instance(number, visible.cluster);
    let block = instance.clusters.block(instance.mesh, cluster, &mut transient);
    let part = instances.part_use(visible.cluster);
    let ranks = instances.ranks(number, cluster);
    let transform = instances.window_from_local(number);
    dispatch!(level, simd => transform_cluster(simd, &transform, block.vertices, [0; 2], vertices));
    let window = Region::whole(size);
    for (slot, &word) in block.triangles.iter().enumerate() {
        let corners = corners_of(word).map(|corner| vertices.vertex(corner));
        let Some(triangle) = Triangle::new(corners, part.cull) else { continue };
        let triangle = triangle.with_rank(ranks.of(slot));
        let mut reached: Option<[i32; 4]> = None;
        for &offset in samples.positions() {
            let Some(pixels) = triangle.pixels(window, offset) else { continue };
            let [left, top, right, bottom] = pixels.sides();
            let [l, t, r, b] = reached.unwrap_or([left, top, right, bottom]);
            reached = Some([l.min(left), t.min(top), r.max(right), b.max(bottom)]);
        }
        if let Some(pixels) = reached {
            triangles.push(LargeTriangle {
                id: TriangleId::new(visible.cluster, slot),
                has_holes: part.coverage != Coverage::Opaque,
                triangle,
                tiles: Tiles::of_pixels(pixels.map(|pixel| pixel as u16)),
            });
        }
    }
}
