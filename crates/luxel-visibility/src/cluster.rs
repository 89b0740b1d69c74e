//! Clusters: a mesh cut into runs of at most 128 triangles.
//!
//! Clusters are what is culled, binned to tiles and ordered; a triangle is never binned or stored
//! for a frame. A cluster is drawn from its block, one contiguous piece of memory: vertices in
//! groups of sixteen (x16 y16 z16), ready for the lanes, and one word a triangle with three corner
//! numbers of eight bits, 13 bytes a triangle on even meshes. For many frames blocks are kept (see
//! `cut`); for a single one each is made where it is drawn (see `open`).
//!
//! Clusters follow a curve through space (see `order`), so that each is compact: small in the window,
//! in few tiles, and hidden as a whole by what lies before it. A file's own order may be anything; for
//! a single frame it is good enough where it keeps neighbours together.

use crate::cut::Cut;
use crate::facing::Cone;
use crate::open::{OPENED_TRIANGLES, Opened, box_of};
use crate::order::{along_curve, is_local};
use luxel_math::LANES;
use luxel_parallel::{fill, map};
use luxel_scene::{Mesh, Part};

/// Most triangles of a cluster: slot numbers take seven bits.
pub const CLUSTER_TRIANGLES: usize = 1 << SLOT_BITS;
/// Bits of a triangle's slot number in an id.
pub(crate) const SLOT_BITS: u32 = 7;
/// Most vertices of a cluster: corner numbers take eight bits.
pub(crate) const CLUSTER_VERTICES: usize = 256;
/// Words of a group of sixteen vertices: x16 y16 z16.
pub(crate) const GROUP_WORDS: usize = 3 * LANES;
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
    /// Boxes of sixteen clusters at a time, see [`BOUNDS_WORDS`].
    pub(crate) bounds: Vec<f32>,
    /// Cones of sixteen clusters at a time, see [`CONE_WORDS`]; empty where they aren't known.
    ///
    /// [`CONE_WORDS`]: crate::facing::CONE_WORDS
    pub(crate) cones: Vec<f32>,
}

/// Blocks that are kept, one after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Piece {
    /// Of each the vertex groups, then the triangles.
    pub(crate) words: Vec<u32>,
    /// What vertices carry; empty where that isn't kept.
    pub(crate) shading_vertices: Vec<ShadingVertex>,
}

/// The order of a part's triangles, by their submitted numbers: places in the mesh's list.
#[derive(Clone, Debug)]
enum Order {
    /// From this one on, one after the other.
    File(u32),
    Curve(Vec<u32>),
}

/// The submitted numbers of a cluster's triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Numbers<'a> {
    From(u32),
    Listed(&'a [u32]),
}

impl Numbers<'_> {
    /// The number of the triangle in a slot.
    #[inline(always)]
    pub(crate) fn of(self, slot: usize) -> u32 {
        match self {
            Self::From(first) => first + slot as u32,
            Self::Listed(numbers) => numbers[slot],
        }
    }
}

/// A vertex as shading looks it up, in half a line of the cache: x, y and z of its position about the
/// mesh's origin, then of its normal in the mesh's space, then nothing.
pub type ShadingVertex = [f32; 8];

/// What a cluster holds.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Header {
    /// The mesh's part, whose material all triangles have.
    pub(crate) part: u32,
    /// Where its triangles begin in the part's order.
    pub(crate) first_number: u32,
    /// Triangles.
    pub(crate) triangles: u16,
    /// Groups of sixteen vertices of the block that is kept; 0 if none is.
    pub(crate) groups: u16,
    /// The piece that it is in, where it begins there, and what its vertices carry.
    pub(crate) piece: u32,
    pub(crate) first_word: u32,
    pub(crate) first_shading_vertex: u32,
}

/// A cluster's block, ready to be read.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// Groups of f32 bits: x16 y16 z16.
    pub(crate) vertices: &'a [[u32; GROUP_WORDS]],
    /// Corner numbers: eight bits each, the first corner lowest.
    pub(crate) triangles: &'a [u32],
    /// What vertices carry, if that is kept.
    pub(crate) shading_vertices: &'a [ShadingVertex],
}

impl<'a> Block<'a> {
    /// The positions of a triangle's corners.
    #[inline(always)]
    pub(crate) fn positions(&self, slot: usize) -> [[f32; 3]; 3] {
        let word = self.triangles[slot];
        [self.position(word & 255), self.position(word >> 8 & 255), self.position(word >> 16 & 255)]
    }

    /// What a triangle's corners carry.
    #[inline(always)]
    pub(crate) fn shading_vertices(&self, slot: usize) -> Option<[&'a ShadingVertex; 3]> {
        let word = self.triangles[slot];
        let of = |corner: u32| self.shading_vertices.get((corner & 255) as usize);
        Some([of(word)?, of(word >> 8)?, of(word >> 16)?])
    }

