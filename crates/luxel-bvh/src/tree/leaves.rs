//! The leaves of a tree over triangles: blocks one after another.

use super::block::{Block, VertexRows, block_at};
use crate::aabb::Aabb;
use crate::pages::Pages;

/// The mesh that a tree is built over.
pub(crate) struct MeshRef<'m> {
    pub(crate) positions: &'m [[f32; 3]],
    pub(crate) triangles: &'m [[u32; 3]],
}

/// The blocks of all leaves; the blocks of one leaf follow one another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Leaves {
    pub(crate) words: Pages<u32>,
    /// The number of triangles.
    pub(crate) count: usize,
}

impl Leaves {
    /// Copies the current positions of a leaf's vertices; returns the box around its triangles.
    pub(crate) fn refit(&mut self, mut start: usize, mesh: &MeshRef<'_>) -> Aabb {
        let mut bounds = Aabb::EMPTY;
        while let Some(words) = block_at(&self.words, start).map(|block| *block.0) {
            let block = Block(&words);
            let header = block.header();
            for lane in 0..header.count() {
                let vertices = mesh.triangles[block.triangle(lane) as usize];
                let corners = vertices.map(|vertex| mesh.positions[vertex as usize]);
                bounds = bounds.union(&Aabb::of_triangle(corners));
                if header.rows() == VertexRows::Numbers {
                    continue;
                }
                for (corner, position) in corners.iter().enumerate() {
                    let at = start + block.corner_at(lane, corner);
                    for axis in 0..3 {
                        self.words[at + axis * header.row_length()] = position[axis].to_bits();
                    }
                }
            }
            if !header.more_follow() {
                break;
            }
            start += header.len();
        }
        bounds
    }
}
