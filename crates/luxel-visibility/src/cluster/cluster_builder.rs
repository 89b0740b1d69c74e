//! Cutting a mesh into clusters whose blocks are kept, for many frames.

use super::block::{Block, CLUSTER_TRIANGLES, CLUSTER_VERTICES, GROUP_WORDS, Header, Piece};
use super::normal_cone::Cone;
use luxel_math::LANES;
use luxel_scene::Mesh;

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

/// Clusters with their blocks in one piece.
#[derive(Default)]
pub(crate) struct Built {
    pub(crate) piece: Piece,
    pub(crate) headers: Vec<Header>,
    pub(crate) boxes: Vec<[f32; 6]>,
    pub(crate) cones: Vec<Cone>,
}

/// Triangles on their way into clusters.
pub(crate) struct ClusterBuilder<'a> {
    mesh: &'a Mesh,
    number: u32,
    /// Whether the blocks keep shading vertices.
    keeps_shading_vertices: bool,
    /// The part of the mesh whose triangles come.
    part: u32,
    /// How many triangles of the part lie in clusters before the one that is open.
    first_number: u32,
    built: Built,
    /// The vertices of the cluster that is open.
    numbers: VertexNumbers,
    groups: Box<[[u32; GROUP_WORDS]; CLUSTER_VERTICES / LANES]>,
    vertices: usize,
    /// Its triangles.
    corners: Vec<u32>,
}

impl<'a> ClusterBuilder<'a> {
    /// For the piece of that number.
    pub(crate) fn new(mesh: &'a Mesh, number: u32) -> Self {
        let has_normals = mesh.normals.len() >= mesh.positions.len();
        Self {
            mesh,
            number,
            // Where attributes are numbered apart, positions alone don't tell them.
            keeps_shading_vertices: has_normals && mesh.attribute_corners.is_none(),
            part: 0,
            first_number: 0,
            built: Built::default(),
            numbers: VertexNumbers::new(),
            groups: Box::new([[0; GROUP_WORDS]; CLUSTER_VERTICES / LANES]),
            vertices: 0,
            corners: Vec::with_capacity(CLUSTER_TRIANGLES),
        }
    }

    /// Adds triangles of a part, one after the other, the first of which has that place in the part's order.
    pub(crate) fn add(&mut self, part: u32, first_number: u32, triangles: &[u32]) {
        self.close();
        (self.part, self.first_number) = (part, first_number);
        // What even meshes take: a word a triangle, and three for two thirds of a vertex.
        self.built.piece.words.reserve(triangles.len() * 3 + GROUP_WORDS);
        for &original in triangles {
            if self.corners.len() == CLUSTER_TRIANGLES || self.vertices + 3 > CLUSTER_VERTICES {
                self.close();
            }
            let mut word = 0;
            for (corner, vertex) in self.mesh.triangles[original as usize].into_iter().enumerate() {
                word |= (self.number_of(vertex) as u32) << (8 * corner);
            }
            self.corners.push(word);
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
            if self.keeps_shading_vertices {
                let ([x, y, z], [nx, ny, nz]) = (position, self.mesh.normals[vertex as usize]);
                self.built.piece.shading_vertices.push([x, y, z, nx, ny, nz, 0.0, 0.0]);
            }
        }
        number
    }

    /// What was added, in clusters.
    pub(crate) fn finish(mut self) -> Built {
        self.close();
        self.built.piece.pad();
        self.built
    }

    /// Closes a cluster, if one is open: writes its block.
    fn close(&mut self) {
        let Self { built, groups, vertices, corners, .. } = self;
        let Built { piece, headers, boxes, cones } = built;
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
        headers.push(Header {
            piece: self.number,
            first_word: piece.words.len() as u32,
            groups: groups.len() as u16,
            triangles: corners.len() as u16,
            part: self.part,
            first_number: self.first_number,
            first_shading_vertex: piece.shading_vertices.len().saturating_sub(*vertices) as u32,
        });
        boxes.push(bounds(groups));
        let block = Block { vertices: groups, triangles: corners, shading_vertices: None };
        cones.push(Cone::of((0..corners.len()).map(|slot| block.positions(slot))));
        piece.words.extend_from_slice(groups.as_flattened());
        piece.words.extend_from_slice(corners);
        self.first_number += corners.len() as u32;
        self.vertices = 0;
        corners.clear();
        self.numbers.forget();
    }
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
