//! Draws a list of clusters into one tile of depths and ids.

use super::buffer::{Plane, Tile};
use super::clip::clip;
use super::large_clusters::LargeTriangle;
use super::rules::Rules;
use super::sample_cull::{SIZES, TriangleGroup};
use super::setup::Triangle;
use super::small_samples::BufferSink;
use super::small_triangles::{Queues, SampleGrid};
use super::tile_points;
use super::transform::{ClusterVertices, transform_cluster};
use super::triangles::draw_triangle;
use crate::cluster::{Block, ClusterRanks, Instances, TransientBlock};
use crate::cull::VisibleCluster;
use crate::types::{ClipVertex, Coverage, CullFaces, Holes, Samples, TriangleId, WindowTransform};
use luxel_math::{LANES, Simd};

/// What clusters are drawn by.
pub(crate) struct View<'f> {
    pub(crate) instances: &'f Instances<'f>,
    pub(crate) samples: Samples,
    pub(crate) holes: &'f dyn Holes,
    /// Only what lies behind these samples counts.
    pub(crate) behind: Option<&'f [Plane]>,
}

/// Draws large triangles and clusters, each nearest first, into a tile.
#[inline(always)]
pub(crate) fn draw<'f, S: Simd>(
    simd: S,
    view: &View<'f>,
    large: impl Iterator<Item = &'f LargeTriangle>,
    clusters: impl Iterator<Item = &'f VisibleCluster>,
    tile: &mut Tile,
) {
    let &View { instances, samples, holes, behind } = view;
    let submitted = |id: TriangleId| instances.submitted(id);
    let rules_for = |has_holes: bool| Rules {
        offsets: samples.positions(),
        submitted: &submitted,
        holes: has_holes.then_some(holes),
        behind,
    };
    for LargeTriangle { id, has_holes, triangle, .. } in large {
        draw_triangle(simd, triangle, *id, &rules_for(*has_holes), tile);
    }
    let mut transient = TransientBlock::new();
    let mut vertices = ClusterVertices::new();
    // Small triangles wait here across clusters, as long as the same rules hold for them.
    let mut queues = Queues::new(TriangleId::NONE);
    let mut rules = rules_for(false);
    let middle = tile_points::middle_of(tile.region);
    for visible in clusters {
        let pixels = [visible.left, visible.top, visible.right, visible.bottom].map(i32::from);
        if tile.occludes(simd, pixels, visible.nearest) {
            continue;
        }
        let number = instances.of_cluster(visible.cluster);
        let instance = &instances.list[number];
        let cluster = instances.within_instance(number, visible.cluster);
        let block = instance.clusters.block(instance.mesh, cluster, &mut transient);
        let part = instance.parts[instance.clusters.headers[cluster].part as usize];
        let has_holes = part.coverage != Coverage::Opaque;
        if has_holes != rules.holes.is_some() {
            finish(simd, &mut queues, &rules, tile);
            rules = rules_for(has_holes);
        }
        let transform = instances.window_from_local(number);
        let drawn = DrawnCluster {
            number: visible.cluster,
            block,
            cull: part.cull,
            ranks: instances.ranks(number, cluster),
        };
        if visible.clipped {
            draw_clipped(simd, &transform, &drawn, &rules, tile);
        } else {
            let bounds =
                transform_cluster(simd, &transform, drawn.block.vertices, middle, &mut vertices);
            // Bounds of the vertices themselves are tighter than those of the cluster's box.
            if tile.occludes(simd, bounds.pixels, bounds.nearest) {
                continue;
            }
            let waits = draw_cluster(simd, &vertices, &drawn, &rules, &mut queues, tile);
            if waits {
                tile.touch(bounds.pixels);
            }
        }
    }
    finish(simd, &mut queues, &rules, tile);
}

/// Draws the small triangles that still wait.
#[inline(always)]
fn finish<S: Simd>(simd: S, queues: &mut Queues<TriangleId>, rules: &Rules<'_>, tile: &mut Tile) {
    let grid = SampleGrid { region: tile.region, offsets: rules.offsets };
    queues.finish(simd, grid, &mut BufferSink { rules, tile });
}

