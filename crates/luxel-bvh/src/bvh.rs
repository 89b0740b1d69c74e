//! The tree over the triangles of a mesh.

use crate::aabb::Aabb;
use crate::build::{Boxes, Quality, build, build_leaves};
use crate::pages::Pages;
use crate::tree::{Child, Leaves, MAX_TRIANGLES, MeshRef, Node, Tree, TreeView, WIDTH};

/// A mesh has more triangles than a tree can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0} triangles are too many for a tree: the maximum is {MAX_TRIANGLES}")]
pub struct TooManyForTree(pub usize);

/// A bounding volume hierarchy over the triangles of one mesh.
///
/// Holds copies of most of the mesh's positions; [`MeshRays`](crate::MeshRays) combines it with the
/// positions to cast rays. Triangles with a coordinate that isn't finite are left out; degenerate
/// ones are kept.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    nodes: Pages<Node>,
    leaves: Leaves,
    bounds: Option<Aabb>,
    /// The number of positions of the mesh that it was built over.
    vertices: usize,
}

impl Boxes for MeshRef<'_> {
    fn count(&self) -> usize {
        self.triangles.len()
    }

    #[inline]
    fn bounds(&self, number: usize) -> Option<Aabb> {
        let corners = self.triangles[number].map(|vertex| self.positions[vertex as usize]);
        let is_sound = corners.as_flattened().iter().all(|coordinate| coordinate.is_finite());
        is_sound.then(|| Aabb::of_triangle(corners))
    }
}

impl Bvh {
    /// Builds a tree, on all threads of the current pool. The result doesn't depend on their number.
    ///
    /// ```
    /// use luxel_bvh::{Bvh, MeshRays, Quality, Ray};
    ///
    /// let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let bvh = Bvh::build(&positions, &[[0, 1, 2]], Quality::Thorough)?;
    /// let rays = MeshRays::new(&bvh, &positions);
    /// let hit = rays.closest(&Ray::new([0.25, 0.25, 5.0], [0.0, 0.0, -1.0])).unwrap();
    /// assert_eq!((hit.triangle, hit.t), (0, 5.0));
    /// # Ok::<(), luxel_bvh::TooManyForTree>(())
    /// ```
    ///
    /// # Errors
    /// [`TooManyForTree`] beyond [`MAX_TRIANGLES`].
    ///
    /// # Panics
    /// If a triangle refers to a position that doesn't exist.
    pub fn build(
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        quality: Quality,
    ) -> Result<Self, TooManyForTree> {
        if triangles.len() > MAX_TRIANGLES {
            return Err(TooManyForTree(triangles.len()));
        }
        let mesh = MeshRef { positions, triangles };
        let Tree { mut nodes, items, bounds } = build(&mesh, quality);
        let copies = quality != Quality::InOrder;
        let leaves = build_leaves(&mut nodes, &items, &mesh, copies);
        Ok(Self { nodes, leaves, bounds, vertices: positions.len() })
    }

    /// Fits the tree to positions that have moved, without changing its shape: quicker than building,
    /// and good as long as neighbours stay neighbours. `triangles` are those that it was built over.
    ///
    /// Triangles with a coordinate that isn't finite are missed.
    ///
    /// # Panics
    /// If there are fewer positions or triangles than the tree was built over.
    pub fn refit(&mut self, positions: &[[f32; 3]], triangles: &[[u32; 3]]) {
        assert!(positions.len() >= self.vertices, "positions are missing");
        let mesh = MeshRef { positions, triangles };
        // Children have higher indices than their parents.
        for index in (0..self.nodes.len()).rev() {
            for slot in 0..WIDTH {
                let child = self.nodes[index].children[slot];
                let bounds = match child.as_block() {
                    _ if child == Child::NONE => continue,
                    Some(start) => self.leaves.refit(start, &mesh),
                    None => self.nodes[child.0 as usize].union(),
                };
                self.nodes[index].set(slot, &bounds, child);
            }
        }
        self.bounds = self.nodes.first().map(Node::union);
    }

