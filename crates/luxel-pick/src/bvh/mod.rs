//! A tree of boxes over the triangles of a mesh: a bounding volume hierarchy.
//!
//! Nodes have eight children, whose boxes lie side by side for the vector unit (Wald, Benthin and
//! Boulos 2008): six rows of eight numbers and eight words, 224 bytes. Leaves hold their triangles'
//! vertices, as far as that and the nodes take 32 bytes a triangle. The tree is built by the surface
//! area heuristic over bins (Wald 2007) and depends on nothing but the boxes, so it is the same for
//! any number of threads.

mod bins;
mod build;
mod leaves;
mod make;
mod split;
mod traverse;

pub(crate) use build::{Boxes, build};
pub(crate) use leaves::{Block, Head, Leaves, Rows, block, corners, number, row, triangle_words};
pub(crate) use traverse::{
    ALMOST_ZERO, Ahead, PADDING, Places, Slabs, Walk, meet, moved, padding, step,
};

use bytemuck::{Pod, Zeroable};
use leaves::Mesh;
use luxel_pages::Pages;

/// Children of a node, and most triangles of a leaf: lanes of a vector.
pub(crate) const WIDTH: usize = 8;
/// Most things in one tree: 27 bits of a child word.
pub const MAX_TRIANGLES: usize = 1 << START_BITS;
const START_BITS: u32 = 27;
const LEAF: u32 = 1 << 31;

/// More triangles than a tree can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a tree over {0} triangles isn't possible: at most {MAX_TRIANGLES}")]
pub struct TooManyForTree(pub usize);

/// How many things one thread takes at a time where each takes little.
const RUN: usize = 1 << 13;

/// The boxes of up to eight children, and what they are.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(32))]
pub(crate) struct Node {
    /// Axis by axis the low planes, then the high ones; an empty place has low = inf, high = -inf.
    pub(crate) planes: [[[f32; WIDTH]; 2]; 3],
    pub(crate) children: [Child; WIDTH],
}

const _: () = assert!(size_of::<Node>() == 224, "in four cache lines, wherever one begins");

/// An inner node by number, or a leaf: one bit, four of the count, 27 of the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub(crate) struct Child(pub(crate) u32);

impl Child {
    pub(crate) const NONE: Self = Self(LEAF);

    pub(crate) const fn inner(number: u32) -> Self {
        Self(number)
    }

    pub(crate) const fn leaf(start: usize, count: usize) -> Self {
        Self(LEAF | (count as u32) << START_BITS | start as u32)
    }

    /// A leaf of a tree over triangles, by its first block.
    pub(crate) const fn block(start: usize) -> Self {
        Self(LEAF | start as u32)
    }

    /// Where a leaf's first block begins, in a tree over triangles.
    #[inline(always)]
    pub(crate) const fn as_block(self) -> Option<usize> {
        if self.0 & LEAF == 0 { None } else { Some((self.0 & !LEAF) as usize) }
    }

    /// Start and count of a leaf.
    #[inline(always)]
    pub(crate) const fn as_leaf(self) -> Option<(usize, usize)> {
        if self.0 & LEAF == 0 {
            return None;
        }
        let start = self.0 & ((1 << START_BITS) - 1);
        Some((start as usize, ((self.0 & !LEAF) >> START_BITS) as usize))
    }
}

/// A box along the axes, in f32.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Box3 {
    pub(crate) low: [f32; 3],
    pub(crate) high: [f32; 3],
}

impl Box3 {
    pub(crate) const EMPTY: Self = Self { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    pub(crate) fn around(points: [[f32; 3]; 3]) -> Self {
        let mut bounds = Self::EMPTY;
        for point in points {
            bounds.include(point);
        }
        bounds
    }

    pub(crate) fn include(&mut self, point: [f32; 3]) {
        for axis in 0..3 {
            self.low[axis] = lower(point[axis], self.low[axis]);
            self.high[axis] = higher(point[axis], self.high[axis]);
        }
    }

    pub(crate) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        for axis in 0..3 {
            union.low[axis] = lower(other.low[axis], self.low[axis]);
            union.high[axis] = higher(other.high[axis], self.high[axis]);
        }
        union
    }

