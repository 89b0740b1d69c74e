//! The tree's memory layout: nodes of eight boxes, leaves of blocks of triangles.

mod block;
mod gather;
mod leaves;
mod node;
mod view;

pub use block::Block;
pub(crate) use block::{
    BLOCK, FIRST_AT, HAS_NUMBERS, HAS_OWN_ROWS, MORE_FOLLOW, NUMBER_AT, SPAN, VertexRows, block_at,
};
pub use gather::VertexMap;
pub(crate) use gather::{Gathered, gather, gather_corner, load_row, load_vertices, transpose};
pub(crate) use leaves::{Leaves, MeshRef};
pub(crate) use node::Tree;
pub use node::{Child, MAX_TRIANGLES, Node, WIDTH};
pub use view::{LeafBlocks, Subtree, TreeView};