    /// The number of triangles in the tree.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.leaves.count
    }

    /// The memory that the tree takes beside the mesh, in bytes.
    #[must_use]
    pub fn memory(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.leaves.words[..])
    }

    /// The number of levels of nodes.
    #[must_use]
    pub fn depth(&self) -> usize {
        let mut depths = vec![0; self.nodes.len()];
        let mut deepest = 0;
        for (index, node) in self.nodes.iter().enumerate() {
            let depth = depths[index] + 1;
            deepest = deepest.max(depth);
            for child in node.children.iter().filter(|child| child.as_block().is_none()) {
                depths[child.0 as usize] = depth;
            }
        }
        deepest
    }

    /// The lowest and highest coordinates; `None` for a tree over nothing.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f32; 3]; 2]> {
        self.bounds.map(|bounds| [bounds.low, bounds.high])
    }

    /// The nodes and leaves, for traversals of your own. Borrow once, not per step: finding the memory
    /// costs a little.
    #[must_use]
    #[inline]
    pub fn view(&self) -> TreeView<'_> {
        TreeView { nodes: &self.nodes, words: &self.leaves.words }
    }

    pub(crate) fn aabb(&self) -> Option<Aabb> {
        self.bounds
    }

    pub(crate) fn vertices(&self) -> usize {
        self.vertices
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::MOST_BYTES;
    use crate::tree::{BLOCK, Block, VertexMap};
    use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};

    /// A sheet of two triangles a cell, row by row.
    fn sheet(side: u32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let position =
            |at: u32| [(at % side) as f32, (at / side) as f32, (at as f32 * 0.7).fract()];
        let positions = (0..side * side).map(position).collect();
        let cells = (0..side * (side - 1)).filter(|at| at % side != side - 1);
        let triangles =
            cells.flat_map(|at| [[at, at + 1, at + side], [at + 1, at + side + 1, at + side]]);
        (positions, triangles.collect())
    }

    /// The same triangles without shared vertices.
    fn unshared(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let corners = triangles.as_flattened().iter().map(|&vertex| positions[vertex as usize]);
        let triangles = (0..triangles.len() as u32).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]);
        (corners.collect(), triangles.collect())
    }

    /// The number of blocks with each kind of rows, after checking that each triangle is there once,
    /// with its corners.
    fn kinds(positions: &[[f32; 3]], triangles: &[[u32; 3]], quality: Quality) -> [usize; 3] {
        let bvh = Bvh::build(positions, triangles, quality).expect("there are few");
        let mut seen = vec![false; triangles.len()];
        let mut kinds = [0; 3];
        bvh.view().visit_blocks(Node::occupied, |block| {
            kinds[block.header().rows() as usize] += 1;
            for lane in 0..block.count() {
                let number = block.triangle(lane) as usize;
                assert!(!std::mem::replace(&mut seen[number], true), "it is there twice");
                let expected = triangles[number].map(|vertex| positions[vertex as usize]);
                assert_eq!(block.corners(lane, positions), expected);
            }
        });
        assert!(seen.into_iter().all(|seen| seen));
        assert!(bvh.memory() <= MOST_BYTES * triangles.len() + 4 * BLOCK);
        kinds
    }

    #[test]
    fn leaves_have_each_triangle_once_with_its_corners_and_bounded_memory() {
        let (positions, triangles) = sheet(60);
        let [shared, _, numbers] = kinds(&positions, &triangles, Quality::Thorough);
        assert!(shared > 500 && numbers == 0, "{shared} {numbers}");
        assert_eq!(kinds(&positions, &triangles, Quality::InOrder)[..2], [0, 0]);
        let (positions, triangles) = unshared(&positions, &triangles);
        let [shared, apart, numbers] = kinds(&positions, &triangles, Quality::Thorough);
        assert!(shared == 0 && apart > 100 && numbers > 100, "{shared} {apart} {numbers}");
    }

    /// Leaves vertices as they are.
    struct Identity;

    impl VertexMap<3> for Identity {
        #[inline(always)]
        fn map<S: Simd>(&self, position: [f32x8<S>; 3]) -> [f32x8<S>; 3] {
            position
        }
    }

    /// The first vertices of a block and all corners, axis by axis.
    fn lanes(block: Block<'_>, positions: &[[f32; 3]]) -> ([[f32; 8]; 3], [[[f32; 8]; 3]; 3]) {
        let (mut vertices, mut corners) = ([[0.0; 8]; 3], [[[0.0; 8]; 3]; 3]);
        dispatch_long!(Level::baseline(), simd => {
            let mapped = block.map_corners(simd, positions, &Identity);
            let first = block.vertices(simd, 0);
            for axis in 0..3 {
                first[axis].store_slice(&mut vertices[axis]);
                for corner in 0..3 {
                    mapped[corner][axis].store_slice(&mut corners[corner][axis]);
                }
            }
        });
        (vertices, corners)
    }

    #[test]
    fn lanes_are_zero_beyond_vertices_and_corners_are_those_of_the_mesh() {
        let (positions, triangles) = sheet(30);
        let apart = unshared(&positions, &triangles);
        for (positions, triangles) in [(positions, triangles), apart] {
            let bvh = Bvh::build(&positions, &triangles, Quality::Thorough).expect("there are few");
            bvh.view().visit_blocks(Node::occupied, |block| {
                let (vertices, corners) = lanes(block, &positions);
                let length = block.header().row_length();
                assert!(vertices.iter().all(|row| row[length..].iter().all(|&x| x == 0.0)));
                for lane in 0..block.count() {
                    let found = corners.map(|corner| corner.map(|row| row[lane]));
                    assert_eq!(found, block.corners(lane, &positions));
                }
            });
        }
    }
}
