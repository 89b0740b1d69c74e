//! Cameras: position of the eye, and projection onto the window.

use crate::NodeId;
use glam::{DMat4, DVec3, DVec4};

/// A picture's size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Size {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

/// The projection, without the clipping planes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Lens {
    /// A symmetric perspective.
    Perspective {
        /// The angle of view from bottom to top.
        fov_y_radians: f64,
    },
    /// Parallel rays.
    Orthographic {
        /// World units from bottom to top.
        height: f64,
    },
    /// A calibrated camera, off-centre where the principal point isn't the window's middle.
    Intrinsics {
        /// Focal length in pixels, across.
        fx: f64,
        /// Focal length in pixels, down.
        fy: f64,
        /// The principal point's x in window coordinates.
        cx: f64,
        /// The principal point's y in window coordinates, downwards.
        cy: f64,
    },
}

/// The planes of the clip volume, x, y and z from -w to w: plane . corner >= 0 inside.
pub const CLIP_VOLUME: [DVec4; 6] = [
    DVec4::new(1.0, 0.0, 0.0, 1.0),
    DVec4::new(-1.0, 0.0, 0.0, 1.0),
    DVec4::new(0.0, 1.0, 0.0, 1.0),
    DVec4::new(0.0, -1.0, 0.0, 1.0),
    DVec4::new(0.0, 0.0, 1.0, 1.0),
    DVec4::new(0.0, 0.0, -1.0, 1.0),
];

/// A lens with its clipping planes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Projection {
    /// The lens.
    pub lens: Lens,
    /// The distance of the near plane along the viewing axis; positive for perspectives.
    pub near: f64,
    /// The distance of the far plane; infinite for a perspective without one.
    pub far: f64,
}

/// A camera: view transform, lens and clipping planes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Camera {
    /// From world space to the camera's own, which looks along -Z with +Y up: a rotation and a
    /// translation.
    pub view_from_world: DMat4,
    /// The projection.
    pub projection: Projection,
}

/// A camera of a file, hanging on a node.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SceneCamera {
    /// Its name.
    pub name: String,
    /// The node; `None` is the world.
    pub node: Option<NodeId>,
    /// From the node's coordinates (the world's without one) to the camera's own: a rotation and a
    /// translation.
    pub view_from_node: DMat4,
    /// The lens.
    pub lens: Lens,
    /// The file's clipping planes, near and far, if it has them.
    pub planes: Option<(f64, f64)>,
}

impl Projection {
    /// The projection matrix of OpenGL (`glFrustum`, `glOrtho`): clip x, y, z from -w to w, z = -w
    /// at the near plane.
    #[must_use]
    pub fn clip_from_view(&self, size: Size) -> DMat4 {
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        let (near, far) = (self.near, self.far);
        // Third row for perspectives: z_clip = a z + b, w_clip = -z.
        let (a, b) = if far.is_infinite() {
            (-1.0, -2.0 * near)
        } else {
            ((far + near) / (near - far), 2.0 * far * near / (near - far))
        };
        let perspective = |x: f64, y: f64, skew_x: f64, skew_y: f64| {
            DMat4::from_cols(
                DVec4::new(x, 0.0, 0.0, 0.0),
                DVec4::new(0.0, y, 0.0, 0.0),
                DVec4::new(skew_x, skew_y, a, -1.0),
                DVec4::new(0.0, 0.0, b, 0.0),
            )
        };
        match self.lens {
            Lens::Perspective { fov_y_radians } => {
                let y = 1.0 / libm::tan(fov_y_radians * 0.5);
                perspective(y * height / width, y, 0.0, 0.0)
            }
            Lens::Intrinsics { fx, fy, cx, cy } => perspective(
                2.0 * fx / width,
                2.0 * fy / height,
                1.0 - 2.0 * cx / width,
                2.0 * cy / height - 1.0,
            ),
            Lens::Orthographic { height: extent } => {
                let y = 2.0 / extent;
                DMat4::from_cols(
                    DVec4::new(y * height / width, 0.0, 0.0, 0.0),
                    DVec4::new(0.0, y, 0.0, 0.0),
                    DVec4::new(0.0, 0.0, -2.0 / (far - near), 0.0),
                    DVec4::new(0.0, 0.0, -(far + near) / (far - near), 1.0),
                )
            }
        }
    }

    /// Window depth of a distance z along the viewing axis, as `glDepthRange(0, 1)` gives it: 0 at
    /// the near plane, 1 at the far one; clamped to that range.
    ///
    /// far (z - near) / (z (far - near)) for perspectives, linear for parallel rays.
    #[must_use]
    pub fn window_depth(&self, z: f64) -> f64 {
        let Self { near, far, .. } = *self;
        let depth = if self.is_orthographic() {
            (z - near) / (far - near)
        } else if far.is_infinite() {
            1.0 - near / z
        } else {
            far * (z - near) / (z * (far - near))
        };
        depth.clamp(0.0, 1.0)
    }

