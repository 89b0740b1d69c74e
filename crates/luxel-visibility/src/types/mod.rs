//! Constants and small types that every stage shares.

mod faces;
mod holes;
mod part_use;
mod samples;
mod tile_grid;
mod triangle_id;
mod view_from_local;
mod window_transform;

pub use faces::CullFaces;
pub use holes::{Asked, Holes};
pub use part_use::{Coverage, PartUse};
pub use samples::{MAX_SAMPLES, Samples};
pub use tile_grid::{BLOCK, BLOCKS, Region, TILE};
pub(crate) use tile_grid::{BLOCKS_OF_TILE, LANE_X, LANE_Y};
pub(crate) use triangle_id::SLOT_BITS;
pub use triangle_id::TriangleId;
pub use view_from_local::ViewFromLocal;
pub(crate) use window_transform::{ClipVertex, WindowTransform, row_times};
pub use window_transform::{GUARD_BAND, MAX_SIDE, WindowVertex, snap};
