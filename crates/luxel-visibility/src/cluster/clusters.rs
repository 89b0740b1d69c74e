//! Clusters: a mesh cut into runs of at most 128 triangles.
//!
//! Clusters are what is culled, binned to tiles and ordered; a triangle is never binned or stored
//! for a frame. A cluster is drawn from its block, one contiguous piece of memory: vertices in
//! groups of sixteen (x16 y16 z16), ready for the lanes, and one word a triangle with three corner
//! numbers of eight bits, 13 bytes a triangle on even meshes. For many frames blocks are kept (see
//! `cluster_builder`); for a single one each is made where it is drawn (see `transient_block`).
//!
//! Clusters follow a curve through space (see `hilbert`), so that each is compact: small in the window,
//! in few tiles, and hidden as a whole by what lies before it. A file's own order may be anything; for
//! a single frame it is good enough where it keeps neighbours together.

use super::block::{Block, CLUSTER_TRIANGLES, GROUP_WORDS, Header, Numbers, Piece, ShadingVertex};
use super::cluster_builder::ClusterBuilder;
use super::hilbert::{along_curve, is_local};
use super::normal_cone::Cone;
use super::repeats::Repeats;
use super::transient_block::{TRANSIENT_TRIANGLES, TransientBlock, box_of};
use luxel_math::LANES;
use luxel_parallel::{fill, map};
use luxel_scene::{Mesh, Part};

/// Words of the bounds of sixteen clusters: low x16 y16 z16, high x16 y16 z16.
pub(crate) const BOUNDS_WORDS: usize = 6 * LANES;
/// Triangles that one task cuts. Fixed, so that clusters don't depend on the number of threads.
const TASK_TRIANGLES: usize = 128 * CLUSTER_TRIANGLES;

/// How many frames clusters are for. What is seen doesn't depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frames {
    /// Many: compact clusters along a curve through space, kept as they are drawn.
    #[default]
    Many,
    /// One: triangles as the file has them, if that keeps neighbours together, else along the curve;
    /// ready in a fraction of the time and of the memory.
    One,
}

/// The clusters of one mesh.
#[derive(Clone, Debug, Default)]
pub struct Clusters {
    /// The order of each part's triangles.
    orders: Vec<Order>,
    /// What is kept for many frames.
    pieces: Vec<Piece>,
    pub(crate) headers: Vec<Header>,
    /// Boxes of sixteen clusters at a time, see [`BOUNDS_WORDS`]; the box alone of a single cluster, as
    /// scenes may have many small meshes.
    bounds: Vec<f32>,
    /// Cones of sixteen clusters at a time, see [`CONE_WORDS`]; empty where they aren't known.
    ///
    /// [`CONE_WORDS`]: super::CONE_WORDS
    pub(crate) cones: Vec<f32>,
    repeats: Repeats,
}

/// The order of a part's triangles, by their submitted numbers: places in the mesh's list.
#[derive(Clone, Debug)]
enum Order {
    /// From this one on, one after the other.
    File(u32),
    Curve(Box<[u32]>),
}

impl Clusters {
    /// Cuts a mesh into runs of triangles.
    #[must_use]
    pub fn new(mesh: &Mesh, frames: Frames) -> Self {
        let mut all = Self::default();
        let boxes = match frames {
            Frames::Many => all.cut(mesh),
            Frames::One => all.divide(mesh),
        };
        all.repeats = Repeats::new(mesh, &boxes, |cluster| {
            (all.numbers(cluster), usize::from(all.headers[cluster].triangles))
        });
        all.bounds = by_sixteen(boxes);
        all
    }

    /// Cuts it into blocks along the curve. The boxes of clusters.
    fn cut(&mut self, mesh: &Mesh) -> Vec<[f32; 6]> {
        let orders: Vec<_> = mesh.parts.iter().map(|part| along_curve(mesh, range(part))).collect();
        let tasks = tasks(&orders);
        let built = map(tasks.len(), 1, &|run| {
            let mut builder = ClusterBuilder::new(mesh, run.start as u32);
            for &Task { part, first_number, triangles } in &tasks[run.start] {
                builder.add(part, first_number, triangles);
            }
            builder.finish()
        });
        let (mut boxes, mut cones) = (Vec::new(), Vec::new());
        for built in built {
            self.pieces.push(built.piece);
            self.headers.extend(built.headers);
            boxes.extend(built.boxes);
            cones.extend(built.cones);
        }
        self.orders.extend(orders.into_iter().map(|order| Order::Curve(order.into())));
        self.cones = Cone::by_sixteen(&cones);
        boxes
    }

