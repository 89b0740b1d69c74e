//! V over the window: the way from a sample to the eye.

use super::window_rays::WindowRays;
use glam::{DMat3, DVec3};
use luxel_math::{Lanes, Vec3};
use luxel_scene::Camera;

/// The way from a sample to the eye as a linear form over the window, along the world's axes:
/// V = origin + across X + down Y, X and Y in pixels, not of unit length (its component along the
/// viewing axis is 1). In f32 its direction is right to 2e-7.
#[derive(Clone, Copy, Debug)]
pub struct ViewRays {
    origin: [f32; 3],
    across: [f32; 3],
    down: [f32; 3],
    /// The one direction towards the eye, of unit length, for parallel projections.
    parallel: Option<[f32; 3]>,
}

impl ViewRays {
    /// The rays of a camera.
    #[must_use]
    pub fn new(camera: &Camera, rays: &WindowRays) -> Self {
        let world_from_view = DMat3::from_mat4(camera.view_from_world).transpose();
        let towards_eye = |x: f64, y: f64| -(world_from_view * rays.ray(x, y).1);
        let f32s = |vector: DVec3| vector.as_vec3().to_array();
        let origin = towards_eye(0.0, 0.0);
        // Differences over a thousand pixels keep the digits that those over one lose.
        let slope = |x: f64, y: f64| (towards_eye(1024.0 * x, 1024.0 * y) - origin) / 1024.0;
        Self {
            origin: f32s(origin),
            across: f32s(slope(1.0, 0.0)),
            down: f32s(slope(0.0, 1.0)),
            parallel: camera.projection.is_orthographic().then(|| f32s(origin)),
        }
    }

    /// The one direction towards the eye, of unit length, for parallel projections.
    #[must_use]
    pub fn parallel(&self) -> Option<[f32; 3]> {
        self.parallel
    }

    /// N and V at unit length for a sample at (x, y) in pixels, N from a normal that is not of unit
    /// length; 0 for the zero vector.
    #[inline(always)]
    #[must_use]
    pub fn unit_vectors<N: Lanes>(&self, [x, y]: [N; 2], normal: Vec3<N>) -> (Vec3<N>, Vec3<N>) {
        let Self { origin, across, down, .. } = self;
        let view =
            Vec3::splat(x, *origin) + Vec3::splat(x, *across) * x + Vec3::splat(x, *down) * y;
        normal.normalized_pair(view)
    }
}
