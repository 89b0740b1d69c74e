//! What each sample of the window sees.
//!
//! Meshes are cut into [`Clusters`] once. A [`PlacedScene`] turns scene and camera into instances, and a
//! [`Frame`] culls and bins the clusters of all instances for one view; its tiles are then drawn independently, each into a [`Tile`] of depths and
//! triangle ids. That visibility buffer is what drawing lights, picking reads and layers show.
//!
//! One folder a stage; each imports only those above it:
//!
//! 1. `types`: ids, the grid of tiles and blocks, sample patterns, the transform to the window.
//! 2. `cluster`: cuts meshes into clusters (`cluster_builder`, along the curve of `hilbert`), and
//!    numbers the clusters of all instances.
//! 3. `cull`: drops clusters outside of the window, and clusters of back faces where those are culled
//!    (`cone_culler`); gives the others a box and a depth (`cluster_cull`). Tiles of 64x64 pixels list
//!    the clusters that reach them, near ones first (`bin`).
//! 4. `raster`: transforms the vertices of a cluster (`transform`), clips triangles where it must
//!    (`clip`), drops those that hold no sample (`sample_cull`), sets them up in exact integers
//!    (`setup`), and rasterizes 4x4 pixels (`triangles`) or 16 triangles (`small_triangles`) at a time.
//!    Other renderers set triangles up themselves ([`Triangle`]) and take their samples: of one ([`cover`],
//!    [`Sink`]), or of many that may be small ([`TriangleStream`], [`StreamSink`]).
//! 5. `query`: barycentrics of a sample ([`Forms`], [`TileForms`]), corners and normals of its triangle
//!    ([`InstanceSpace`]), the fill rule for one triangle and one sample ([`Probe`]).
//! 6. `frame`: all of it for one view.
//! 7. `placed_scene`: turns a scene and a camera into instances, for frames and picks alike.
//! 8. `clip_space`: one frame of triangles given in clip coordinates, for whoever has projected them already.
//!
//! The crate knows no light, no file and no window system. Every sample's outcome is a pure function of
//! the input: neither threads nor SIMD width nor the order of drawing can change it.

#![forbid(unsafe_code)]

mod clip_space;
mod cluster;
mod cull;
mod frame;
mod placed_scene;
mod query;
mod raster;
mod types;

pub use clip_space::{Fragment, rasterize};
pub use cluster::{
    CLUSTER_TRIANGLES, Clusters, Frames, Instance, ShadingVertex, TooManyTriangles, TriangleOf,
};
pub use frame::Frame;
pub use luxel_view::{Cull, DEFAULT_POINT_SIZE};
pub use placed_scene::{CoveragePolicy, PlacedInstance, PlacedScene, SurfaceRules};
pub use query::{
    Barycentrics, Forms, InstanceSpace, LINE_WIDTH, LinearForms, PackedForms, Probe,
    ProbedTriangle, ProjectiveForms, Reach, SeenCluster, ShadingCorners, Strokes, TILE_FORMS,
    TileForms, ViewRays, ViewSpace, WindowRays, interpolate, interpolate_corners,
    interpolate_corners_step, interpolate_step, sides, strokes, tile_of,
};
pub use raster::{
    DepthPlane, Overlap, Plane, SampleGrid, Sink, SmallPlaces, SmallSamples, SmallSink, StreamSink,
    Tile, Triangle, TriangleStream, clip_by_plane, cover, rank_step,
};
pub use types::{
    Asked, BLOCK, BLOCKS, Coverage, CullFaces, GUARD_BAND, Holes, MAX_SAMPLES, MAX_SIDE, PartUse,
    Region, Samples, TILE, TriangleId, ViewFromLocal, WindowVertex, snap,
};