    /// Half the surface; 0 for an empty box.
    pub(crate) fn half_area(&self) -> f32 {
        let extent = |axis: usize| (self.high[axis] - self.low[axis]).max(0.0);
        let [x, y, z] = [extent(0), extent(1), extent(2)];
        x * y + y * z + z * x
    }

    /// The length of the longest side.
    pub(crate) fn longest(&self) -> f32 {
        (0..3).map(|axis| self.high[axis] - self.low[axis]).fold(0.0, f32::max)
    }

    /// The largest coordinate, without its sign.
    pub(crate) fn largest(&self) -> [f32; 3] {
        std::array::from_fn(|axis| self.low[axis].abs().max(self.high[axis].abs()))
    }
}

/// `min` and `max` as the processor has them, one instruction each.
#[inline(always)]
pub(crate) fn lower(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

#[inline(always)]
pub(crate) fn higher(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// A tree over anything that has a box: nodes, and the things' numbers in the order of the leaves.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    pub(crate) nodes: Pages<Node>,
    pub(crate) items: Vec<u32>,
    pub(crate) bounds: Option<Box3>,
}

impl Node {
    pub(crate) const EMPTY: Self = Self {
        planes: [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3],
        children: [Child::NONE; WIDTH],
    };

    pub(crate) fn set(&mut self, slot: usize, bounds: &Box3, child: Child) {
        for axis in 0..3 {
            self.planes[axis][0][slot] = bounds.low[axis];
            self.planes[axis][1][slot] = bounds.high[axis];
        }
        self.children[slot] = child;
    }

    pub(crate) fn bounds(&self, slot: usize) -> Box3 {
        Box3 {
            low: [0, 1, 2].map(|axis: usize| self.planes[axis][0][slot]),
            high: [0, 1, 2].map(|axis: usize| self.planes[axis][1][slot]),
        }
    }

    /// The children's words.
    #[inline(always)]
    pub(crate) fn words(&self) -> &[u32; WIDTH] {
        bytemuck::cast_ref(&self.children)
    }

    fn all_bounds(&self) -> Box3 {
        (0..WIDTH).fold(Box3::EMPTY, |all, slot| all.union(&self.bounds(slot)))
    }
}

/// How much care goes into a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// Trees for many rays.
    #[default]
    Thorough,
    /// A little less time and a little slower rays, for a mesh that is being edited.
    Fast,
    /// Triangles as they stand in the file, without sorting: a tenth of the time, for a few
    /// questions. Neighbours in the file are mostly neighbours in space; where they aren't, each
    /// question goes through much of the mesh.
    InOrder,
}

impl Quality {
    /// What building takes for each triangle at most, the tree included, in bytes.
    #[must_use]
    pub const fn bytes_a_triangle(self) -> usize {
        match self {
            // Two lists of boxes and one of numbers, and nodes, half full at worst; leaves follow
            // when the boxes are gone.
            Self::Thorough | Self::Fast => 64 + 4 + 80,
            // The same without boxes; nodes and leaves are there twice for a moment.
            Self::InOrder => 4 + 2 * (4 + 17),
        }
    }
}

/// A tree over the triangles of one mesh, with copies of most of its positions; a
/// [`MeshRays`](crate::MeshRays) brings both together.
///
/// Triangles with a coordinate that isn't finite are left out; those without area are kept.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    nodes: Pages<Node>,
    leaves: Leaves,
    bounds: Option<Box3>,
    /// How many positions it was built over.
    vertices: usize,
}

/// What a [`Bvh`] is built over.
struct Triangles<'m> {
    positions: &'m [[f32; 3]],
    triangles: &'m [[u32; 3]],
}

