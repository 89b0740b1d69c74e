//! Samples become pixels.

mod distinct_triangles;
mod finish;
mod lane_compaction;
mod pixels;
mod transparency;

pub(crate) use distinct_triangles::DistinctTriangles;
pub(crate) use finish::{Bytes, Finish, Linear, bytes_of};
pub(crate) use lane_compaction::LaneCompaction;
pub(crate) use pixels::{
    add_share, empty_block, empty_pixel, even_block, even_blocks, even_pixels, is_empty,
    over_backdrop, single_triangle, straight, uneven_block,
};
pub(crate) use transparency::{Layered, put_behind};
