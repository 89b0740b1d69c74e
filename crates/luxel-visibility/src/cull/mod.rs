//! Which clusters can be seen, and in which tiles.

mod bin;
mod cluster_cull;
mod cone_culler;

pub(crate) use bin::Bins;
pub(crate) use cluster_cull::{VisibleCluster, visible_clusters};
