//! V of each light at a sample: rays from its place on the true triangle.

use glam::DVec3;
use luxel_lighting::{PlacedLight, SurfacePoint, terminator};
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_rays::{LIFT, SceneRays, SurfacePlace, WorldRay};
use luxel_visibility::{Frame, PlacedScene, TriangleId};

/// Rays and lights of a frame with shadows.
pub(crate) struct Shadows<'a> {
    pub(crate) rays: &'a SceneRays,
    pub(crate) frame: &'a Frame<'a>,
    pub(crate) placed: &'a PlacedScene<'a>,
    pub(crate) lights: &'a [PlacedLight],
    /// Of each light.
    pub(crate) sources: Vec<LightSource>,
    pub(crate) eye: DVec3,
    /// Towards the eye, if that is the same everywhere.
    pub(crate) towards_eye: Option<DVec3>,
}

/// Where a light's rays end, in world space.
#[derive(Clone, Copy, Debug)]
pub(crate) enum LightSource {
    /// Far away in this direction, of unit length.
    Towards(DVec3),
    /// At this place.
    At(DVec3),
}

impl LightSource {
    /// A light about the eye.
    pub(crate) fn new(light: &PlacedLight, eye: DVec3) -> Self {
        let vector = |[x, y, z]: [f32; 3]| DVec3::new(x.into(), y.into(), z.into());
        if light.light().kind.has_place() {
            Self::At(eye + vector(light.position()))
        } else {
            Self::Towards(-vector(light.direction()))
        }
    }
}

/// A ray from a surface to a light, and what the surface's own shape lets through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShadowRay {
    pub(crate) ray: WorldRay,
    pub(crate) terminator: f32,
}

impl Shadows<'_> {
    /// V of each light at the lanes of samples, in `of_lights`: 1 where N.L <= 0, of which nothing is
    /// asked. Points and lines receive no shadow.
    pub(crate) fn visibility<N: Lanes>(
        &self,
        (ids, lanes): (&[u32; LANES], u32),
        barycentric: &[N; 3],
        point: &SurfacePoint<N>,
        of_lights: &mut Vec<[f32; LANES]>,
    ) {
        let normal = point.normal;
        of_lights.clear();
        of_lights.extend(self.lights.iter().map(|light| {
            let n_dot_l = normal.dot(light.to_light(point.position));
            std::array::from_fn(|lane| n_dot_l.lane(lane))
        }));
        for lane in lanes_of(lanes) {
            let weights = barycentric.map(|weight| weight.lane(lane));
            let place = self.place(TriangleId(ids[lane]), weights);
            for (source, own) in self.sources.iter().zip(&mut *of_lights) {
                let n_dot_l = own[lane];
                own[lane] = match place.filter(|_| n_dot_l > 0.0) {
                    Some(place) => {
                        let normal = [normal.x, normal.y, normal.z].map(|side| side.lane(lane));
                        let shadow = ShadowRay::new(&place, *source, normal);
                        shadow.terminator * self.transmittance(&shadow)
                    }
                    None => 1.0,
                };
            }
        }
    }

    /// The place of a sample on its triangle, on the side that is seen; `None` of points and lines.
    pub(crate) fn place(&self, id: TriangleId, barycentric: [f32; 3]) -> Option<SurfacePlace> {
        let (object, triangle) = self.placed.object_of(self.frame.triangle(id)?);
        let place = self.rays.place(object, triangle?, barycentric)?;
        Some(place.facing(self.towards_eye.unwrap_or(self.eye - place.position)))
    }

    /// The ray from a place with the shading normal N to the light of this number.
    pub(crate) fn ray(
        &self,
        light: usize,
        place: &SurfacePlace,
        normal: [f32; 3],
    ) -> Option<ShadowRay> {
        Some(ShadowRay::new(place, *self.sources.get(light)?, normal))
    }

    /// T along a ray; 0 where the surface's own shape keeps all of the light.
    pub(crate) fn transmittance(&self, shadow: &ShadowRay) -> f32 {
        if shadow.terminator > 0.0 { self.rays.transmittance(&shadow.ray) } else { 0.0 }
    }
}

impl ShadowRay {
    /// From a place with the shading normal N to a light. It ends [`LIFT`] of the way before a light that
    /// has a place, so that a surface on which the light itself lies doesn't keep it away.
    fn new(place: &SurfacePlace, source: LightSource, [x, y, z]: [f32; 3]) -> Self {
        let origin = place.origin();
        let (direction, end) = match source {
            LightSource::Towards(direction) => (direction, f64::INFINITY),
            LightSource::At(light) => {
                let way = light - origin;
                let length = way.length();
                let direction = if length > 0.0 { way / length } else { place.normal };
                (direction, length * (1.0 - LIFT))
            }
        };
        let normal = DVec3::new(x.into(), y.into(), z.into());
        let cosines =
            [place.normal.dot(direction), normal.dot(direction), place.normal.dot(normal)];
        Self {
            ray: WorldRay { origin, direction, range: [0.0, end] },
            terminator: terminator(cosines),
        }
    }
}