impl Boxes for Triangles<'_> {
    fn count(&self) -> usize {
        self.triangles.len()
    }

    #[inline]
    fn bounds(&self, number: usize) -> Option<Box3> {
        let corners = self.triangles[number].map(|vertex| self.positions[vertex as usize]);
        let is_sound = corners.as_flattened().iter().all(|coordinate| coordinate.is_finite());
        is_sound.then(|| Box3::around(corners))
    }
}

impl Bvh {
    /// Builds a tree, on all threads of the current pool.
    ///
    /// ```
    /// use luxel_pick::{Bvh, MeshRays, Quality, Ray};
    ///
    /// let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let bvh = Bvh::build(&positions, &[[0, 1, 2]], Quality::Thorough)?;
    /// let rays = MeshRays::new(&bvh, &positions);
    /// let hit = rays.closest(&Ray::new([0.25, 0.25, 5.0], [0.0, 0.0, -1.0])).unwrap();
    /// assert_eq!((hit.triangle, hit.t), (0, 5.0));
    /// # Ok::<(), luxel_pick::TooManyForTree>(())
    /// ```
    ///
    /// # Errors
    /// [`TooManyForTree`] beyond [`MAX_TRIANGLES`].
    ///
    /// # Panics
    /// If a triangle names a position that isn't there.
    pub fn build(
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        quality: Quality,
    ) -> Result<Self, TooManyForTree> {
        if triangles.len() > MAX_TRIANGLES {
            return Err(TooManyForTree(triangles.len()));
        }
        let Tree { mut nodes, items, bounds } = build(&Triangles { positions, triangles }, quality);
        let mesh = Mesh { positions, triangles };
        let copies = quality != Quality::InOrder;
        let leaves = Leaves::new(&mut nodes, &items, &mesh, copies);
        let vertices = positions.len();
        Ok(Self { nodes, leaves, bounds, vertices })
    }

    /// Fits boxes and copies to positions that have moved, without changing the tree's shape: quicker
    /// than building, and good as long as neighbours stay neighbours. `triangles` are those that it
    /// was built over.
    ///
    /// # Panics
    /// If there are fewer positions or triangles than the tree was built over. Positions must be
    /// finite, or their triangles are missed.
    pub fn refit(&mut self, positions: &[[f32; 3]], triangles: &[[u32; 3]]) {
        assert!(positions.len() >= self.vertices, "positions are missing");
        let mesh = Mesh { positions, triangles };
        // Children have higher numbers than their parents.
        for number in (0..self.nodes.len()).rev() {
            for slot in 0..WIDTH {
                let child = self.nodes[number].children[slot];
                let bounds = match child.as_block() {
                    _ if child == Child::NONE => continue,
                    Some(start) => self.leaves.refit(start, &mesh),
                    None => self.nodes[child.0 as usize].all_bounds(),
                };
                self.nodes[number].set(slot, &bounds, child);
            }
        }
        self.bounds = self.nodes.first().map(Node::all_bounds);
    }

    /// How many triangles are in it.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.leaves.count
    }

    /// What it takes, beside the mesh, in bytes.
    #[must_use]
    pub fn memory(&self) -> usize {
        size_of_val(&self.nodes[..]) + self.leaves.memory()
    }

    /// Levels of nodes from the root down.
    #[must_use]
    pub fn depth(&self) -> usize {
        let mut depths = vec![0; self.nodes.len()];
        let mut deepest = 0;
        for (number, node) in self.nodes.iter().enumerate() {
            let depth = depths[number] + 1;
            deepest = deepest.max(depth);
            for child in node.children.iter().filter(|child| child.as_block().is_none()) {
                depths[child.0 as usize] = depth;
            }
        }
        deepest
    }

    /// Lowest and highest coordinates; `None` for a tree over nothing.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f32; 3]; 2]> {
        self.bounds.map(|bounds| [bounds.low, bounds.high])
    }

    pub(crate) fn box_of_all(&self) -> Option<Box3> {
        self.bounds
    }

    #[inline]
    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    #[inline(always)]
    pub(crate) fn leaves(&self) -> &Leaves {
        &self.leaves
    }

    pub(crate) fn vertices(&self) -> usize {
        self.vertices
    }
}
