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

/// Rays from surfaces to the middle of a light, and what normal maps let through, lane by lane.
pub(super) struct ShadowLanes<N: Lanes> {
    origin: [N::F64; 3],
    direction: [N::F64; 3],
    end: N::F64,
    pub(super) terminator: N,
    /// The lanes whose rays leave from above their triangle: see [`LightSource::ray_to`].
    pub(super) raised: u32,
}

/// Where rays leave: a place on a triangle, the smooth normal there, of unit length, and the way to the
/// curved surface that the triangle stands for.
pub(super) struct RayStart<'s> {
    pub(super) place: &'s SurfacePlace,
    pub(super) smooth: DVec3,
    pub(super) offset: &'s dyn Fn() -> DVec3,
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

    /// The ray from a place to a place on the disc that faces it, at (u, v) of the unit disc.
    ///
    /// Where the triangle turns away from the light earlier than its smooth normal N_s, it would shadow
    /// itself, and light would end at edges of triangles: a coarse ball would have a jagged terminator.
    /// There, the ray leaves from the curved surface that the triangle stands for, so far above it as
    ///
    /// ```text
    /// w = clamp(1 - 2 (N_g.L) / (N_s.L), 0, 1)
    /// ```
    ///
    /// says: all the way where N_g.L <= 0, not at all where N_g.L is half of N_s.L or more.
    pub(super) fn ray_to(&self, start: &RayStart<'_>, axis: DVec3, [u, v]: [f64; 2]) -> WorldRay {
        let (tangent, bitangent) = axis.any_orthonormal_pair();
        let aside = (tangent * u + bitangent * v) * self.radius;
        let RayStart { place, smooth, offset } = start;
        let from = |origin: DVec3| {
            let (direction, end) = match self.place {
                None => ((axis + aside).normalize(), f64::INFINITY),
                Some(light) => {
                    let way = (light + aside - origin).to_array();
                    let (direction, end) = ending_at(way, place.normal.to_array());
                    (DVec3::from_array(direction), end)
                }
            };
            WorldRay { origin, direction, range: [0.0, end] }
        };
        let ray = from(place.origin());
        let (faces, lit) = (place.normal.dot(ray.direction), smooth.dot(ray.direction).max(0.0));
        if lit - 2.0 * faces <= 0.0 {
            return ray;
        }
        let weight = if faces > 0.0 { 1.0 - 2.0 * faces / lit } else { 1.0 };
        from(ray.origin + offset() * weight)
    }

    /// The light at the horizon of a place with the smooth normal N_s, if it lies below: light that is
    /// interpolated between corners reaches beyond it.
    pub(super) fn at_horizon(&self, origin: DVec3, smooth: DVec3) -> Self {
        let raised = |way: DVec3| way - smooth * smooth.dot(way).min(0.0);
        Self {
            place: self.place.map(|light| origin + raised(light - origin)),
            towards: raised(self.towards).try_normalize().unwrap_or(smooth),
            radius: self.radius,
        }
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

/// Vectors in `f64`.
#[inline(always)]
fn wider<N: Lanes>([x, y, z]: [N; 3]) -> [N::F64; 3] {
    [x.to_f64(), y.to_f64(), z.to_f64()]
}

/// The product of two vectors, lane by lane.
#[inline(always)]
pub(super) fn dot<F: F64Lanes>([x, y, z]: [F; 3], [a, b, c]: [F; 3]) -> F {
    x * a + y * b + z * c
}

impl<N: Lanes> ShadowLanes<N> {
    /// From places with the shading normals N and the smooth ones N_s, which are the same unless there is a
    /// normal map, to the middle of a light.
    #[inline(always)]
    pub(super) fn new(
        places: &PlaceLanes<N::F64>,
        source: &LightSource,
        [shading, smooth]: [[N; 3]; 2],
        is_mapped: bool,
    ) -> Self {
        let origin = places.origin();
        let (wide, one) = (origin[0], shading[0].one());
        let smooth = wider(smooth);
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
        let lit = dot(smooth, direction);
        // It is 1 wherever both normals are the same.
        let terminator = if is_mapped {
            let shading = wider(shading);
            terminator([lit, dot(shading, direction), dot(smooth, shading)])
        } else {
            one
        };
        let lit = lit.if_positive(lit, wide.constant(0.0));
        let faces = dot(places.normal, direction);
        let raised = (lit - (faces + faces)).is_positive().bits();
        Self { origin, direction, end, terminator, raised }
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
