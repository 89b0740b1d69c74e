//! Culls clusters of which every triangle faces away, by their cones of normals.
//!
//! Where back faces are left out, half of a closed mesh is. The normals of a cluster's triangles lie
//! about an axis a: |n - a| <= s. For an eye e and a ball about the cluster, with centre m and radius r,
//! directions d from the eye to its points lie about D = (m - e) / |m - e|, and
//! n . d >= a . D - s - 2 r / (sqrt(3) |m - e|) =: c for r <= 0.8 |m - e|. With c > 0 all triangles are
//! seen from behind.
//!
//! What is drawn are triangles with snapped corners, though, and a narrow one may turn over as it is
//! snapped. A triangle of longest side L and height h upon it has a doubled area in the window of at
//! least f^2 L h c / z^2, for a focal length of f pixels and a depth of z at most, and no side there is
//! longer than f L T / z', with z' the least depth and T = 1 + sqrt(|p - e|^2 - z'^2) / z'. Moving each corner by e
//! pixels changes the doubled area by little more than 3 e times the longest side; so nothing turns
//! over if f h c z' / (z^2 T) is several times e. Besides snapping, e holds the rounding of transforms.

use crate::cluster::{BOUNDS_WORDS, CONE_WORDS};
use crate::types::{CullFaces, WindowTransform};
use glam::{DMat3, DMat4, DVec3};
use luxel_math::{LANES, Simd, f32x16, prelude::*};
use luxel_scene::{Projection, Size};

/// The eye and the focal length of a view, in an instance's own space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ConeCuller {
    /// The eye; of parallel rays the direction.
    eye: [f32; 3],
    parallel: bool,
    /// View space in units of the mesh's.
    scale: f32,
    /// f^2 by the larger of f across and down, f being the smaller one, in steps of 1/256 pixel.
    focal: f32,
    /// How faces turned away lie in the window.
    away: CullFaces,
}

/// c is at least this, so that rounding in f32 doesn't matter.
const LEAST_COSINE: f32 = 0.02;
/// How often the height in the window holds what corners may be moved by: three times, and once more
/// where sides are as short as that.
const SAFETY: f32 = 5.0;
/// Corners are moved by snapping: half a step across and half a step down.
const SNAPPING: f32 = 0.75;
/// Twice what four products and sums, and a division, lose in parts of the largest term.
const ROUNDING: f32 = 8.0 * f32::EPSILON;

impl ConeCuller {
    /// `None` where the transform keeps no angles: what is known of a cluster doesn't hold then.
    pub(crate) fn new(
        projection: &Projection,
        size: Size,
        view_from_local: &DMat4,
    ) -> Option<Self> {
        let linear = DMat3::from_mat4(*view_from_local);
        let squares = linear.transpose() * linear;
        let square = squares.x_axis.x;
        let uneven = squares - DMat3::from_diagonal(DVec3::splat(square));
        let largest =
            uneven.to_cols_array().into_iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let is_known = square > 0.0 && square.is_finite() && largest <= 1e-9 * square;
        if !is_known {
            return None;
        }
        let inverse = view_from_local.inverse();
        let parallel = projection.is_orthographic();
        let eye = if parallel {
            inverse.transform_vector3(DVec3::NEG_Z).normalize_or_zero()
        } else {
            inverse.transform_point3(DVec3::ZERO)
        };
        let clip = projection.clip_from_view(size);
        let across = (clip.x_axis.x * 128.0 * f64::from(size.width)).abs();
        let down = (clip.y_axis.y * 128.0 * f64::from(size.height)).abs();
        let (shorter, longer) = (across.min(down), across.max(down));
        let focal = shorter * shorter / longer;
        let is_mirrored = linear.determinant() < 0.0;
        let away = if is_mirrored { CullFaces::CounterClockwise } else { CullFaces::Clockwise };
        let eye = eye.as_vec3().to_array();
        Some(Self { eye, parallel, scale: square.sqrt() as f32, focal: focal as f32, away })
    }

