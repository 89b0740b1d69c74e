//! Exact picking: the objects under the mouse, in regions and along rays.
//!
//! It needs no renderer: meshes, cameras and window positions are enough.
//!
//! | query | use |
//! | --- | --- |
//! | closest, any and all hits of rays through one mesh | [`Bvh`], [`MeshRays`], from [`luxel_bvh`] |
//! | the surface that a frame shows at a pixel, and those behind it | [`Picker`], [`PickView`] |
//! | the same for thousands of places at once | [`PickView::at_many`], [`PickView::owner_at_many`] |
//! | objects that reach into a rectangle or polygon of the window, and their depths | [`Region`], [`PickView::sliver`] |
//! | objects visible there, and their pixels | [`PickView::visible_in`], [`VisibleIds`] |
//! | selection with names and a pick matrix, as in OpenGL | [`Selection`], [`depths_in_volume`] |
//! | the buffer of OpenGL's feedback mode | [`FeedbackBuffer`] |
//! | the nearest vertex or edge, snapping of cursors | [`PickView::polygon_of`], [`PickView::snap`] |
//! | hits of rays in world space | [`Picker::closest`] |
//! | window to world space, and back | [`unproject`], [`project`], [`window_ray`], [`pick_matrix`] |
//! | mouse positions in pixels | [`LogicalPosition`], [`PhysicalPosition`] |
//!
//! # In a viewer of your own
//!
//! The window system gives the mouse position in logical points, your renderer its matrices. Nothing
//! else is needed:
//!
//! ```
//! use luxel_pick::{
//!     Bvh, LogicalPosition, LogicalSize, MeshRays, Quality, Ray, Viewport, unproject,
//! };
//! use luxel_scene::{DMat4, DVec3, Lens, Projection};
//!
//! // Once per mesh: your vertex and index buffers.
//! let positions: Vec<[f32; 3]> = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
//! let triangles: Vec<[u32; 3]> = vec![[0, 1, 2]];
//! let bvh = Bvh::build(&positions, &triangles, Quality::Thorough)?;
//!
//! // From winit: `inner_size`, `scale_factor`, `CursorMoved`.
//! let scale_factor = 2.0;
//! let window = LogicalSize { width: 800.0, height: 600.0 }.to_physical(scale_factor);
//! let mouse = LogicalPosition { x: 400.0, y: 310.0 }.to_physical(scale_factor);
//!
//! // Your matrices, in f64. wgpu's depth runs from 0 to 1, OpenGL's from -1 to 1: multiply a
//! // projection for wgpu from the left by `from_translation(0, 0, -1) * from_scale(1, 1, 2)`.
//! let view_from_world = DMat4::from_translation(DVec3::new(0.0, 0.0, -5.0));
//! let lens = Lens::Perspective { fov_y_radians: 0.8 };
//! let clip_from_view = Projection { lens, near: 0.1, far: 100.0 }.clip_from_view(window.into());
//!
//! // The line of sight, from the near plane to the far one. Windows begin at the upper left,
//! // GLU's at the lower left.
//! let at = mouse.flipped(window);
//! let viewport = Viewport::of(window.into());
//! let [near, far] = [0.0, 1.0].map(|depth| {
//!     unproject(at.extend(depth), &view_from_world, &clip_from_view, viewport).unwrap()
//! });
//! let ray = Ray {
//!     range: [0.0, 1.0],
//!     ..Ray::new(near.as_vec3().to_array(), (far - near).as_vec3().to_array())
//! };
//! let hit = MeshRays::new(&bvh, &positions).closest(&ray).unwrap();
//! assert_eq!(hit.triangle, 0);
//! # Ok::<(), luxel_pick::TooManyForTree>(())
//! ```
//!
//! `examples/own_renderer.rs` does so for many mesh instances, with wgpu's projections;
//! `examples/viewer.rs` picks what luxel's frames show. Both run without a window. For scenes of many
//! mesh instances there is [`Picker`]; a [`PickView`] answers what luxel's frames show, pixel by pixel,
//! and a [`VisibleIds`] takes an id buffer that your renderer has drawn.
//!
//! # Rays and pixels
//!
//! Rays hit the exact geometry. Frames snap vertices to 1/256 pixel, so that neighbours share edges
//! without gaps; at silhouettes the two may differ by 1/512 pixel. [`PickView`] follows the frame's rule
//! for visibility, and evaluates attributes on the unsnapped triangle.

#![forbid(unsafe_code)]

mod coverage_query;
mod feedback_buffer;
mod frustum;
mod pick_many;
mod picker;
mod region;
mod region_raster;
mod sample_group;
mod selection_mode;
mod sliver;
mod snapping;
mod surface_hit;
mod unproject;
mod view;
mod visible_ids;
mod window;
mod window_cells;

pub use feedback_buffer::{Feedback, FeedbackBuffer, FeedbackType, FeedbackVertex};
pub use luxel_bvh::{Bvh, MAX_TRIANGLES, MeshRays, Quality, Ray, RayHit, TooManyForTree};
pub use luxel_rays::{RaysError, SceneRays, WorldHit, WorldRay};
pub use picker::{PickError, Picker};
pub use region::{MAX_CORNERS, Region, RegionError};
pub use selection_mode::{HitRecord, MAX_NAMES, NameError, Selected, Selection};
pub use sliver::{Inclusion, SliverHit, depths_in_volume};
pub use snapping::{NearEdge, NearPolygon, NearVertex, SnapTo, Snapped, SnappedTo};
pub use surface_hit::{Element, PickHit};
pub use unproject::{
    SightLine, Viewport, pick_matrix, place_in_picture, point_in_picture, project, unproject,
    unproject4, window_ray,
};
pub use view::PickView;
pub use visible_ids::{NO_ID, VisibleHit, VisibleIds};
pub use window::{LogicalPosition, LogicalSize, PhysicalPosition, PhysicalSize, flip_y};

/// The examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
