//! Clusters: a mesh cut into runs of at most 128 triangles, each one contiguous block of memory.
//!
//! Clusters are what is culled, binned to tiles and ordered; a triangle is never binned or stored
//! for a frame. A block holds its vertices in groups of sixteen (x16 y16 z16), ready for the lanes,
//! and one word a triangle with three corner numbers of eight bits: 13 bytes a triangle on even
//! meshes.
//!
//! Clusters follow a curve through space (see `order`), so that each is compact: small in the window,
//! in few tiles, and hidden as a whole by what lies before it. A file's own order may be anything.

use crate::order::along_curve;
use luxel_math::LANES;
use luxel_parallel::{fill, map};
use luxel_scene::Mesh;

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

/// The clusters of one mesh.
#[derive(Clone, Debug, Default)]
pub struct Clusters {
    /// The blocks, one after the other: vertex groups, then triangles.
    words: Vec<u32>,
    pub(crate) headers: Vec<Header>,
    /// Boxes of sixteen clusters at a time, see [`BOUNDS_WORDS`].
    pub(crate) bounds: Vec<f32>,
    /// The submitted number of the triangle in each slot, cluster after cluster.
    originals: Vec<u32>,
}

/// What a cluster's block holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Header {
    /// The first word of the block.
    first_word: usize,
    /// Groups of sixteen vertices.
    groups: u16,
    /// Triangles.
    pub(crate) triangles: u16,
    /// The mesh's part, whose material all triangles have.
    pub(crate) part: u32,
    /// Where `originals` begin.
    first_original: u32,
}

/// A cluster's block, ready to be read.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// Groups of f32 bits: x16 y16 z16.
    pub(crate) vertices: &'a [[u32; GROUP_WORDS]],
    /// Corner numbers: eight bits each, the first corner lowest.
    pub(crate) triangles: &'a [u32],
}

impl Block<'_> {
    /// The positions of a triangle's corners.
    #[inline(always)]
    pub(crate) fn positions(&self, slot: usize) -> [[f32; 3]; 3] {
        let word = self.triangles[slot];
        [self.position(word & 255), self.position(word >> 8 & 255), self.position(word >> 16 & 255)]
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
    /// Cuts a mesh into compact runs of triangles.
    #[must_use]
    pub fn new(mesh: &Mesh) -> Self {
        let orders: Vec<(u32, Vec<u32>)> = (0..)
            .zip(&mesh.parts)
            .map(|(number, part)| {
                let range = part.first as usize..(part.first + part.count) as usize;
                (number, along_curve(mesh, range))
            })
            .collect();
        let tasks: Vec<(u32, &[u32])> = orders
            .iter()
            .flat_map(|(part, order)| order.chunks(TASK_TRIANGLES).map(|task| (*part, task)))
            .collect();
        let mut pieces: Vec<Self> = map(tasks.len(), 1, &|task| {
            let (part, order) = tasks[task.start];
            cut(mesh, part, order)
        });
        let mut all = if pieces.len() == 1 { pieces.remove(0) } else { Self::default() };
        for piece in pieces {
            all.append(piece);
        }
        all.bounds = all.bounds_by_sixteen();
        all
    }

    /// How many clusters there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.headers.len()
    }

    /// The submitted number of a triangle: its place in the mesh's list.
    #[must_use]
    pub fn original(&self, cluster: usize, slot: usize) -> u32 {
        self.originals[self.headers[cluster].first_original as usize + slot]
    }

    /// The submitted numbers of a cluster's triangles.
    pub(crate) fn originals(&self, cluster: usize) -> &[u32] {
        let Header { first_original, triangles, .. } = self.headers[cluster];
        &self.originals[first_original as usize..][..usize::from(triangles)]
    }

    /// The block of a cluster.
    pub(crate) fn block(&self, cluster: usize) -> Block<'_> {
        let header = &self.headers[cluster];
        let vertices = header.first_word;
        let triangles = vertices + usize::from(header.groups) * GROUP_WORDS;
        let end = triangles + usize::from(header.triangles);
        let (vertices, _) = self.words[vertices..triangles].as_chunks();
        Block { vertices, triangles: &self.words[triangles..end] }
    }

    fn append(&mut self, other: Self) {
        let (words, originals) = (self.words.len(), self.originals.len() as u32);
        self.words.extend_from_slice(&other.words);
        self.originals.extend_from_slice(&other.originals);
        self.headers.extend(other.headers.into_iter().map(|header| Header {
            first_word: header.first_word + words,
            first_original: header.first_original + originals,
            ..header
        }));
    }

    /// Closes a cluster: writes its block.
    fn push(&mut self, part: u32, positions: &[[f32; 3]], corners: &[u32]) {
        let groups = positions.len().div_ceil(LANES);
        self.headers.push(Header {
            first_word: self.words.len(),
            groups: groups as u16,
            triangles: corners.len() as u16,
            part,
            first_original: (self.originals.len() - corners.len()) as u32,
        });
        for group in positions.chunks(LANES) {
            for axis in 0..3 {
                // Short groups repeat their last vertex, so that bounds stay those of the cluster.
                let last = group[group.len() - 1];
                let padded = group.iter().chain(std::iter::repeat(&last)).take(LANES);
                self.words.extend(padded.map(|position| position[axis].to_bits()));
            }
        }
        self.words.extend_from_slice(corners);
    }

    /// The boxes of all clusters, transposed for the lanes; the last group repeats its last box.
    fn bounds_by_sixteen(&self) -> Vec<f32> {
        let mut boxes = vec![[0.0; 6]; self.count()];
        fill(&mut boxes, 1 << 7, &|start, run| {
            for (cluster, own) in (start..).zip(run) {
                *own = bounds(&self.block(cluster));
            }
        });
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
}

