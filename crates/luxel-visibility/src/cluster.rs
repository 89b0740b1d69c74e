//! Clusters: a mesh cut into runs of at most 128 triangles, each one contiguous block of memory.
//!
//! Clusters are what is culled, binned to tiles and ordered; a triangle is never binned or stored
//! for a frame. A block holds its vertices in groups of sixteen (x16 y16 z16), ready for the lanes,
//! and one word a triangle with three corner numbers of eight bits: 13 bytes a triangle on even
//! meshes.
//!
//! Clusters follow a curve through space (see `order`), so that each is compact: small in the window,
//! in few tiles, and hidden as a whole by what lies before it. A file's own order may be anything; for
//! a single frame it is good enough where it keeps neighbours together.

use crate::facing::Cone;
use crate::order::{along_curve, is_local};
use luxel_math::LANES;
use luxel_parallel::map;
use luxel_scene::Mesh;
use std::ops::Range;

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

/// In which order triangles become clusters. What is seen doesn't depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClusterOrder {
    /// Along a curve through space: compact clusters, for many frames.
    #[default]
    Curve,
    /// As the file has them, if that keeps neighbours together, else along the curve: ready in half
    /// the time, for a single frame.
    File,
}

/// The clusters of one mesh.
#[derive(Clone, Debug, Default)]
pub struct Clusters {
    pieces: Vec<Piece>,
    pub(crate) headers: Vec<Header>,
    /// Boxes of sixteen clusters at a time, see [`BOUNDS_WORDS`].
    pub(crate) bounds: Vec<f32>,
    /// Cones of sixteen clusters at a time, see [`CONE_WORDS`]; empty where they aren't known.
    ///
    /// [`CONE_WORDS`]: crate::facing::CONE_WORDS
    pub(crate) cones: Vec<f32>,
}

/// What one task has cut.
#[derive(Clone, Debug, Default)]
struct Piece {
    /// The blocks, one after the other: vertex groups, then triangles.
    words: Vec<u32>,
    /// The submitted number of the triangle in each slot, cluster after cluster.
    originals: Vec<u32>,
    /// What vertices carry, cluster after cluster; empty where that isn't kept.
    carried: Vec<Carried>,
}

/// A vertex as shading looks it up, in half a line of the cache: x, y and z of its position about the
/// mesh's origin, then of its normal in the mesh's space, then nothing.
pub type Carried = [f32; 8];

/// What a cluster's block holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Header {
    /// The piece, and the first word of the block in it.
    piece: u32,
    first_word: u32,
    /// Groups of sixteen vertices.
    groups: u16,
    /// Triangles.
    pub(crate) triangles: u16,
    /// The mesh's part, whose material all triangles have.
    pub(crate) part: u32,
    /// Where `originals` begin in the piece, and what vertices carry.
    first_original: u32,
    first_carried: u32,
}

