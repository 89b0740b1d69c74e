//! Rays from surfaces to lights.

use glam::DVec3;
use luxel_lighting::{LightKind, PlacedLight, terminator};
use luxel_math::prelude::*;
use luxel_rays::{LIFT, PlaceLanes, RayLanes, SurfacePlace, WorldRay};

/// Where a light's rays end, in world space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightSource {
    /// Its place; `None` for a light far away.
    place: Option<DVec3>,
    /// Towards a light far away, of unit length.
    towards: DVec3,
    /// The radius of the disc that it is, as seen from a surface: at its place, or at distance 1.
    radius: f64,
}

/// Rays from surfaces to the middle of a light, and what the surfaces' own shape lets through, lane by
/// lane.
pub(super) struct ShadowLanes<N: Lanes> {
    origin: [N::F64; 3],
    direction: [N::F64; 3],
    end: N::F64,
    pub(super) terminator: N,
}

impl LightSource {
    /// A light about the eye.
    pub(crate) fn new(placed: &PlacedLight, eye: DVec3) -> Self {
        let vector = |[x, y, z]: [f32; 3]| DVec3::new(x.into(), y.into(), z.into());
        let light = placed.light();
        let place = light.kind.has_place().then(|| eye + vector(placed.position()));
        let radius = match light.kind {
            LightKind::Directional => libm::tan(f64::from(light.angle_degrees).to_radians() * 0.5),
            _ => f64::from(light.radius),
        };
        Self { place, towards: -vector(placed.direction()), radius }
    }

    /// Whether it has no extent.
    pub(super) fn is_point(&self) -> bool {
        self.radius <= 0.0
    }

    /// The ray from a place to a place on the disc that faces it; `None` if that lies behind the triangle.
    pub(super) fn ray_to(
        &self,
        place: &SurfacePlace,
        axis: DVec3,
        [u, v]: [f64; 2],
    ) -> Option<WorldRay> {
        let (tangent, bitangent) = axis.any_orthonormal_pair();
        let aside = (tangent * u + bitangent * v) * self.radius;
        let origin = place.origin();
        let (direction, end) = match self.place {
            None => ((axis + aside).normalize(), f64::INFINITY),
            Some(light) => {
                let way = (light + aside - origin).to_array();
                let (direction, end) = ending_at(way, place.normal.to_array());
                (DVec3::from_array(direction), end)
            }
        };
        let range = [0.0, end];
        (place.normal.dot(direction) > 0.0).then_some(WorldRay { origin, direction, range })
    }
}

/// The direction of a way, and its length but for [`LIFT`] of it, so that a surface on which the light
/// itself lies doesn't keep it away; the normal's where the way has no length.
#[inline(always)]
fn ending_at<F: F64Lanes>(way: [F; 3], normal: [F; 3]) -> ([F; 3], F) {
    let length = dot(way, way).sqrt();
    let ([x, y, z], [normal_x, normal_y, normal_z]) = (way, normal);
    let is_far = length.is_positive();
    let direction = [
        (x / length).select(is_far, normal_x),
        (y / length).select(is_far, normal_y),
        (z / length).select(is_far, normal_z),
    ];
    (direction, length * length.constant(1.0 - LIFT))
}

/// The product of two vectors, lane by lane.
#[inline(always)]
pub(super) fn dot<F: F64Lanes>([x, y, z]: [F; 3], [a, b, c]: [F; 3]) -> F {
    x * a + y * b + z * c
}

impl<N: Lanes> ShadowLanes<N> {
    /// From places with the shading normals N to the middle of a light.
    #[inline(always)]
    pub(super) fn new(
        places: &PlaceLanes<N::F64>,
        source: &LightSource,
        [x, y, z]: [N; 3],
    ) -> Self {
        let origin = places.origin();
        let wide = origin[0];
        let vector = [x.to_f64(), y.to_f64(), z.to_f64()];
        let (direction, end) = match source.place {
            None => {
                let DVec3 { x, y, z } = source.towards;
                let towards = [wide.constant(x), wide.constant(y), wide.constant(z)];
                (towards, wide.constant(f64::INFINITY))
            }
            Some(light) => {
                let way = [
                    wide.constant(light.x) - origin[0],
                    wide.constant(light.y) - origin[1],
                    wide.constant(light.z) - origin[2],
                ];
                ending_at(way, places.normal)
            }
        };
        let cosines =
            [dot(places.normal, direction), dot(vector, direction), dot(places.normal, vector)];
        Self { origin, direction, end, terminator: terminator(cosines) }
    }

    /// Puts the rays of the lanes whose bit is set.
    #[inline(always)]
    pub(super) fn put_rays(&self, lanes: u32, rays: &mut RayLanes) {
        rays.lanes = lanes;
        for axis in 0..3 {
            self.origin[axis].store(&mut rays.origin[axis]);
            self.direction[axis].store(&mut rays.direction[axis]);
        }
        self.end.store(&mut rays.end);
    }
}