    /// Whether rays are parallel.
    #[must_use]
    pub fn is_orthographic(&self) -> bool {
        matches!(self.lens, Lens::Orthographic { .. })
    }
}

impl Camera {
    /// The rotation and translation of a camera at `eye` that looks to `target`, `up` pointing up
    /// in the image (`gluLookAt`), its axes orthonormal to 1e-15. If `up` is parallel to the view,
    /// another axis replaces it.
    #[must_use]
    pub fn look_at(eye: DVec3, target: DVec3, up: DVec3) -> DMat4 {
        let back = (eye - target).normalize_or(DVec3::Z);
        let right = perpendicular(up.cross(back), back);
        let up = back.cross(right);
        let world_from_view =
            DMat4::from_cols(right.extend(0.0), up.extend(0.0), back.extend(0.0), eye.extend(1.0));
        rigid_inverse(&world_from_view)
    }

    /// The eye's place in world space.
    #[must_use]
    pub fn eye(&self) -> DVec3 {
        rigid_inverse(&self.view_from_world).w_axis.truncate()
    }

    /// The direction of the view in world space, of unit length.
    #[must_use]
    pub fn direction(&self) -> DVec3 {
        -self.view_from_world.row(2).truncate()
    }
}

/// The direction of `cross`, a product with the unit vector `axis`, perpendicular to the axis to 1e-15; any
/// perpendicular one where the product holds nothing but rounding.
///
/// A product of vectors that are nearly parallel is short, and its rounding large beside it: what lies
/// along the axis is taken away (Gram and Schmidt), as long as there is any.
fn perpendicular(cross: DVec3, axis: DVec3) -> DVec3 {
    const NOTICEABLE: f64 = 5e-16;
    let mut direction = cross.try_normalize();
    for _ in 0..3 {
        let Some(unit) = direction else { break };
        let along = unit.dot(axis);
        if along.abs() <= NOTICEABLE {
            return unit;
        }
        let rest = unit - axis * along;
        direction = if along.abs() < 0.5 { rest.try_normalize() } else { None };
    }
    direction.unwrap_or_else(|| axis.any_orthonormal_vector())
}

/// The inverse of a rotation and translation: transpose the one, turn the other round.
fn rigid_inverse(matrix: &DMat4) -> DMat4 {
    let [x, y, z] = [0, 1, 2].map(|row| matrix.row(row).truncate());
    let translation = matrix.w_axis.truncate();
    let eye = -(x * translation.x + y * translation.y + z * translation.z);
    DMat4::from_cols(x.extend(0.0), y.extend(0.0), z.extend(0.0), eye.extend(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_orthonormal_however_near_the_view_is_to_the_up_axis() {
        let mut worst = 0.0_f64;
        for step in 0..4_000_u32 {
            let off = libm::pow(10.0, -f64::from(step) / 200.0);
            let turn = f64::from(step) * 2.399_963;
            let aside = DVec3::new(libm::cos(turn), 0.0, libm::sin(turn)) * off;
            for up in [DVec3::Y, DVec3::new(0.3, 1.7, -0.6)] {
                let eye = DVec3::new(0.7, -3.1, 12.9);
                let view = Camera::look_at(eye, eye + (up + aside) * 7.3, up);
                let [x, y, z] = [0, 1, 2].map(|row| view.row(row).truncate());
                for (a, b) in [(x, y), (y, z), (z, x)] {
                    worst = worst.max(a.dot(b).abs());
                }
                for axis in [x, y, z] {
                    worst = worst.max((axis.length() - 1.0).abs());
                }
            }
        }
        assert!(worst <= 1e-15, "{worst:e}");
    }

    #[test]
    fn looking_down_minus_z_from_the_origin_changes_nothing() {
        let view = Camera::look_at(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y);
        assert!(view.abs_diff_eq(DMat4::IDENTITY, 1e-15));
    }

    #[test]
    fn the_eye_is_found_again_from_the_matrix() {
        let eye = DVec3::new(3.0, -2.0, 7.5);
        let view_from_world = Camera::look_at(eye, DVec3::ONE, DVec3::Y);
        let projection =
            Projection { lens: Lens::Orthographic { height: 1.0 }, near: 0.0, far: 1.0 };
        let camera = Camera { view_from_world, projection };
        assert!(camera.eye().abs_diff_eq(eye, 1e-14));
        assert!(camera.direction().abs_diff_eq((DVec3::ONE - eye).normalize(), 1e-14));
    }

    #[test]
    fn intrinsics_of_a_centred_camera_are_its_field_of_view() {
        let size = Size { width: 640, height: 480 };
        let fov_y_radians = 0.8;
        let f = 240.0 / libm::tan(0.4);
        let of = |lens| Projection { lens, near: 0.1, far: 10.0 }.clip_from_view(size);
        let symmetric = of(Lens::Perspective { fov_y_radians });
        let calibrated = of(Lens::Intrinsics { fx: f, fy: f, cx: 320.0, cy: 240.0 });
        assert!(symmetric.abs_diff_eq(calibrated, 1e-14));
    }
}
