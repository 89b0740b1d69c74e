//! V of each light at a sample, and its openness: rays from its place on the true triangle.

use super::floor::Floor;
use super::openness::OpennessRule;
use super::sequence::{DiscSequence, Scramble};
use glam::DVec3;
use luxel_lighting::{LightKind, Occlusion, PlacedLight, SurfacePoint, terminator};
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_rays::{LIFT, SceneRays, SurfacePlace, TrianglePlaces, WorldRay};
use luxel_visibility::{Frame, PlacedScene, TriangleId};

/// Rays and lights of a frame with shadows or openness.
pub(crate) struct Shadows<'a> {
    pub(crate) rays: &'a SceneRays,
    pub(crate) frame: &'a Frame<'a>,
    pub(crate) placed: &'a PlacedScene<'a>,
    pub(crate) lights: &'a [PlacedLight],
    /// Of each light; none if lights cast no shadows.
    pub(crate) sources: Vec<LightSource>,
    /// The rays to a light with an extent.
    pub(crate) light_rays: u32,
    pub(crate) openness: Option<OpennessRule>,
    /// The ground, which only takes openness away.
    pub(crate) floor: Option<Floor>,
    pub(crate) disc: DiscSequence,
    pub(crate) eye: DVec3,
    /// Towards the eye, if that is the same everywhere.
    pub(crate) towards_eye: Option<DVec3>,
}

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
}

/// A ray from a surface to the middle of a light, and what the surface's own shape lets through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShadowRay {
    pub(crate) ray: WorldRay,
    pub(crate) terminator: f32,
}

/// Samples that a batch sees: their triangles, the lanes that count, and where they are in the window, in
/// pixels.
pub(crate) struct SeenSamples<'s> {
    pub(crate) ids: &'s [u32; LANES],
    pub(crate) lanes: u32,
    pub(crate) position: &'s dyn Fn(usize) -> [f64; 2],
}

/// What keeps light from the samples of a batch, kept from batch to batch.
#[derive(Default)]
pub(crate) struct OcclusionLanes {
    /// V of each light.
    visibility: Vec<[f32; LANES]>,
    openness: Option<[f32; LANES]>,
}

impl OcclusionLanes {
    /// As the lighting equation takes it.
    pub(crate) fn occlusion(&self) -> Occlusion<'_> {
        let visibility = (!self.visibility.is_empty()).then_some(&*self.visibility);
        Occlusion { visibility, openness: self.openness.as_ref() }
    }
}

/// A ray that meets nothing.
const NO_RAY: WorldRay = WorldRay::new(DVec3::ZERO, DVec3::ZERO);

