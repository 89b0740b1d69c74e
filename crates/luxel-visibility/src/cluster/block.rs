//! The block of a cluster: one contiguous piece of memory that it is drawn from.

use crate::types::SLOT_BITS;
use luxel_math::LANES;

/// Most triangles of a cluster: slot numbers take seven bits.
pub const CLUSTER_TRIANGLES: usize = 1 << SLOT_BITS;
/// Most vertices of a cluster: corner numbers take eight bits.
pub(crate) const CLUSTER_VERTICES: usize = 256;
/// Words of a group of sixteen vertices: x16 y16 z16.
pub(crate) const GROUP_WORDS: usize = 3 * LANES;

/// Blocks that are kept, one after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Piece {
    /// Of each the vertex groups, then the triangles.
    pub(crate) words: Vec<u32>,
    /// What vertices carry, and [as much again](Self::pad) as the longest block reads; empty where that
    /// isn't kept.
    pub(crate) shading_vertices: Vec<ShadingVertex>,
}

impl Piece {
    /// Ends the piece: each block has [`CLUSTER_VERTICES`] shading vertices from its first on, so that
    /// corner numbers need no bounds.
    pub(crate) fn pad(&mut self) {
        if !self.shading_vertices.is_empty() {
            let padded = self.shading_vertices.len() + CLUSTER_VERTICES;
            self.shading_vertices.resize(padded, [0.0; 8]);
        }
    }
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
    /// What vertices carry, if that is kept, and those of the blocks behind.
    pub(crate) shading_vertices: Option<&'a [ShadingVertex; CLUSTER_VERTICES]>,
}

impl<'a> Block<'a> {
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