/// A cluster's block, ready to be read.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// Groups of f32 bits: x16 y16 z16.
    pub(crate) vertices: &'a [[u32; GROUP_WORDS]],
    /// Corner numbers: eight bits each, the first corner lowest.
    pub(crate) triangles: &'a [u32],
    /// What vertices carry, if that is kept.
    pub(crate) carried: &'a [Carried],
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
    pub(crate) fn carried(&self, slot: usize) -> Option<[&'a Carried; 3]> {
        let word = self.triangles[slot];
        let of = |corner: u32| self.carried.get((corner & 255) as usize);
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
    /// Cuts a mesh into compact runs of triangles.
    #[must_use]
    pub fn new(mesh: &Mesh, order: ClusterOrder) -> Self {
        let ranges = mesh.parts.iter().map(|part| {
            let first = part.first as usize;
            first..first + part.count as usize
        });
        let orders: Vec<(u32, Range<usize>, Option<Vec<u32>>)> = (0..)
            .zip(ranges)
            .map(|(number, range)| {
                let as_it_is = order == ClusterOrder::File && is_local(mesh, range.clone());
                let curve = (!as_it_is).then(|| along_curve(mesh, range.clone()));
                (number, range, curve)
            })
            .collect();
        let mut tasks = Vec::new();
        for (part, range, curve) in &orders {
            for start in range.clone().step_by(TASK_TRIANGLES) {
                let end = range.end.min(start + TASK_TRIANGLES);
                let curve =
                    curve.as_ref().map(|curve| &curve[start - range.start..end - range.start]);
                tasks.push((*part, start..end, curve));
            }
        }
        let cut = map(tasks.len(), 1, &|task| {
            let (part, range, curve) = &tasks[task.start];
            let for_many = order == ClusterOrder::Curve;
            let mut cut = Cut::new(mesh, *part, task.start as u32, for_many);
            match curve {
                Some(curve) => cut.add(curve.iter().copied()),
                None => cut.add(range.start as u32..range.end as u32),
            }
            cut.close();
            Some(cut)
        });
        let mut all = Self::default();
        let (mut boxes, mut cones) = (Vec::new(), Vec::new());
        for Cut { piece, headers, boxes: of_piece, cones: cones_of_piece, .. } in
            cut.into_iter().flatten()
        {
            all.pieces.push(piece);
            all.headers.extend(headers);
            boxes.extend(of_piece);
            cones.extend(cones_of_piece);
        }
        all.bounds = by_sixteen(&boxes);
        all.cones = Cone::by_sixteen(&cones);
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
        self.originals(cluster)[slot]
    }

    /// The submitted numbers of a cluster's triangles.
    pub(crate) fn originals(&self, cluster: usize) -> &[u32] {
        let Header { piece, first_original, triangles, .. } = self.headers[cluster];
        &self.pieces[piece as usize].originals[first_original as usize..][..usize::from(triangles)]
    }

    /// The block of a cluster.
    pub(crate) fn block(&self, cluster: usize) -> Block<'_> {
        let header = &self.headers[cluster];
        let words = &self.pieces[header.piece as usize].words[header.first_word as usize..];
        let (vertices, words) = words.split_at(usize::from(header.groups) * GROUP_WORDS);
        let (vertices, _) = vertices.as_chunks();
        let triangles = &words[..usize::from(header.triangles)];
        let carried = &self.pieces[header.piece as usize].carried;
        let carried = carried.get(header.first_carried as usize..).unwrap_or_default();
        Block { vertices, triangles, carried }
    }
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

/// The box of a cluster: low x y z, high x y z; not a number if a coordinate is none, so that no
/// bound is taken from it.
fn bounds(groups: &[[u32; GROUP_WORDS]]) -> [f32; 6] {
    let mut bounds = [0.0; 6];
    let mut is_sound = true;
    for axis in 0..3 {
        let (mut low, mut high) = ([f32::INFINITY; LANES], [f32::NEG_INFINITY; LANES]);
        for group in groups {
            for lane in 0..LANES {
                let value = f32::from_bits(group[axis * LANES + lane]);
                is_sound &= !value.is_nan();
                low[lane] = if value < low[lane] { value } else { low[lane] };
                high[lane] = if value > high[lane] { value } else { high[lane] };
            }
        }
        bounds[axis] = low.into_iter().fold(f32::INFINITY, f32::min);
        bounds[3 + axis] = high.into_iter().fold(f32::NEG_INFINITY, f32::max);
    }
    if is_sound { bounds } else { [f32::NAN; 6] }
}

/// Numbers a cluster's vertices: a small hash table that forgets all at once.
struct VertexNumbers {
    /// Round and number above (24 and 8 bits), vertex below: an entry of an earlier round is empty.
    slots: Box<[u64; Self::SIZE]>,
    round: u32,
}

impl VertexNumbers {
    /// Four times the vertices of a cluster.
    const SIZE: usize = 4 * CLUSTER_VERTICES;

    fn new() -> Self {
        Self { slots: Box::new([0; Self::SIZE]), round: 1 }
    }

    /// Begins with no vertices.
    fn forget(&mut self) {
        self.round += 1;
        if self.round >> 24 != 0 {
            *self = Self::new();
        }
    }

    /// The number that `vertex` has, or `next`, which it takes.
    #[inline(always)]
    fn number(&mut self, vertex: u32, next: usize) -> usize {
        let vertex_of_round = u64::from(self.round) << 40 | u64::from(vertex);
        // Multiplicative hashing (Knuth, volume 3, section 6.4) with the golden ratio.
        let hash = vertex.wrapping_mul(0x9e37_79b9) >> (32 - Self::SIZE.ilog2());
        let mut slot = hash as usize;
        loop {
            let entry = &mut self.slots[slot & (Self::SIZE - 1)];
            if *entry & !(0xff << 32) == vertex_of_round {
                return (*entry >> 32 & 0xff) as usize;
            }
            if *entry >> 40 != u64::from(self.round) {
                *entry = vertex_of_round | (next as u64) << 32;
                return next;
            }
            slot += 1;
        }
    }
}