    /// How faces that are turned away lie in the window.
    pub(crate) fn away(&self) -> CullFaces {
        self.away
    }

    /// Which of sixteen clusters turn their back as a whole, a bit each. `bounds` are their boxes, and
    /// `depths` the least and greatest w of their corners in clip coordinates.
    #[inline(always)]
    pub(crate) fn sees_only_backs<S: Simd>(
        &self,
        simd: S,
        transform: &WindowTransform,
        bounds: &[f32],
        cones: &[f32],
        [nearest, farthest]: [f32x16<S>; 2],
    ) -> u32 {
        debug_assert_eq!((bounds.len(), cones.len()), (BOUNDS_WORDS, CONE_WORDS));
        let row = |words: &[f32], row: usize| {
            f32x16::from_slice(simd, &words[row * LANES..(row + 1) * LANES])
        };
        let zero = f32x16::splat(simd, 0.0);
        let (mut squared_radius, mut squared_distance, mut along) = (zero, zero, zero);
        let mut largest = [zero; 3];
        for axis in 0..3 {
            let (low, high) = (row(bounds, axis), row(bounds, axis + 3));
            let half = (high - low) * 0.5;
            squared_radius += half * half;
            largest[axis] = SimdBase::abs(low).max(SimdBase::abs(high));
            let towards = if self.parallel {
                f32x16::splat(simd, self.eye[axis])
            } else {
                (low + high) * 0.5 - self.eye[axis]
            };
            squared_distance += towards * towards;
            along += towards * row(cones, axis);
        }
        let radius = SimdFloat::sqrt(squared_radius);
        let distance = SimdFloat::sqrt(squared_distance);
        // How much the directions of rays to the cluster differ, in the measure of the normals' spread.
        let rays = if self.parallel { zero } else { radius * 1.1548 / distance };
        let cosine = along / distance - row(cones, 3) - rays;

        // In steps of 1/256 pixel.
        let lengthened = if self.parallel {
            zero + 1.0
        } else {
            let farthest_point = (distance + radius) * self.scale;
            let aside = (farthest_point * farthest_point - nearest * nearest).max(zero);
            SimdFloat::sqrt(aside) / nearest + 1.0
        };
        let height = row(cones, 4) * cosine * (self.focal * self.scale) * nearest
            / (farthest * farthest * lengthened);
        let mut terms = [zero; 4];
        for (terms, row) in terms.iter_mut().zip(&transform.rows) {
            let [x, y, z] = largest;
            *terms = x * row[0].abs() + y * row[1].abs() + z * row[2].abs() + row[3].abs();
        }
        let [x, y, _, w] = terms;
        // |x / w| <= x / nearest, and its own error comes with that of w.
        let moved = (x + y) * (w / nearest + 1.0) * ROUNDING / nearest + SNAPPING;

        let known = nearest.simd_gt(0.0) & (rays.simd_lt(0.9)) & squared_radius.simd_lt(f32::MAX);
        let backs = cosine.simd_ge(LEAST_COSINE) & height.simd_ge(moved * SAFETY);
        (known & backs).to_bitmask() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transforms_that_keep_no_angles_have_no_culler() {
        let lens = luxel_scene::Lens::Perspective { fov_y_radians: 0.8 };
        let projection = Projection { lens, near: 0.1, far: 10.0 };
        let of =
            |transform| ConeCuller::new(&projection, Size { width: 64, height: 48 }, &transform);
        let away = |transform| of(transform).map(|culler| culler.away());
        let turned = DMat4::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 1.1);
        assert_eq!(away(turned * 3.0), Some(CullFaces::Clockwise));
        let mirrored = turned * DMat4::from_scale(DVec3::new(-2.0, 2.0, 2.0));
        assert_eq!(away(mirrored), Some(CullFaces::CounterClockwise));
        assert!(of(turned * DMat4::from_scale(DVec3::new(1.0, 1.0, 2.0))).is_none());
        assert!(of(DMat4::from_scale(DVec3::ZERO)).is_none());
    }
}
