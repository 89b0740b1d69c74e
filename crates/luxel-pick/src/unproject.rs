//! Projection from world space to the window and back, in f64.
//!
//! Functions named after GLU's have their semantics (`gluProject`, `gluUnProject`,
//! `gluUnProject4`, `gluPickMatrix`: GLU 1.3, chapter 4): windows begin at the lower left, depth is
//! 0 near and 1 far, `view` is the modelview matrix and `clip_from_view` the projection.
//! [`flip_y`](crate::flip_y) converts to windows that begin at the upper left.

use crate::window::PhysicalPosition;
use glam::{DMat4, DVec2, DVec3, DVec4};
use luxel_scene::{Camera, Projection, Size};
use luxel_visibility::WindowRays;

/// A viewport (`glViewport`): lower left corner and size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// The left side.
    pub x: f64,
    /// The lower side.
    pub y: f64,
    /// Pixels across.
    pub width: f64,
    /// Pixels up.
    pub height: f64,
}

impl Viewport {
    /// A whole window.
    #[must_use]
    pub fn of(size: Size) -> Self {
        Self { x: 0.0, y: 0.0, width: f64::from(size.width), height: f64::from(size.height) }
    }
}

/// Projects to the window (`gluProject`): x, y in pixels from the lower left, depth from 0
/// near to 1 far. `None` in the eye's plane, where w is 0.
///
/// ```
/// use luxel_pick::{project, unproject, Viewport};
/// use luxel_scene::{DMat4, DVec3, Lens, Projection, Size};
///
/// let size = Size { width: 640, height: 480 };
/// let lens = Lens::Perspective { fov_y_radians: 0.8 };
/// let projection = Projection { lens, near: 0.1, far: 100.0 }.clip_from_view(size);
/// let viewport = Viewport::of(size);
/// let window = project(DVec3::new(0.0, 0.0, -5.0), &DMat4::IDENTITY, &projection, viewport).unwrap();
/// assert_eq!(window.truncate().to_array(), [320.0, 240.0]);
/// let back = unproject(window, &DMat4::IDENTITY, &projection, viewport).unwrap();
/// assert!(back.abs_diff_eq(DVec3::new(0.0, 0.0, -5.0), 1e-9));
/// ```
#[must_use]
pub fn project(
    object: DVec3,
    view_from_object: &DMat4,
    clip_from_view: &DMat4,
    viewport: Viewport,
) -> Option<DVec3> {
    let clip = *clip_from_view * (*view_from_object * object.extend(1.0));
    if clip.w == 0.0 {
        return None;
    }
    let ndc = clip.truncate() / clip.w;
    let unit = ndc * 0.5 + DVec3::splat(0.5);
    Some(DVec3::new(
        viewport.x + unit.x * viewport.width,
        viewport.y + unit.y * viewport.height,
        unit.z,
    ))
}

/// Unprojects from the window (`gluUnProject`). `None` if the matrices have no inverse or the point lies
/// at infinity.
#[must_use]
pub fn unproject(
    window: DVec3,
    view_from_object: &DMat4,
    clip_from_view: &DMat4,
    viewport: Viewport,
) -> Option<DVec3> {
    let object =
        unproject4(window.extend(1.0), view_from_object, clip_from_view, viewport, [0.0, 1.0])?;
    (object.w != 0.0).then(|| object.truncate() / object.w)
}

/// Unprojects to homogeneous coordinates (`gluUnProject4`): `window.w` is the
/// clip w, `depth_range` that of `glDepthRange`. Unlike [`unproject`] it also returns points at
/// infinity, whose w is 0. `None` if the matrices have no inverse or the viewport or range is
/// empty.
#[must_use]
pub fn unproject4(
    window: DVec4,
    view_from_object: &DMat4,
    clip_from_view: &DMat4,
    viewport: Viewport,
    [near, far]: [f64; 2],
) -> Option<DVec4> {
    let object_from_clip = inverse(&(*clip_from_view * *view_from_object))?;
    let unit = DVec3::new(
        (window.x - viewport.x) / viewport.width,
        (window.y - viewport.y) / viewport.height,
        (window.z - near) / (far - near),
    );
    let object = object_from_clip * (unit * 2.0 - DVec3::ONE).extend(window.w);
    object.is_finite().then_some(object)
}

/// Projects a point to a camera's picture: x, y in pixels from the upper left, depth from 0 near to 1 far. `None`
/// behind the eye.
#[must_use]
pub fn place_in_picture(camera: &Camera, size: Size, point: DVec3) -> Option<DVec3> {
    let (view, clip) = (&camera.view_from_world, camera.projection.clip_from_view(size));
    let is_before = -view.transform_point3(point).z > 0.0 || camera.projection.is_orthographic();
    let place = project(point, view, &clip, Viewport::of(size)).filter(|_| is_before)?;
    Some(DVec3::new(place.x, f64::from(size.height) - place.y, place.z))
}

/// The point in world space at a place of a camera's picture: the inverse of [`place_in_picture`]. `None` if it lies
/// at infinity.
#[must_use]
pub fn point_in_picture(camera: &Camera, size: Size, place: DVec3) -> Option<DVec3> {
    let clip = camera.projection.clip_from_view(size);
    let place = DVec3::new(place.x, f64::from(size.height) - place.y, place.z);
    unproject(place, &camera.view_from_world, &clip, Viewport::of(size))
        .filter(|point| point.is_finite())
}

/// The inverse, if there is one.
fn inverse(matrix: &DMat4) -> Option<DMat4> {
    let inverse = matrix.inverse();
    (matrix.determinant() != 0.0 && inverse.is_finite()).then_some(inverse)
}

/// The matrix that makes a rectangle fill the clip volume (`gluPickMatrix`): `centre` in the
/// window, origin lower left, `size` in pixels. Multiplied from the left with a projection it gives
/// one that sees only the rectangle. `None` if a side of the rectangle isn't above 0.
#[must_use]
pub fn pick_matrix(centre: DVec2, size: DVec2, viewport: Viewport) -> Option<DMat4> {
    if !(size.x > 0.0 && size.y > 0.0) {
        return None;
    }
    let scale = DVec3::new(viewport.width / size.x, viewport.height / size.y, 1.0);
    let shift = DVec3::new(
        (viewport.width + 2.0 * (viewport.x - centre.x)) / size.x,
        (viewport.height + 2.0 * (viewport.y - centre.y)) / size.y,
        0.0,
    );
    Some(DMat4::from_translation(shift) * DMat4::from_scale(scale))
}

/// The visible part of the line of sight through a window position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SightLine {
    /// The origin in world space: the eye, or the point in the eye's plane for orthographic cameras.
    pub origin: DVec3,
    /// The unit direction in world space.
    pub direction: DVec3,
    /// The distances of the near plane and the far one, which may be infinite.
    pub range: [f64; 2],
}

/// The line of sight through a window position, in pixels from the *upper left*, for any camera:
/// perspective, orthographic, off-centre, without a far plane.
#[must_use]
pub fn window_ray(camera: &Camera, size: Size, place: impl Into<PhysicalPosition>) -> SightLine {
    let [x, y] = place.into().to_array();
    let Projection { near, far, .. } = camera.projection;
    let (origin, direction) = WindowRays::new(&camera.projection, size).ray(x, y);
    let world_from_view = camera.view_from_world.inverse();
    // The direction has z = -1, so its length turns depths into distances.
    let length = direction.length();
    SightLine {
        origin: world_from_view.transform_point3(origin),
        direction: world_from_view.transform_vector3(direction / length),
        range: [near * length, far * length],
    }
}