impl Shadows<'_> {
    /// V of each light and the openness at lanes of samples: 1 where N.L <= 0, without a ray.
    /// Points and lines are in no shadow.
    pub(crate) fn occlude<N: Lanes>(
        &self,
        samples: &SeenSamples<'_>,
        barycentric: &[N; 3],
        point: &SurfacePoint<N>,
        found: &mut OcclusionLanes,
    ) {
        let normal = |lane: usize| {
            [point.normal.x, point.normal.y, point.normal.z].map(|side| side.lane(lane))
        };
        let mut places = [None; LANES];
        let mut of_triangle = (TriangleId::NONE, None);
        for lane in lanes_of(samples.lanes) {
            let id = TriangleId(samples.ids[lane]);
            if of_triangle.0 != id {
                of_triangle = (id, self.places(id));
            }
            let weights = barycentric.map(|weight| weight.lane(lane));
            places[lane] = of_triangle.1.map(|places| self.facing(places.at(weights)));
        }
        found.visibility.clear();
        for (number, (source, light)) in (0..).zip(self.sources.iter().zip(self.lights)) {
            let n_dot_l = point.normal.dot(light.to_light(point.position));
            let mut own = [1.0; LANES];
            let mut shadows = [None; LANES];
            for lane in lanes_of(samples.lanes) {
                let Some(place) = places[lane].filter(|_| n_dot_l.lane(lane) > 0.0) else {
                    continue;
                };
                let shadow = ShadowRay::new(&place, source, normal(lane));
                if shadow.terminator > 0.0 {
                    shadows[lane] = Some((place, shadow));
                } else {
                    own[lane] = 0.0;
                }
            }
            self.trace(&shadows, (source, number), samples.position, &mut own);
            found.visibility.push(own);
        }
        found.openness = self.openness.map(|rule| {
            let mut openness = [1.0; LANES];
            for lane in lanes_of(samples.lanes) {
                if let Some(place) = places[lane] {
                    let position = (samples.position)(lane);
                    openness[lane] = self.openness(rule, &place, normal(lane), position);
                }
            }
            openness
        });
    }

    /// V of one light where there are rays to it: those of neighbouring samples together.
    fn trace(
        &self,
        shadows: &[Option<(SurfacePlace, ShadowRay)>; LANES],
        (source, purpose): (&LightSource, u32),
        position: &dyn Fn(usize) -> [f64; 2],
        visibility: &mut [f32; LANES],
    ) {
        let rays_each = self.rays_each(source);
        let mut sums = [0.0; LANES];
        for number in 0..rays_each {
            let mut rays = [NO_RAY; LANES];
            let mut lanes = [0; LANES];
            let mut count = 0;
            for (lane, shadow) in shadows.iter().enumerate() {
                let Some((place, shadow)) = shadow else { continue };
                let scramble = || Scramble::new(position(lane), purpose);
                if let Some(ray) = self.light_ray(source, (place, shadow), number, scramble) {
                    (rays[count], lanes[count]) = (ray, lane);
                    count += 1;
                }
            }
            let mut through = [0.0; LANES];
            self.rays.transmittance_of_few(&rays[..count], &mut through[..count]);
            for (&lane, through) in lanes[..count].iter().zip(through) {
                sums[lane] += through;
            }
        }
        for (lane, shadow) in shadows.iter().enumerate() {
            if let Some((_, shadow)) = shadow {
                visibility[lane] = shadow.terminator * (sums[lane] / rays_each as f32);
            }
        }
    }

    /// The place of a sample on its triangle, on the side that is seen; `None` of points and lines.
    pub(crate) fn place(&self, id: TriangleId, barycentric: [f32; 3]) -> Option<SurfacePlace> {
        Some(self.facing(self.places(id)?.at(barycentric)))
    }

    /// The places of a triangle; `None` of points and lines.
    fn places(&self, id: TriangleId) -> Option<TrianglePlaces> {
        let (object, triangle) = self.placed.object_of(self.frame.triangle(id)?);
        self.rays.places(object, triangle?)
    }

    /// A place on the side that is seen.
    fn facing(&self, place: SurfacePlace) -> SurfacePlace {
        place.facing(self.towards_eye.unwrap_or(self.eye - place.position))
    }

    /// V of the light of this number at a place with the shading normal N, for a sample of the window.
    pub(crate) fn visibility(
        &self,
        light: usize,
        place: &SurfacePlace,
        normal: [f32; 3],
        position: [f64; 2],
    ) -> f32 {
        let Some(source) = self.sources.get(light) else { return 1.0 };
        let shadow = ShadowRay::new(place, source, normal);
        if shadow.terminator <= 0.0 {
            return 0.0;
        }
        let mut shadows = [None; LANES];
        shadows[0] = Some((*place, shadow));
        let mut visibility = [1.0; LANES];
        self.trace(&shadows, (source, light as u32), &|_| position, &mut visibility);
        visibility[0]
    }

    /// The rays to the light of this number from a place with the shading normal N, of a sample of the
    /// window; the terminator's factor.
    pub(crate) fn rays_to(
        &self,
        light: usize,
        place: &SurfacePlace,
        normal: [f32; 3],
        position: [f64; 2],
    ) -> Option<(Vec<Option<WorldRay>>, f32)> {
        let source = self.sources.get(light)?;
        let shadow = ShadowRay::new(place, source, normal);
        let scramble = || Scramble::new(position, light as u32);
        let ray = |number| self.light_ray(source, (place, &shadow), number, scramble);
        Some(((0..self.rays_each(source)).map(ray).collect(), shadow.terminator))
    }

    /// The rays from a sample to a light.
    fn rays_each(&self, source: &LightSource) -> u32 {
        if source.radius > 0.0 { self.light_rays } else { 1 }
    }

    /// The ray of this number from a place to a light; `None` if it would go below the triangle.
    fn light_ray(
        &self,
        source: &LightSource,
        (place, shadow): (&SurfacePlace, &ShadowRay),
        number: u32,
        scramble: impl Fn() -> Scramble,
    ) -> Option<WorldRay> {
        if source.radius <= 0.0 {
            return Some(shadow.ray);
        }
        let on_disc = self.disc.place(number, scramble());
        source.ray_to(place, shadow.ray.direction, on_disc)
    }
}

impl LightSource {
    /// The ray from a place to a place on the disc that faces it; `None` if that lies behind the triangle.
    fn ray_to(&self, place: &SurfacePlace, axis: DVec3, [u, v]: [f64; 2]) -> Option<WorldRay> {
        let (tangent, bitangent) = axis.any_orthonormal_pair();
        let aside = (tangent * u + bitangent * v) * self.radius;
        let origin = place.origin();
        let (direction, end) = match self.place {
            None => ((axis + aside).normalize(), f64::INFINITY),
            Some(light) => ending_at(light + aside - origin, place),
        };
        let range = [0.0, end];
        (place.normal.dot(direction) > 0.0).then_some(WorldRay { origin, direction, range })
    }
}

/// The direction of a way, and its length but for [`LIFT`] of it, so that a surface on which the light
/// itself lies doesn't keep it away.
fn ending_at(way: DVec3, place: &SurfacePlace) -> (DVec3, f64) {
    let length = way.length();
    let direction = if length > 0.0 { way / length } else { place.normal };
    (direction, length * (1.0 - LIFT))
}

impl ShadowRay {
    /// From a place with the shading normal N to the middle of a light.
    fn new(place: &SurfacePlace, source: &LightSource, [x, y, z]: [f32; 3]) -> Self {
        let origin = place.origin();
        let (direction, end) = match source.place {
            None => (source.towards, f64::INFINITY),
            Some(light) => ending_at(light - origin, place),
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