/// Triangles on their way into clusters of one part.
struct Cut<'a> {
    mesh: &'a Mesh,
    part: u32,
    number: u32,
    /// Whether many frames are to be drawn: for a single one neither cones nor what vertices carry pay.
    for_many: bool,
    /// Whether it is kept what vertices carry.
    is_carrying: bool,
    piece: Piece,
    headers: Vec<Header>,
    boxes: Vec<[f32; 6]>,
    cones: Vec<Cone>,
    /// The vertices of the cluster that is open.
    numbers: VertexNumbers,
    groups: Box<[[u32; GROUP_WORDS]; CLUSTER_VERTICES / LANES]>,
    vertices: usize,
    /// Its triangles.
    corners: Vec<u32>,
}

impl<'a> Cut<'a> {
    fn new(mesh: &'a Mesh, part: u32, number: u32, for_many: bool) -> Self {
        let has_normals = mesh.normals.len() >= mesh.positions.len();
        Self {
            mesh,
            part,
            number,
            for_many,
            // Where attributes are numbered apart, positions alone don't tell them.
            is_carrying: for_many && has_normals && mesh.attribute_corners.is_none(),
            piece: Piece::default(),
            headers: Vec::new(),
            boxes: Vec::new(),
            cones: Vec::new(),
            numbers: VertexNumbers::new(),
            groups: Box::new([[0; GROUP_WORDS]; CLUSTER_VERTICES / LANES]),
            vertices: 0,
            corners: Vec::with_capacity(CLUSTER_TRIANGLES),
        }
    }

    /// Adds triangles, one after the other.
    fn add(&mut self, triangles: impl ExactSizeIterator<Item = u32>) {
        let count = triangles.len();
        self.piece.originals.reserve_exact(count);
        // What even meshes take: a word a triangle, and three for two thirds of a vertex.
        self.piece.words.reserve(count * 3 + GROUP_WORDS);
        for original in triangles {
            if self.corners.len() == CLUSTER_TRIANGLES || self.vertices + 3 > CLUSTER_VERTICES {
                self.close();
            }
            let mut word = 0;
            for (corner, vertex) in self.mesh.triangles[original as usize].into_iter().enumerate() {
                word |= (self.number_of(vertex) as u32) << (8 * corner);
            }
            self.corners.push(word);
            self.piece.originals.push(original);
        }
    }

    /// A vertex's number in the cluster that is open.
    #[inline(always)]
    fn number_of(&mut self, vertex: u32) -> usize {
        let number = self.numbers.number(vertex, self.vertices);
        if number == self.vertices {
            let position = self.mesh.positions[vertex as usize];
            let group = &mut self.groups[number / LANES % (CLUSTER_VERTICES / LANES)];
            for axis in 0..3 {
                group[axis * LANES + number % LANES] = position[axis].to_bits();
            }
            self.vertices += 1;
            if self.is_carrying {
                let ([x, y, z], [nx, ny, nz]) = (position, self.mesh.normals[vertex as usize]);
                self.piece.carried.push([x, y, z, nx, ny, nz, 0.0, 0.0]);
            }
        }
        number
    }

    /// Closes a cluster, if one is open: writes its block.
    fn close(&mut self) {
        let Self { piece, groups, vertices, corners, .. } = self;
        if corners.is_empty() {
            return;
        }
        let groups = &mut groups[..vertices.div_ceil(LANES)];
        // The last group repeats its last vertex, so that bounds stay those of the cluster.
        if let (Some(group), used @ 1..) = (groups.last_mut(), *vertices % LANES) {
            for axis in group.as_chunks_mut::<LANES>().0 {
                let last = axis[used - 1];
                axis[used..].fill(last);
            }
        }
        self.headers.push(Header {
            piece: self.number,
            first_word: piece.words.len() as u32,
            groups: groups.len() as u16,
            triangles: corners.len() as u16,
            part: self.part,
            first_original: (piece.originals.len() - corners.len()) as u32,
            first_carried: piece.carried.len().saturating_sub(*vertices) as u32,
        });
        self.boxes.push(bounds(groups));
        if self.for_many {
            let block = Block { vertices: groups, triangles: corners, carried: &[] };
            self.cones.push(Cone::of((0..corners.len()).map(|slot| block.positions(slot))));
        }
        piece.words.extend_from_slice(groups.as_flattened());
        piece.words.extend_from_slice(corners);
        self.vertices = 0;
        corners.clear();
        self.numbers.forget();
    }
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
        for order in [ClusterOrder::Curve, ClusterOrder::File] {
            slots_are_sound(&mesh(), order);
        }
    }

    fn slots_are_sound(mesh: &Mesh, order: ClusterOrder) {
        let clusters = Clusters::new(mesh, order);
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
