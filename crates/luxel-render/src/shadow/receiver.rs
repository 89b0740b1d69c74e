//! V of each light at a sample, and its openness: rays from its place on the true triangle.

use super::floor::Floor;
use super::openness::OpennessRule;
use super::place_cache::PlaceCache;
use super::sequence::{DiscSequence, Scramble};
use super::shadow_ray::{LightSource, RayStart, ShadowLanes};
use glam::DVec3;
use luxel_lighting::{Occlusion, PlacedLight, SurfacePoint};
use luxel_math::prelude::*;
use luxel_math::{LANES, Vec3};
use luxel_rays::{PlaceLanes, RayLanes, SceneRays, Spread, SurfacePlace, TrianglePlaces, WorldRay};
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

/// Where the sample of a lane is in the window, in pixels.
pub(crate) type WindowPosition<'a> = dyn Fn(usize) -> [f64; 2] + 'a;

/// From a lane's place to the curved surface that its triangle stands for.
pub(crate) type TerminatorOffset<'a> = dyn Fn(usize, &SurfacePlace) -> DVec3 + 'a;

/// Samples that a batch sees: their triangles, the lanes that count, and where they are in the window, in
/// pixels.
pub(crate) struct SeenSamples<'s> {
    pub(crate) ids: &'s [u32; LANES],
    pub(crate) lanes: u32,
    pub(crate) position: &'s WindowPosition<'s>,
}

/// The surface that one sample sees.
#[derive(Clone, Copy)]
pub(crate) struct Receiver {
    /// Its triangle; of the ground, none.
    pub(crate) id: TriangleId,
    pub(crate) barycentric: [f32; 3],
    /// The shading normal N.
    pub(crate) normal: [f32; 3],
    /// N without the normal map.
    pub(crate) smooth: [f32; 3],
    /// Where the sample is in the window, in pixels.
    pub(crate) position: [f64; 2],
    /// Whether light is interpolated between other places, and so may arrive where N.L <= 0.
    pub(crate) is_between: bool,
}

/// What keeps light from the samples of a batch, kept from batch to batch.
#[derive(Default)]
pub(crate) struct OcclusionLanes {
    /// V of each light.
    visibility: Vec<[f32; LANES]>,
    openness: Option<[f32; LANES]>,
    cache: PlaceCache,
    batch: RayBatch,
}

/// Rays that are traced together, and what comes along them.
#[derive(Default)]
pub(super) struct RayBatch {
    pub(super) rays: Vec<RayLanes>,
    pub(super) through: Vec<[f32; LANES]>,
}

/// How many rays of each sample are traced together.
pub(super) const TOGETHER: u32 = 16;

impl OcclusionLanes {
    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.cache.begin_frame();
    }

    /// The openness of the first lane.
    pub(crate) fn openness(&self) -> f32 {
        self.openness.map_or(1.0, |[first, ..]| first)
    }

    /// As the lighting equation takes it.
    pub(crate) fn occlusion(&self) -> Occlusion<'_> {
        let visibility = (!self.visibility.is_empty()).then_some(&*self.visibility);
        Occlusion { visibility, openness: self.openness.as_ref() }
    }
}

impl RayBatch {
    /// Traces the rays.
    pub(super) fn trace(&mut self, scene: &SceneRays, spread: Spread) {
        self.through.resize(self.rays.len(), [1.0; LANES]);
        scene.transmittance_of_lanes(&self.rays, spread, &mut self.through);
    }

    /// The sums and what comes along the rays of each lane.
    #[inline(always)]
    pub(super) fn added_to<N: Lanes>(&self, mut sums: N) -> N {
        for (rays, through) in self.rays.iter().zip(&self.through) {
            sums = sums + sums.load(through, 0).masked(sums.mask_of(rays.lanes));
        }
        sums
    }
}

