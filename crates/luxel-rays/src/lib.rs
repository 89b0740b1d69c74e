//! Rays in world space through the meshes of a scene.
//!
//! | query | use |
//! | --- | --- |
//! | [`SceneRays::closest`] | what a ray hits first |
//! | [`SceneRays::any`] | whether something lies in its way |
//! | [`SceneRays::closest_of_each`], [`SceneRays::any_of_each`] | the same for batches of rays, traced together |
//! | [`SceneRays::all`] | all that it hits, nearest first |
//! | [`SceneRays::transmittance`], [`SceneRays::transmittance_of_lanes`], [`SceneRays::blockers`] | how much light comes along it, and what keeps the rest |
//! | [`SceneRays::places`] | where rays leave a triangle without hitting it |
//! | [`SceneRays::terminator_offset`] | how far above it the curved surface lies that it stands for |
//!
//! Picks, shadows and openness go through these trees.

#![forbid(unsafe_code)]

mod batches;
mod bodies;
mod body_tree;
mod memory;
mod queries;
mod ray_lanes;
mod scene_rays;
mod surface_place;
mod terminator_offset;
mod transmittance;
mod world_ray;

pub use body_tree::BodyTree;
pub use luxel_bvh::{Quality, TooManyForTree};
pub use ray_lanes::{RayLanes, Spread};
pub use scene_rays::{MeshTrees, RaysError, SceneRays};
pub use surface_place::{LIFT, PlaceLanes, SurfacePlace, TrianglePlaces};
pub use transmittance::Blocker;
pub use world_ray::{RebasedRay, WorldHit, WorldRay};

/// The examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