/// The three corner numbers of a triangle's word.
#[inline(always)]
pub(super) fn corners_of(word: u32) -> [usize; 3] {
    [(word & 255) as usize, (word >> 8 & 255) as usize, (word >> 16 & 255) as usize]
}

/// A cluster with what its triangles are drawn by.
struct DrawnCluster<'a> {
    number: u32,
    block: Block<'a>,
    cull: CullFaces,
    ranks: ClusterRanks<'a>,
}

/// Draws a cluster that needs no clipping; whether small triangles of it went into queues.
#[inline(always)]
fn draw_cluster<S: Simd>(
    simd: S,
    vertices: &ClusterVertices,
    cluster: &DrawnCluster<'_>,
    rules: &Rules<'_>,
    queues: &mut Queues<TriangleId>,
    tile: &mut Tile,
) -> bool {
    let &DrawnCluster { number: cluster, ref block, cull, ref ranks } = cluster;
    let mut waits = false;
    let mut group = TriangleGroup::new();
    for (number, chunk) in block.triangles.chunks(LANES).enumerate() {
        // A loop of known length; lanes beyond the chunk are not looked at.
        let mut rest = [0; LANES];
        let words = chunk.first_chunk().unwrap_or_else(|| {
            rest[..chunk.len()].copy_from_slice(chunk);
            &rest
        });
        for (lane, &word) in words.iter().enumerate() {
            let [a, b, c] = corners_of(word);
            group.corners[0][lane] = vertices.points[a];
            group.corners[1][lane] = vertices.points[b];
            group.corners[2][lane] = vertices.points[c];
        }
        let held = group.may_hold_samples(simd, tile.region, rules.offsets, cull);
        let mut left = held & ((1 << chunk.len()) - 1);
        while left != 0 {
            let lane = left.trailing_zeros() as usize & (LANES - 1);
            left &= left - 1;
            let id = TriangleId::new(cluster, number * LANES + lane);
            let (size, rank) = (group.size(lane), ranks.of(number * LANES + lane));
            if size < SIZES && rank == 0 {
                waits = true;
                if queues.push(size, &group.corners, lane, id) {
                    let grid = SampleGrid { region: tile.region, offsets: rules.offsets };
                    queues.draw(simd, size, grid, &mut BufferSink { rules, tile });
                }
                continue;
            }
            let corners = corners_of(words[lane]).map(|corner| vertices.vertex(corner));
            if let Some(triangle) = Triangle::new(corners, cull) {
                draw_triangle(simd, &triangle.with_rank(rank), id, rules, tile);
            }
        }
    }
    waits
}

/// Draws a cluster of which some triangles may reach the near plane or the guard band.
#[inline(always)]
fn draw_clipped<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    cluster: &DrawnCluster<'_>,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    let &DrawnCluster { number: cluster, ref block, cull, ref ranks } = cluster;
    for (slot, &word) in block.triangles.iter().enumerate() {
        let corners = corners_of(word).map(|corner| clip_vertex(transform, block, corner));
        if corners.iter().all(|&corner| transform.holds(corner)) {
            let corners = corners.map(|corner| transform.window(corner));
            if let Some(triangle) = Triangle::new(corners, cull) {
                let triangle = triangle.with_rank(ranks.of(slot));
                draw_triangle(simd, &triangle, TriangleId::new(cluster, slot), rules, tile);
            }
            continue;
        }
        for piece in clip(corners, transform).triangles() {
            if let Some(triangle) = Triangle::new(piece, cull) {
                let triangle = triangle.with_rank(ranks.of(slot));
                draw_triangle(simd, &triangle, TriangleId::new(cluster, slot), rules, tile);
            }
        }
    }
}

/// A cluster's vertex in clip coordinates.
fn clip_vertex(transform: &WindowTransform, block: &Block<'_>, corner: usize) -> ClipVertex {
    transform.clip(block.position(corner as u32))
}
