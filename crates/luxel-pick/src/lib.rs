//! What is under the mouse, exactly.
//!
//! Needs no renderer: meshes, cameras and window positions are enough.
//!
//! | to ask | use |
//! | --- | --- |
//! | closest, any and all hits of rays through one mesh | [`Bvh`], [`MeshRays`], from [`luxel_bvh`] |
//! | what a frame shows at a pixel, and what lies behind it | [`Picker`], [`PickView`] |
//! | what reaches into a rectangle or a polygon of the window, how near and how far | [`Region`], [`PickView::sliver`] |
//! | what is seen there, in how many pixels | [`PickView::visible_in`], [`VisibleIds`] |
//! | what is drawn under which names falls into a pick matrix | [`Selection`] |
//! | which vertex or edge is near, what a cursor snaps to | [`PickView::polygon_of`], [`PickView::snap`] |
//! | what a ray through the world meets | [`Picker::closest`] |
//! | where a place of the window lies in the world, and back | [`unproject`], [`project`], [`window_ray`], [`pick_matrix`] |
//! | what pixels a mouse position means | [`LogicalPosition`], [`PhysicalPosition`] |
//!
//! # In a viewer of your own
//!
//! A window system tells where the mouse is, in logical points; your renderer has its matrices, in
//! whatever way it draws. That is all that is needed:
//!
//! ```
//! use luxel_pick::{
//!     Bvh, LogicalPosition, LogicalSize, MeshRays, Quality, Ray, Viewport, unproject,
//! };
//! use luxel_scene::{DMat4, DVec3, Lens, Projection};
//!
//! // Once a mesh: your vertex and index buffers.
//! let positions: Vec<[f32; 3]> = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
//! let triangles: Vec<[u32; 3]> = vec![[0, 1, 2]];
//! let bvh = Bvh::build(&positions, &triangles, Quality::Thorough)?;
//!
//! // From winit: `inner_size`, `scale_factor`, `CursorMoved`.
//! let scale_factor = 2.0;
//! let window = LogicalSize { width: 800.0, height: 600.0 }.to_physical(scale_factor);
//! let mouse = LogicalPosition { x: 400.0, y: 310.0 }.to_physical(scale_factor);
//!
//! // What you draw with, in f64. wgpu's depth runs from 0 to 1, OpenGL's from -1 to 1: multiply a
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
//! `examples/own_renderer.rs` is that for many meshes in their places, with wgpu's projections, and
//! `examples/viewer.rs` a viewer that asks for what luxel's frames show: both run without a window.
//! For a scene of many meshes in their places, a [`Picker`] does the rest; a [`PickView`] tells what
//! luxel's frames show, pixel by pixel, and a [`VisibleIds`] takes an id buffer that your renderer
//! has drawn.
//!
//! # Rays and pixels
//!
//! Rays tell exact geometry. Frames snap corners to 1/256 pixel, so that neighbours share edges
//! without gaps; at an outline the two may differ by 1/512 pixel. [`PickView`] goes by the frame's
//! rule for what is seen, and tells of the triangle itself where on it that is.

#![forbid(unsafe_code)]

mod coverage_query;
mod drawing;
mod frustum;
mod names;
mod picker;
mod region;
mod sliver;
mod snapping;
mod surface_hit;
mod unproject;
mod view;
mod visible;
mod window;
mod window_cells;
mod world_rays;

pub use luxel_bvh::{Bvh, MAX_TRIANGLES, MeshRays, Quality, Ray, RayHit, TooManyForTree};
pub use names::{HitRecord, MAX_NAMES, NameError, Selected, Selection};
pub use picker::{PickError, Picker};
pub use region::{MAX_CORNERS, Region, RegionError};
pub use sliver::{Inclusion, SliverHit};
pub use snapping::{NearEdge, NearPolygon, NearVertex, SnapTo, Snapped, SnappedTo};
pub use surface_hit::{Element, PickHit};
pub use unproject::{SightLine, Viewport, pick_matrix, project, unproject, unproject4, window_ray};
pub use view::PickView;
pub use visible::{NOTHING, VisibleHit, VisibleIds};
pub use window::{LogicalPosition, LogicalSize, PhysicalPosition, PhysicalSize, flip_y};
pub use world_rays::{WorldHit, WorldRay};
