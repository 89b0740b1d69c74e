//! Clusters into the visibility buffer of a tile.

mod block_rows;
mod buffer;
mod clip;
mod large_clusters;
mod last_drawn;
mod occlusion;
mod rules;
mod sample_cull;
mod setup;
mod sink;
mod small_samples;
mod small_triangles;
mod tile;
mod tile_points;
mod transform;
mod triangle_stream;
mod triangles;

pub use buffer::{Plane, Tile};
pub(crate) use clip::clip;
pub use clip::clip_by_plane;
pub(crate) use large_clusters::LargeClusters;
pub use setup::{DepthPlane, Overlap, Triangle, rank_step};
pub use sink::{Sink, cover};
pub use small_triangles::{SampleGrid, SmallPlaces, SmallSamples, SmallSink};
pub(crate) use tile::{View, draw};
pub use triangle_stream::{StreamSink, TriangleStream};
