//! A bounding volume hierarchy over triangles.
//!
//! | query | single ray | many rays |
//! | --- | --- | --- |
//! | closest hit | [`MeshRays::closest`] | [`MeshRays::closest_of_each`] |
//! | any hit: is anything in between? | [`MeshRays::any`] | [`MeshRays::any_of_each`] |
//! | all hits | [`MeshRays::all`] | |
//!
//! [`Bvh::build`] takes positions and triangles as they are in vertex and index buffers;
//! [`Bvh::refit`] follows positions that move. Batches are traced on all threads, coherent rays in
//! packets.
//!
//! ```
//! use luxel_bvh::{Bvh, MeshRays, Quality, Ray};
//!
//! // A square of two triangles at z = 0.
//! let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let triangles = [[0, 1, 2], [0, 2, 3]];
//! let bvh = Bvh::build(&positions, &triangles, Quality::Thorough)?;
//! let rays = MeshRays::new(&bvh, &positions);
//!
//! let down = Ray::new([0.75, 0.25, 3.0], [0.0, 0.0, -1.0]);
//! let hit = rays.closest(&down).unwrap();
//! assert_eq!((hit.triangle, hit.t, hit.barycentric), (0, 3.0, [0.25, 0.5, 0.25]));
//!
//! // A shadow ray: does anything lie between a point and a light?
//! assert!(rays.any(&Ray::between([0.5, 0.25, -1.0], [0.5, 0.25, 1.0])));
//! assert!(!rays.any(&Ray::between([0.5, 0.25, 0.5], [0.5, 0.25, 1.0])));
//!
//! assert_eq!(rays.closest_of_each(&[down]), [Some(hit)]);
//! # Ok::<(), luxel_bvh::TooManyForTree>(())
//! ```
//!
//! # Guarantees
//!
//! - Watertight: no ray passes between triangles that share an edge or a vertex.
//! - Reproducible: the same bits with every instruction set and number of threads, for rays cast
//!   singly or in batches.
//! - Robust: positions and rays that aren't finite hit nothing, degenerate meshes make no deep trees.
//! - No unsafe code.
//!
//! # Queries of your own
//!
//! [`Bvh::view`] gives access to nodes and leaves: [`TreeView::visit_blocks`] visits the triangles
//! below boxes that pass a test, and [`TreeView::open`] walks in any order. [`BoxTree`] is a tree
//! over boxes of anything, such as objects with trees of their own.

#![forbid(unsafe_code)]

mod aabb;
mod box_tree;
mod build;
mod bvh;
mod intersect;
mod pages;
mod ray;
mod rays;
mod traverse;
mod tree;

pub use box_tree::BoxTree;
pub use build::Quality;
pub use bvh::{Bvh, TooManyForTree};
pub use intersect::SlabTest;
pub use ray::{Ray, RayColumns, RayHit};
pub use rays::MeshRays;
pub use tree::{
    Block, Child, LeafBlocks, MAX_TRIANGLES, Node, Subtree, TreeView, VertexMap, WIDTH,
};

/// The examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