    /// Divides it into runs, of which only the boxes are kept. The boxes of clusters.
    fn divide(&mut self, mesh: &Mesh) -> Vec<[f32; 6]> {
        let runs = |part: &Part| part.count.div_ceil(TRANSIENT_TRIANGLES as u32) as usize;
        self.orders.reserve_exact(mesh.parts.len());
        self.headers.reserve_exact(mesh.parts.iter().map(runs).sum());
        for (number, part) in (0..).zip(&mesh.parts) {
            self.orders.push(if is_local(mesh, range(part)) {
                Order::File(part.first)
            } else {
                Order::Curve(along_curve(mesh, range(part)).into())
            });
            let first_numbers = (0..part.count).step_by(TRANSIENT_TRIANGLES);
            self.headers.extend(first_numbers.map(|first_number| Header {
                part: number,
                first_number,
                triangles: (part.count - first_number).min(TRANSIENT_TRIANGLES as u32) as u16,
                ..Header::default()
            }));
        }
        let mut boxes = vec![[0.0; 6]; self.headers.len()];
        fill(&mut boxes, TASK_TRIANGLES / TRANSIENT_TRIANGLES, &|first, boxes| {
            for (cluster, bounds) in (first..).zip(boxes) {
                let count = usize::from(self.headers[cluster].triangles);
                *bounds = box_of(mesh, self.numbers(cluster), count);
            }
        });
        boxes
    }

    /// How many clusters there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.headers.len()
    }

    /// Whether a cluster repeats the triangles of the one before it, all of them submitted later.
    pub(crate) fn is_repeated(&self, cluster: usize) -> bool {
        self.repeats.contains(cluster)
    }

    /// Whether any cluster repeats the one before it.
    pub(crate) fn has_repeated(&self) -> bool {
        !self.repeats.is_empty()
    }

    /// The submitted number of a triangle: its place in the mesh's list.
    #[must_use]
    pub fn original(&self, cluster: usize, slot: usize) -> u32 {
        self.numbers(cluster).of(slot)
    }

    /// The submitted numbers of a cluster's triangles.
    #[inline(always)]
    pub(crate) fn numbers(&self, cluster: usize) -> Numbers<'_> {
        let Header { part, first_number, triangles, .. } = self.headers[cluster];
        match &self.orders[part as usize] {
            Order::File(first) => Numbers::From(first + first_number),
            Order::Curve(all) => {
                Numbers::Listed(&all[first_number as usize..][..usize::from(triangles)])
            }
        }
    }

    /// The boxes of a group of sixteen clusters, in `expanded` if they aren't stored so.
    #[inline(always)]
    pub(crate) fn bounds_of_group<'a>(
        &'a self,
        group: usize,
        expanded: &'a mut [f32; BOUNDS_WORDS],
    ) -> &'a [f32] {
        if let Ok(bounds) = <&[f32; 6]>::try_from(self.bounds.as_slice()) {
            for (lanes, &bound) in expanded.as_chunks_mut::<LANES>().0.iter_mut().zip(bounds) {
                *lanes = [bound; LANES];
            }
            return expanded;
        }
        &self.bounds[group * BOUNDS_WORDS..(group + 1) * BOUNDS_WORDS]
    }

    /// The block of a cluster, if it is kept.
    #[inline(always)]
    pub(crate) fn kept(&self, cluster: usize) -> Option<Block<'_>> {
        let header = &self.headers[cluster];
        if header.groups == 0 {
            return None;
        }
        let Piece { words, shading_vertices, .. } = &self.pieces[header.piece as usize];
        let words = &words[header.first_word as usize..];
        let (vertices, words) = words.split_at(usize::from(header.groups) * GROUP_WORDS);
        let (vertices, _) = vertices.as_chunks();
        let triangles = &words[..usize::from(header.triangles)];
        let shading_vertices = shading_vertices
            .get(header.first_shading_vertex as usize..)
            .and_then(<[ShadingVertex]>::first_chunk);
        Some(Block { vertices, triangles, shading_vertices })
    }

    /// The block of a cluster of `mesh`, made in `transient` if it isn't kept.
    #[inline(always)]
    pub(crate) fn block<'a>(
        &'a self,
        mesh: &Mesh,
        cluster: usize,
        transient: &'a mut TransientBlock,
    ) -> Block<'a> {
        let count = usize::from(self.headers[cluster].triangles);
        match self.kept(cluster) {
            Some(block) => block,
            None => transient.fill(mesh, self.numbers(cluster), count),
        }
    }
}

