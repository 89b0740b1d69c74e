//! Meshes cut into clusters, and instances of them.

mod block;
mod cluster_builder;
mod clusters;
mod hilbert;
mod instances;
mod normal_cone;
mod repeats;
mod transient_block;
mod window_transforms;

pub(crate) use block::{Block, CLUSTER_VERTICES, GROUP_WORDS};
pub use block::{CLUSTER_TRIANGLES, ShadingVertex};
pub(crate) use clusters::BOUNDS_WORDS;
pub use clusters::{Clusters, Frames};
pub(crate) use instances::{ClusterRanks, Instances};
pub use instances::{Instance, TooManyTriangles, TriangleOf};
pub(crate) use normal_cone::CONE_WORDS;
pub(crate) use transient_block::{TransientBlock, corners};
