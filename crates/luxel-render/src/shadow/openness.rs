//! Openness: how much of the sky over a place nothing is in the way of.

use super::receiver::Shadows;
use super::sequence::Scramble;
use glam::DVec3;
use luxel_rays::{SurfacePlace, WorldRay};

/// The purpose of openness among the sequences of a sample; lights have their numbers.
const PURPOSE: u32 = u32::MAX;

/// How openness is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OpennessRule {
    /// What lies farther away doesn't count.
    pub(crate) radius: f64,
    /// Rays a sample.
    pub(crate) rays: u32,
}

impl Shadows<'_> {
    /// The openness of a place with the shading normal N: the mean of what comes along rays about N, more
    /// of them near it by the cosine of their angle, as ambient light arrives:
    ///
    /// ```text
    /// openness = 1/pi integral over the hemisphere of T(d) (N.d) dd
    /// ```
    ///
    /// A ground under the model counts as near, too. Directions below the triangle itself are mirrored at its plane: a convex surface is open, however
    /// its normals lean.
    pub(crate) fn openness(
        &self,
        rule: OpennessRule,
        place: &SurfacePlace,
        [x, y, z]: [f32; 3],
        position: [f64; 2],
    ) -> f32 {
        let normal = DVec3::new(x.into(), y.into(), z.into());
        let Some(normal) = normal.try_normalize() else { return 1.0 };
        let (tangent, bitangent) = normal.any_orthonormal_pair();
        let scramble = Scramble::new(position, PURPOSE);
        let origin = place.origin();
        let mut sum = 0.0;
        for number in 0..rule.rays {
            let [u, v] = self.disc.place(number, scramble);
            let up = (1.0 - u * u - v * v).max(0.0).sqrt();
            let direction = tangent * u + bitangent * v + normal * up;
            let below = place.normal.dot(direction).min(0.0);
            let direction = direction - place.normal * (2.0 * below);
            let ray = WorldRay { origin, direction, range: [0.0, rule.radius] };
            if !self.floor.is_some_and(|floor| floor.meets(&ray)) {
                sum += self.rays.transmittance(&ray);
            }
        }
        sum / rule.rays as f32
    }
}