/// Triangles of a part, and the place of the first in the part's order.
#[derive(Clone, Copy)]
struct Task<'a> {
    part: u32,
    first_number: u32,
    triangles: &'a [u32],
}

/// Divides parts into pieces: long ones into several, and short ones that follow one another together.
fn tasks(orders: &[Vec<u32>]) -> Vec<Vec<Task<'_>>> {
    let mut pieces: Vec<Vec<Task<'_>>> = Vec::new();
    let mut room = 0;
    for (part, order) in (0..).zip(orders) {
        let chunks = (0..).step_by(TASK_TRIANGLES).zip(order.chunks(TASK_TRIANGLES));
        for (first_number, triangles) in chunks {
            let task = Task { part, first_number, triangles };
            match pieces.last_mut() {
                Some(piece) if triangles.len() <= room => piece.push(task),
                _ => {
                    pieces.push(vec![task]);
                    room = TASK_TRIANGLES;
                }
            }
            room -= triangles.len();
        }
    }
    pieces
}

/// The triangles of a part.
fn range(part: &Part) -> std::ops::Range<usize> {
    part.first as usize..part.first as usize + part.count as usize
}

/// The boxes of all clusters, transposed for the lanes where they are; the last group repeats its last box. A
/// single one stays as it is.
fn by_sixteen(mut boxes: Vec<[f32; 6]>) -> Vec<f32> {
    if boxes.len() > 1
        && let Some(&last) = boxes.last()
    {
        let padding = boxes.len().next_multiple_of(LANES) - boxes.len();
        boxes.reserve_exact(padding);
        boxes.extend(std::iter::repeat_n(last, padding));
        for group in boxes.as_chunks_mut::<LANES>().0 {
            let of_clusters = *group;
            for (place, bound) in group.as_flattened_mut().iter_mut().enumerate() {
                *bound = of_clusters[place % LANES][place / LANES];
            }
        }
    }
    boxes.into_flattened()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cluster::CLUSTER_VERTICES;
    use luxel_scene::{MaterialId, Part};

    /// A strip of unconnected triangles followed by a connected grid.
    fn mesh() -> Mesh {
        let mut mesh = Mesh::default();
        for triangle in 0..500_u32 {
            let x = triangle as f32;
            mesh.positions.extend([[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, x]]);
            mesh.triangles.push([0, 1, 2].map(|corner| 3 * triangle + corner));
        }
        for triangle in 0..1000_u32 {
            mesh.triangles.push([triangle, triangle + 1, triangle + 2]);
        }
        let part = |first, count, material| Part { first, count, material: MaterialId(material) };
        mesh.parts = vec![part(0, 700, 0), part(700, 800, 1)];
        mesh
    }

    #[test]
    fn every_triangle_is_in_exactly_one_slot_with_its_own_corners() {
        for frames in [Frames::Many, Frames::One] {
            slots_are_sound(&mesh(), frames);
        }
    }

    fn slots_are_sound(mesh: &Mesh, frames: Frames) {
        let clusters = Clusters::new(mesh, frames);
        let mut seen = Vec::new();
        for cluster in 0..clusters.count() {
            let mut transient = TransientBlock::new();
            let block = clusters.block(mesh, cluster, &mut transient);
            let part = mesh.parts[clusters.headers[cluster].part as usize];
            assert!(block.vertices.len() * LANES <= CLUSTER_VERTICES);
            for (slot, word) in block.triangles.iter().enumerate() {
                let original = clusters.original(cluster, slot);
                assert!((part.first..part.first + part.count).contains(&original));
                seen.push(original);
                for corner in 0..3 {
                    let number = (word >> (8 * corner) & 255) as usize;
                    let vertex = mesh.triangles[original as usize][corner];
                    for axis in 0..3 {
                        let word = axis * LANES + number % LANES;
                        let value = f32::from_bits(block.vertices[number / LANES][word]);
                        assert_eq!(value, mesh.positions[vertex as usize][axis]);
                    }
                }
            }
        }
        seen.sort_unstable();
        assert_eq!(seen, (0..1500).collect::<Vec<_>>());
    }
}
