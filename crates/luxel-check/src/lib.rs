//! Finds mesh faults that spoil shading: where they are, how severe, and how to fix them.
//!
//! [`check`] examines a [`Scene`](luxel_scene::Scene) as loaded, for faults that a renderer can't
//! repair: triangles without area, inconsistent winding, gaps, normals that contradict the faces,
//! and meshes too coarse for the view. `docs/check.md` describes each kind with its formula and
//! thresholds. [`Report::marked`] makes a scene that shows all findings,
//! [`Report::picture`] a picture of them with a legend.
//!
//! The severity of a finding is measured: the mesh is rendered as it is and with the finding
//! repaired, and the pictures are compared ([`Finding::severity`]).
//!
//! Neighbours are found by sorting edges, points near edges by a k-d tree, so that the time grows
//! little faster than the mesh.

#![forbid(unsafe_code)]

mod canvas;
mod cure;
mod examination;
mod faces;
mod finding;
mod gaps;
mod hidden_folds;
mod highlight_loss;
mod json;
mod kd_tree;
mod lettering;
mod marked_scene;
mod missed_highlights;
mod normals;
mod picture;
mod report;
mod screen_drift;
mod severity;
mod sight;
mod silhouette;
mod surface;
mod winding;

pub use examination::check;
pub use finding::{Finding, Hint, Kind, Place};
pub use report::{Report, Setup};
