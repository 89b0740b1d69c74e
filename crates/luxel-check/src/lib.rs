//! What in a mesh spoils its shading: where, how much, and what helps.
//!
//! [`check`] looks through a [`Scene`](luxel_scene::Scene) as its file has it, for what a renderer
//! can't mend: triangles without area, winding that doesn't agree, gaps, normals that say something
//! else than the faces, and for what is too coarse for the view. `docs/check.md` has each kind with
//! its formula and its thresholds. [`Report::marked`] makes a scene that shows where it all is.
//!
//! How bad a finding is, is measured: the mesh is drawn as it is and with this finding cured, and
//! the pictures are compared ([`Finding::severity`]).
//!
//! Questions about neighbours are answered by sorting edges, those about distances by a k-d tree, so
//! that the time grows hardly faster than the mesh.

#![forbid(unsafe_code)]

mod cure;
mod drift;
mod examination;
mod faces;
mod finding;
mod folds;
mod gaps;
mod highlight;
mod lost;
mod marks;
mod nearby;
mod normals;
mod report;
mod severity;
mod silhouette;
mod surface;
mod winding;

pub use examination::check;
pub use finding::{Finding, Kind, Place};
pub use report::{Report, Setup};
