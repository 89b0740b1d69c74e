//! Which clusters can be seen, and in which tiles.

mod bin;
mod cluster_cull;
mod cone_culler;
mod interval;
mod tile_lists;

pub(crate) use bin::Bins;
pub(crate) use cluster_cull::{VisibleCluster, visible_clusters};
pub(crate) use tile_lists::{TileLists, Tiles, nearest_first};
