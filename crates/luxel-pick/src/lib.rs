//! What is under the mouse, exactly.
//!
//! Needs no renderer: meshes, cameras and window positions are enough.
//!
//! | to ask | use |
//! | --- | --- |
//! | which triangle a ray meets first, whether any, all of them, for millions of rays | [`Bvh`], [`MeshRays`] |
//! | where a place of the window lies in the world, and back | [`unproject`], [`project`], [`window_ray`], [`pick_matrix`] |
//! | what pixels a mouse position means | [`LogicalPosition`], [`PhysicalPosition`] |

#![forbid(unsafe_code)]

mod bvh;
mod intersect;
mod rays;
mod unproject;
mod window;

pub use bvh::{Bvh, MAX_TRIANGLES, Quality, TooManyForTree};
pub use intersect::Ray;
pub use rays::{MeshRays, RayHit};
pub use unproject::{SightLine, Viewport, pick_matrix, project, unproject, unproject4, window_ray};
pub use window::{LogicalPosition, LogicalSize, PhysicalPosition, PhysicalSize, flip_y};
