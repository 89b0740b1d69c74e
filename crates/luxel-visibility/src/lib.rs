//! What each sample of the window sees.
//!
//! Meshes are cut into [`Clusters`] once. A [`Frame`] culls and bins the clusters of all instances
//! for one view; its tiles are then drawn independently, each into a [`Tile`] of depths and
//! triangle ids. That visibility buffer is what drawing lights, picking reads and layers show.
//!
//! 1. `cull`: clusters outside of the window are dropped, and those that turn their back where back
//!    faces are left out (`facing`); the others get a box and a depth.
//! 2. `bin`: tiles of 64x64 pixels list the clusters that reach them, near ones first.
//! 3. `tile`: a cluster is transformed (`transform`), its triangles clipped where they must be
//!    (`clip`), left out where they hold no sample (`sift`), set up in exact integers (`setup`) and drawn 4x4 pixels at a time (`raster`).
//! 4. [`Forms`]: where on its triangle a sample lies.
//!
//! Knows no light, no file and no window system. Every sample's outcome is a pure function of the
//! input: neither threads nor SIMD width nor the order of drawing can change it.

#![forbid(unsafe_code)]

mod barycentric;
mod bin;
mod buffer;
mod clip;
mod cluster;
mod cull;
mod cut;
mod facing;
mod frame;
mod holes;
mod open;
mod order;
mod probe;
mod raster;
mod samples;
mod setup;
mod sift;
mod small;
mod space;
mod strokes;
mod tile;
mod tile_forms;
mod transform;

pub use barycentric::{Forms, LinearForms, PackedForms, WindowRays};
pub use buffer::{BLOCK, BLOCKS, Plane, TILE, Tile, TriangleId};
pub use cluster::{CLUSTER_TRIANGLES, Clusters, Frames, ShadingVertex};
pub use cull::MAX_SIDE;
pub use frame::{Coverage, Frame, Instance, PartUse, SeenCluster, TooManyTriangles, TriangleOf};
pub use holes::{Asked, Holes};
pub use probe::{Probe, Reach};
pub use samples::{MAX_SAMPLES, Samples};
pub use setup::{Cull, CullFaces};
pub use space::{InstanceSpace, ViewFromLocal, sides};
pub use strokes::{LINE_WIDTH, POINT_SIZE, Strokes, strokes};
pub use tile_forms::{Barycentrics, TILE_FORMS, TileForms, interpolate, interpolate_corners};