/// The box of a cluster: low x y z, high x y z; not a number if a coordinate is none, so that no
/// bound is taken from it.
fn bounds(block: &Block<'_>) -> [f32; 6] {
    let mut bounds = [f32::INFINITY, f32::INFINITY, f32::INFINITY, 0.0, 0.0, 0.0];
    bounds[3..].fill(f32::NEG_INFINITY);
    for group in block.vertices {
        for (axis, values) in group.chunks_exact(LANES).enumerate() {
            for value in values.iter().map(|&bits| f32::from_bits(bits)) {
                if value.is_nan() {
                    return [f32::NAN; 6];
                }
                bounds[axis] = bounds[axis].min(value);
                bounds[3 + axis] = bounds[3 + axis].max(value);
            }
        }
    }
    bounds
}

/// Numbers a cluster's vertices: a small hash table that forgets all at once.
struct VertexNumbers {
    /// (round, vertex, number): an entry of an earlier round is empty.
    slots: Box<[(u32, u32, u8); Self::SIZE]>,
    round: u32,
}

impl VertexNumbers {
    /// Four times the vertices of a cluster.
    const SIZE: usize = 4 * CLUSTER_VERTICES;

    fn new() -> Self {
        Self { slots: Box::new([(0, 0, 0); Self::SIZE]), round: 1 }
    }

    /// The number that `vertex` has, or `next`, which it takes.
    fn number(&mut self, vertex: u32, next: usize) -> usize {
        // Multiplicative hashing (Knuth, volume 3, section 6.4) with the golden ratio.
        let hash = vertex.wrapping_mul(0x9e37_79b9) >> (32 - Self::SIZE.ilog2());
        let mut slot = hash as usize;
        loop {
            let entry = &mut self.slots[slot & (Self::SIZE - 1)];
            if entry.0 != self.round {
                *entry = (self.round, vertex, next as u8);
                return next;
            }
            if entry.1 == vertex {
                return usize::from(entry.2);
            }
            slot += 1;
        }
    }
}

/// Cuts triangles into clusters of one part.
fn cut(mesh: &Mesh, part: u32, order: &[u32]) -> Clusters {
    let mut clusters = Clusters::default();
    let mut numbers = VertexNumbers::new();
    let mut positions: Vec<[f32; 3]> = Vec::with_capacity(CLUSTER_VERTICES);
    let mut corners: Vec<u32> = Vec::with_capacity(CLUSTER_TRIANGLES);
    for &original in order {
        let full = corners.len() == CLUSTER_TRIANGLES || positions.len() + 3 > CLUSTER_VERTICES;
        if full {
            clusters.push(part, &positions, &corners);
            positions.clear();
            corners.clear();
            numbers.round += 1;
        }
        let mut word = 0;
        for (corner, &vertex) in mesh.triangles[original as usize].iter().enumerate() {
            let number = numbers.number(vertex, positions.len());
            if number == positions.len() {
                positions.push(mesh.positions[vertex as usize]);
            }
            word |= (number as u32) << (8 * corner);
        }
        corners.push(word);
        clusters.originals.push(original);
    }
    if !corners.is_empty() {
        clusters.push(part, &positions, &corners);
    }
    clusters
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
        let mesh = mesh();
        let clusters = Clusters::new(&mesh);
        let mut seen = Vec::new();
        for cluster in 0..clusters.count() {
            let block = clusters.block(cluster);
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