    /// The position of a vertex, by its number in the cluster.
    #[inline(always)]
    pub(crate) fn position(&self, corner: u32) -> [f32; 3] {
        let corner = corner as usize;
        let group = &self.vertices[corner / LANES];
        let place = corner % LANES;
        [group[place], group[LANES + place], group[2 * LANES + place]].map(f32::from_bits)
    }
}

impl Clusters {
    /// Cuts a mesh into runs of triangles.
    #[must_use]
    pub fn new(mesh: &Mesh, frames: Frames) -> Self {
        let mut all = Self::default();
        match frames {
            Frames::Many => all.cut(mesh),
            Frames::One => all.divide(mesh),
        }
        all
    }

    /// Cuts it into blocks along the curve.
    fn cut(&mut self, mesh: &Mesh) {
        let orders: Vec<_> = mesh.parts.iter().map(|part| along_curve(mesh, range(part))).collect();
        let mut tasks = Vec::new();
        for (part, order) in (0..).zip(&orders) {
            let first_numbers = (0..).step_by(TASK_TRIANGLES);
            tasks.extend(first_numbers.zip(order.chunks(TASK_TRIANGLES)).map(|task| (part, task)));
        }
        let cuts = map(tasks.len(), 1, &|task| {
            let piece = task.start;
            let (part, (first_number, triangles)) = tasks[piece];
            let mut cut = Cut::new(mesh, piece as u32, part, first_number);
            cut.add(triangles);
            cut.close();
            Some(cut)
        });
        let (mut boxes, mut cones) = (Vec::new(), Vec::new());
        for cut in cuts.into_iter().flatten() {
            self.pieces.push(cut.piece);
            self.headers.extend(cut.headers);
            boxes.extend(cut.boxes);
            cones.extend(cut.cones);
        }
        self.orders.extend(orders.into_iter().map(Order::Curve));
        self.bounds = by_sixteen(&boxes);
        self.cones = Cone::by_sixteen(&cones);
    }

    /// Divides it into runs, of which only the boxes are kept.
    fn divide(&mut self, mesh: &Mesh) {
        for (number, part) in (0..).zip(&mesh.parts) {
            self.orders.push(if is_local(mesh, range(part)) {
                Order::File(part.first)
            } else {
                Order::Curve(along_curve(mesh, range(part)))
            });
            let first_numbers = (0..part.count).step_by(OPENED_TRIANGLES);
            self.headers.extend(first_numbers.map(|first_number| Header {
                part: number,
                first_number,
                triangles: (part.count - first_number).min(OPENED_TRIANGLES as u32) as u16,
                ..Header::default()
            }));
        }
        let mut boxes = vec![[0.0; 6]; self.headers.len()];
        fill(&mut boxes, TASK_TRIANGLES / OPENED_TRIANGLES, &|first, boxes| {
            for (cluster, bounds) in (first..).zip(boxes) {
                let count = usize::from(self.headers[cluster].triangles);
                *bounds = box_of(mesh, self.numbers(cluster), count);
            }
        });
        self.bounds = by_sixteen(&boxes);
    }

    /// How many clusters there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.headers.len()
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
        let shading_vertices =
            shading_vertices.get(header.first_shading_vertex as usize..).unwrap_or_default();
        Some(Block { vertices, triangles, shading_vertices })
    }

    /// The block of a cluster of `mesh`, made in `opened` if it isn't kept.
    #[inline(always)]
    pub(crate) fn block<'a>(
        &'a self,
        mesh: &Mesh,
        cluster: usize,
        opened: &'a mut Opened,
    ) -> Block<'a> {
        let count = usize::from(self.headers[cluster].triangles);
        match self.kept(cluster) {
            Some(block) => block,
            None => opened.open(mesh, self.numbers(cluster), count),
        }
    }
}

/// The triangles of a part.
fn range(part: &Part) -> std::ops::Range<usize> {
    part.first as usize..part.first as usize + part.count as usize
}

/// The boxes of all clusters, transposed for the lanes; the last group repeats its last box.
fn by_sixteen(boxes: &[[f32; 6]]) -> Vec<f32> {
    let mut bounds = Vec::with_capacity(boxes.len().next_multiple_of(LANES) * 6);
    for group in boxes.chunks(LANES) {
        for side in 0..6 {
            let last = group[group.len() - 1];
            let padded = group.iter().chain(std::iter::repeat(&last)).take(LANES);
            bounds.extend(padded.map(|bounds| bounds[side]));
        }
    }
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;
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
            let mut opened = Opened::new();
            let block = clusters.block(mesh, cluster, &mut opened);
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
