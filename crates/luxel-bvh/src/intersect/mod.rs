//! Intersection tests: rays against boxes, rays against triangles.

mod lane_rows;
mod sheared;
mod slabs;
mod triangle;

pub(crate) use lane_rows::{
    EMPTY_ROW, LaneRange, PACKET, Row, ShearedRows, greatest, lane, load, store, width,
};
pub(crate) use sheared::ShearedRay;
pub use slabs::SlabTest;
pub(crate) use slabs::{ALMOST_ZERO, PADDING, padding, shifted};
pub(crate) use triangle::{block_hits, intersect_block, intersect_gathered, intersect_rays};
