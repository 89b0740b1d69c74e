//! The visibility buffer against outside truth: exact coverage, rays, and itself drawn otherwise.

#![allow(clippy::unwrap_used, reason = "tests, and helpers that only tests call")]

mod barycentrics;
mod clip_space;
mod coverage;
mod layers;
mod oracle;
mod overlap;
mod perspective;
mod random;
mod same_bytes;
mod scene;
mod shared_edges;
mod solid;
mod tile_forms;