impl Shadows<'_> {
    /// Shares the rays of a pixel out among its samples, of which each has its own.
    pub(crate) fn share_rays(&mut self, samples: usize) {
        let each = |rays: u32| rays.div_ceil(samples as u32);
        self.light_rays = each(self.light_rays);
        self.openness = self.openness.map(|rule| OpennessRule { rays: each(rule.rays), ..rule });
    }

    /// V of each light and the openness at lanes of samples: 1 where N.L <= 0, without a ray.
    /// Points and lines are in no shadow.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn occlude<N: Lanes>(
        &self,
        samples: &SeenSamples<'_>,
        barycentric: &[N; 3],
        (point, smooth): (&SurfacePoint<N>, Vec3<N>),
        found: &mut OcclusionLanes,
    ) {
        let simd = barycentric[0];
        simd.vectorized(
            #[inline(always)]
            || {
                let asked = match self.openness {
                    Some(_) => samples.lanes,
                    None => self.lit_by_any(point) & samples.lanes,
                };
                if asked == 0 {
                    found.visibility.clear();
                    found.visibility.resize(self.sources.len(), [1.0; LANES]);
                    found.openness = None;
                    return;
                }
                let make = |id, places: &mut TrianglePlaces| self.places_into(id, places);
                let (of, placed) = found.cache.of_lanes(simd, samples.ids, asked, make);
                let places = TrianglePlaces::at_lanes(&of, barycentric, placed);
                let places = self.facing(&places);
                let offset = |lane: usize, place: &SurfacePlace| {
                    let weight = |side: usize| barycentric[side].lane(lane);
                    let weights = [weight(0), weight(1), weight(2)];
                    self.offset(TriangleId(samples.ids[lane]), weights, place)
                };
                let SeenSamples { position, .. } = samples;
                let seen = (point, smooth);
                self.occlude_places(&places, seen, [placed; 2], (position, &offset), found);
            },
        );
    }

    /// The same at places: V in the lanes of the first mask, openness in those of the second.
    ///
    /// Outlined: one copy per lane type, for surfaces and the ground.
    #[inline(never)]
    pub(crate) fn occlude_places<N: Lanes>(
        &self,
        places: &PlaceLanes<N::F64>,
        (point, smooth): (&SurfacePoint<N>, Vec3<N>),
        [placed, near]: [u32; 2],
        (position, offset): (&WindowPosition<'_>, &TerminatorOffset<'_>),
        found: &mut OcclusionLanes,
    ) {
        point.depth.vectorized(
            #[inline(always)]
            || {
                let OcclusionLanes { visibility, openness, batch, .. } = found;
                let normal = [point.normal.x, point.normal.y, point.normal.z];
                let normals = [normal, [smooth.x, smooth.y, smooth.z]];
                visibility.clear();
                for (number, (source, light)) in (0..).zip(self.sources.iter().zip(self.lights)) {
                    let lit = lit(light, point) & placed;
                    let mut own = [1.0; LANES];
                    if lit != 0 {
                        let at = (places, normals, lit);
                        let of = (source, number);
                        self.trace(at, of, (position, offset), batch, &mut own);
                    }
                    visibility.push(own);
                }
                *openness = self.openness.map(|rule| {
                    let mut own = [1.0; LANES];
                    if near != 0 {
                        self.open(rule, (places, normal, near), position, batch, &mut own);
                    }
                    own
                });
            },
        );
    }

    /// The lanes that any light with shadows lights.
    #[inline(always)]
    fn lit_by_any<N: Lanes>(&self, point: &SurfacePoint<N>) -> u32 {
        let mut any = 0;
        for light in &self.lights[..self.sources.len()] {
            any |= lit(light, point);
        }
        any
    }

    /// V of one light at the places whose bit is set, with the shading normals N and the smooth ones.
    #[inline(always)]
    fn trace<N: Lanes>(
        &self,
        (places, normals, lit): (&PlaceLanes<N::F64>, [[N; 3]; 2], u32),
        (source, purpose): (&LightSource, u32),
        (position, offset): (&WindowPosition<'_>, &TerminatorOffset<'_>),
        batch: &mut RayBatch,
        visibility: &mut [f32; LANES],
    ) {
        let shadow = ShadowLanes::new(places, source, normals);
        let smooth = normals[1];
        let terminator = shadow.terminator;
        let reached = terminator.zero().less(terminator).bits() & lit;
        let mut sums = terminator.zero();
        let rays_each = self.rays_each(source);
        if source.is_point() {
            batch.rays.resize(1, RayLanes::NONE);
            shadow.put_rays(reached, &mut batch.rays[0]);
            let raised = shadow.raised & reached;
            if raised != 0 {
                places.each(
                    raised,
                    #[inline(always)]
                    |lane, place| {
                        let smooth = lane_of(smooth, lane);
                        let offset = &|| offset(lane, &place);
                        let start = RayStart { place: &place, smooth, offset };
                        let axis = batch.rays[0].ray(lane).direction;
                        batch.rays[0].put(lane, &source.ray_to(&start, axis, [0.0; 2]));
                    },
                );
            }
            batch.trace(self.rays, Spread::Narrow);
            sums = batch.added_to(sums);
        } else {
            for first in (0..rays_each).step_by(TOGETHER as usize) {
                let numbers = first..rays_each.min(first + TOGETHER);
                batch.rays.clear();
                batch.rays.resize(numbers.len(), RayLanes::NONE);
                let mut middle = RayLanes::NONE;
                shadow.put_rays(reached, &mut middle);
                places.each(
                    reached,
                    #[inline(always)]
                    |lane, place| {
                        let scramble = Scramble::new(position(lane), purpose);
                        let axis = middle.ray(lane).direction;
                        let smooth = lane_of(smooth, lane);
                        let offset = &|| offset(lane, &place);
                        let start = RayStart { place: &place, smooth, offset };
                        for (rays, number) in batch.rays.iter_mut().zip(numbers.clone()) {
                            let on_disc = self.disc.place(number, scramble);
                            rays.put(lane, &source.ray_to(&start, axis, on_disc));
                        }
                    },
                );
                batch.trace(self.rays, Spread::Narrow);
                sums = batch.added_to(sums);
            }
        }
        let own = terminator * (sums / sums.constant(rays_each as f32));
        let own = own.masked(sums.mask_of(reached));
        own.select(sums.mask_of(lit), sums.one()).store(visibility, 0);
    }

    /// The place of a sample on its triangle, on the side that is seen; `None` of points and lines.
    pub(crate) fn place(&self, id: TriangleId, barycentric: [f32; 3]) -> Option<SurfacePlace> {
        let mut places = TrianglePlaces::default();
        let place = self.places_into(id, &mut places).then(|| places.at(barycentric))?;
        Some(self.facing(&PlaceLanes::from(&place)).place())
    }

    /// Writes the places of a triangle; returns whether there are any: points and lines have none.
    fn places_into(&self, id: TriangleId, places: &mut TrianglePlaces) -> bool {
        let of = self.frame.triangle(id).map(|of| self.placed.object_of(of));
        let Some((object, Some(triangle))) = of else { return false };
        self.rays.places_into(object, triangle, places)
    }

    /// Places on the side that is seen.
    #[inline(always)]
    fn facing<F: F64Lanes>(&self, places: &PlaceLanes<F>) -> PlaceLanes<F> {
        let [x, y, z] = places.position;
        let far = self
            .towards_eye
            .map(|DVec3 { x: a, y: b, z: c }| [x.constant(a), x.constant(b), x.constant(c)]);
        let DVec3 { x: a, y: b, z: c } = self.eye;
        places.facing(far.unwrap_or([x.constant(a) - x, x.constant(b) - y, x.constant(c) - z]))
    }

    /// From a place on a triangle to the curved surface that it stands for.
    fn offset(&self, id: TriangleId, barycentric: [f32; 3], place: &SurfacePlace) -> DVec3 {
        let of = self.frame.triangle(id).map(|of| self.placed.object_of(of));
        let Some((object, Some(triangle))) = of else { return DVec3::ZERO };
        self.rays.terminator_offset((object, triangle), barycentric, place)
    }

    /// The light of this number, as a receiver sees it.
    fn source(&self, light: usize, place: &SurfacePlace, of: &Receiver) -> Option<LightSource> {
        let source = *self.sources.get(light)?;
        let at_horizon = || source.at_horizon(place.origin(), wide(of.smooth));
        Some(if of.is_between { at_horizon() } else { source })
    }

    /// V of the light of this number at a receiver's place.
    pub(crate) fn visibility(&self, light: usize, place: &SurfacePlace, of: &Receiver) -> f32 {
        let Some(source) = self.source(light, place, of) else { return 1.0 };
        let (mut visibility, mut batch) = ([1.0; LANES], RayBatch::default());
        let at = (&place.into(), [of.normal, of.smooth], 1);
        let offset = |_, place: &SurfacePlace| self.offset(of.id, of.barycentric, place);
        let from: (&WindowPosition<'_>, &TerminatorOffset<'_>) = (&|_| of.position, &offset);
        self.trace(at, (&source, light as u32), from, &mut batch, &mut visibility);
        visibility[0]
    }

    /// The rays to the light of this number from a receiver's place, and the terminator's factor.
    pub(crate) fn rays_to(
        &self,
        light: usize,
        place: &SurfacePlace,
        of: &Receiver,
    ) -> Option<(Vec<WorldRay>, f32)> {
        let source = self.source(light, place, of)?;
        let normals = [of.normal, of.smooth];
        let shadow = ShadowLanes::<f32>::new(&place.into(), &source, normals);
        let mut middle = RayLanes::NONE;
        shadow.put_rays(1, &mut middle);
        let middle = middle.ray(0);
        let scramble = Scramble::new(of.position, light as u32);
        let offset = &|| self.offset(of.id, of.barycentric, place);
        let start = RayStart { place, smooth: wide(of.smooth), offset };
        let ray = |number| match source.is_point() {
            true if shadow.raised == 0 => middle,
            true => source.ray_to(&start, middle.direction, [0.0; 2]),
            false => source.ray_to(&start, middle.direction, self.disc.place(number, scramble)),
        };
        Some(((0..self.rays_each(&source)).map(ray).collect(), shadow.terminator))
    }

    /// The rays from a sample to a light.
    fn rays_each(&self, source: &LightSource) -> u32 {
        if source.is_point() { 1 } else { self.light_rays }
    }
}

/// The lanes where N.L > 0.
#[inline(always)]
fn lit<N: Lanes>(light: &PlacedLight, point: &SurfacePoint<N>) -> u32 {
    let n_dot_l = point.normal.dot(light.to_light(point.position));
    n_dot_l.zero().less(n_dot_l).bits()
}

/// The vector of a lane.
#[inline(always)]
fn lane_of<N: Lanes>([x, y, z]: [N; 3], lane: usize) -> DVec3 {
    wide([x.lane(lane), y.lane(lane), z.lane(lane)])
}

fn wide(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}
