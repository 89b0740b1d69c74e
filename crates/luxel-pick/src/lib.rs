//! What is under the mouse, exactly.
//!
//! Needs no renderer: meshes, cameras and window positions are enough.
//!
//! | to ask | use |
//! | --- | --- |
//! | which triangle a ray meets first, whether any, all of them, for millions of rays | [`Bvh`], [`MeshRays`] |
//! | what a frame shows at a pixel, and what lies behind it | [`Picker`], [`PickView`] |
//! | what reaches into a rectangle or a polygon of the window, how near and how far | [`Region`], [`PickView::sliver`] |
//! | what is seen there, in how many pixels | [`PickView::visible_in`], [`VisibleIds`] |
//! | what is drawn under which names falls into a pick matrix | [`Selection`] |
//! | which vertex or edge is near, what a cursor snaps to | [`PickView::polygon_of`], [`PickView::snap`] |
//! | what a ray through the world meets | [`Picker::closest`] |
//! | where a place of the window lies in the world, and back | [`unproject`], [`project`], [`window_ray`], [`pick_matrix`] |
//! | what pixels a mouse position means | [`LogicalPosition`], [`PhysicalPosition`] |

#![forbid(unsafe_code)]

mod bvh;
mod cover;
mod intersect;
mod names;
mod near;
mod picker;
mod rays;
mod region;
mod sliver;
mod told;
mod unproject;
mod view;
mod visible;
mod window;
mod world_rays;

pub use bvh::{Bvh, MAX_TRIANGLES, Quality, TooManyForTree};
pub use intersect::Ray;
pub use names::{HitRecord, MAX_NAMES, NameError, Selected, Selection};
pub use near::{NearEdge, NearPolygon, NearVertex, SnapTo, Snapped, SnappedTo};
pub use picker::{PickError, Picker};
pub use rays::{MeshRays, RayHit};
pub use region::{MAX_CORNERS, Region, RegionError};
pub use sliver::{Inclusion, SliverHit};
pub use told::{Element, PickHit};
pub use unproject::{SightLine, Viewport, pick_matrix, project, unproject, unproject4, window_ray};
pub use view::PickView;
pub use visible::{NOTHING, VisibleHit, VisibleIds};
pub use window::{LogicalPosition, LogicalSize, PhysicalPosition, PhysicalSize, flip_y};
pub use world_rays::{WorldHit, WorldRay};
