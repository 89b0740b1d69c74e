//! How much work goes into a tree.

/// How much work goes into a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// For many rays.
    #[default]
    Thorough,
    /// A little quicker to build and a little slower to trace, for a mesh that is being edited.
    Fast,
    /// Keeps the file's order of triangles: builds in a tenth of the time, for a few queries.
    /// Neighbours in the file are mostly neighbours in space; where they aren't, each query visits
    /// much of the mesh.
    InOrder,
}

/// What a tree takes beside its triangles: a node, and room behind the last block.
const A_TREE: usize = 1024;

impl Quality {
    /// An upper bound of the memory that building a tree takes, the tree included, in bytes. The few
    /// kilobytes on which each thread works aren't counted.
    #[must_use]
    pub const fn bytes_needed(self, triangles: usize) -> usize {
        let each = match self {
            // Two lists of boxes, one of numbers, and nodes that are half full at worst; leaves
            // follow when the boxes are gone.
            Self::Thorough | Self::Fast => 64 + 4 + 80,
            // No boxes; nodes and leaves exist twice for a moment.
            Self::InOrder => 4 + 2 * (4 + 17),
        };
        triangles.saturating_mul(each).saturating_add(A_TREE)
    }
}
