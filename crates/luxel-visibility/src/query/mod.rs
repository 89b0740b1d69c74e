//! Questions about single triangles and samples, answered as a frame draws them.

mod barycentric;
mod instance_transform;
mod linear_form;
mod lines_points;
mod point_coverage;
mod probed_cluster;
mod projective;
mod seen_cluster;
mod tile_forms;
mod view_rays;
mod window_rays;

pub use barycentric::{Forms, LinearForms, PackedForms};
pub use instance_transform::{InstanceSpace, ViewSpace, sides};
pub use lines_points::{LINE_WIDTH, Strokes, strokes};
pub use point_coverage::{Probe, ProbedTriangle, Reach};
pub(crate) use probed_cluster::ProbedCluster;
pub use projective::ProjectiveForms;
pub use seen_cluster::{SeenCluster, ShadingCorners};
pub use tile_forms::{
    Barycentrics, TILE_FORMS, TileForms, interpolate, interpolate_corners,
    interpolate_corners_step, interpolate_step, tile_of,
};
pub use view_rays::ViewRays;
pub use window_rays::WindowRays;
