//! V of each light and openness at the samples of batches. Shadow rays to a light without extent are traced for
//! several batches at once.

use super::occlusion::{
    BATCHES, BatchOcclusion, LightLanes, OcclusionLanes, PendingRays, RayBatch, TOGETHER,
};
use super::sequence::Scramble;
use super::shadow_ray::{LightSource, RayStart, ShadowLanes};
use super::shadows::{Receiver, Shadows, wide};
use glam::DVec3;
use luxel_lighting::{PlacedLight, SurfacePoint};
use luxel_math::prelude::*;
use luxel_math::{LANES, Vec3, lanes_of};
use luxel_rays::{PlaceLanes, RayLanes, Spread, SurfacePlace, TrianglePlaces};
use luxel_visibility::TriangleId;
use std::ops::Range;

/// Where the sample of a lane is in the window, in pixels.
pub(crate) type WindowPosition<'a> = dyn Fn(usize) -> [f64; 2] + 'a;

/// Samples that a batch sees: their triangles, the lanes that count, where they are in the window, in pixels,
/// their barycentrics, their surfaces with the normals without a normal map, and whether these may differ.
pub(crate) struct SeenSamples<'s, N> {
    pub(crate) ids: &'s [u32; LANES],
    pub(crate) lanes: u32,
    pub(crate) position: &'s WindowPosition<'s>,
    pub(crate) barycentric: &'s [N; 3],
    pub(crate) point: &'s SurfacePoint<N>,
    pub(crate) smooth: Vec3<N>,
    pub(crate) is_mapped: bool,
}

/// Triangles and barycentrics.
type Curved<'s, N> = (&'s [u32; LANES], &'s [N; 3]);

/// Places that light may reach, lane by lane.
pub(crate) struct Receivers<'s, N: Lanes> {
    pub(crate) places: PlaceLanes<N::F64>,
    pub(crate) point: &'s SurfacePoint<N>,
    /// The normals without a normal map.
    pub(crate) smooth: Vec3<N>,
    /// Whether they may differ from the point's own.
    pub(crate) is_mapped: bool,
    /// The lanes that lights may reach.
    pub(crate) placed: u32,
    /// The lanes whose openness counts.
    pub(crate) near: u32,
    /// Where they are in the window.
    pub(crate) position: &'s WindowPosition<'s>,
    /// The triangles and barycentrics of places that stand for a curved surface.
    pub(crate) curved: Option<Curved<'s, N>>,
}

impl<N: Lanes> Receivers<'_, N> {
    /// The shading normals N and the smooth ones.
    #[inline(always)]
    fn normals(&self) -> [[N; 3]; 2] {
        let Self { point: SurfacePoint { normal, .. }, smooth, .. } = self;
        [[normal.x, normal.y, normal.z], [smooth.x, smooth.y, smooth.z]]
    }

    /// The smooth normal of a lane.
    #[inline(always)]
    fn smooth_of(&self, lane: usize) -> DVec3 {
        let Vec3 { x, y, z } = self.smooth;
        wide([x.lane(lane), y.lane(lane), z.lane(lane)])
    }
}

impl Shadows<'_> {
    /// Casts the shadow rays and the rays of openness of batch `number` out of `count`. Shadow rays to lights
    /// without extent stay pending until [`Self::trace_pending`]. V is 1, without a ray, where N.L <= 0 and on points
    /// and lines.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn cast<N: Lanes>(
        &self,
        samples: &SeenSamples<'_, N>,
        (number, count): (usize, usize),
        found: &mut OcclusionLanes,
    ) {
        let of = (number, count);
        if !N::IS_SPECIALIZED {
            let make = |id, places: &mut TrianglePlaces| self.places_into(id, places);
            let mut places = [None; LANES];
            for lane in lanes_of(self.lanes_with_rays(samples)) {
                let weights = samples.barycentric.map(|weight| weight.lane(lane));
                let triangle = found.cache.of_one(samples.ids[lane], make);
                places[lane] = triangle.map(|triangle| self.seen_side(triangle.at(weights)));
            }
            let seen = (samples.point, samples.smooth, [samples.lanes; 2]);
            let curved = Some((samples.ids, samples.barycentric));
            self.cast_one_by_one(seen, &places, (samples.position, curved), of, found);
            return;
        }
        let simd = samples.smooth.x;
        simd.vectorized(
            #[inline(always)]
            || {
                let SeenSamples { ids, position, barycentric, point, smooth, is_mapped, .. } =
                    *samples;
                let lanes = self.lanes_with_rays(samples);
                if lanes == 0 {
                    found.reset(of, self.sources.len());
                    return;
                }
                let make = |id, places: &mut TrianglePlaces| self.places_into(id, places);
                let simd = simd.zero();
                let (triangles, placed) = found.cache.of_lanes(simd, ids, lanes, make);
                let places = TrianglePlaces::at_lanes(&triangles, barycentric, placed);
                let places = self.facing(&places);
                let curved = Some((ids, barycentric));
                let near = placed;
                let receivers =
                    Receivers { places, point, smooth, is_mapped, placed, near, position, curved };
                self.cast_from(&receivers, of, found);
            },
        );
    }

    /// [`Self::cast`] at places.
    ///
    /// Outlined: one copy per lane type, for surfaces and the ground.
    #[inline(never)]
    pub(crate) fn cast_from<N: Lanes>(
        &self,
        receivers: &Receivers<'_, N>,
        of: (usize, usize),
        found: &mut OcclusionLanes,
    ) {
        if !N::IS_SPECIALIZED {
            let mut places = [None; LANES];
            let lanes = [receivers.placed, receivers.near];
            let all = lanes[0] | lanes[1];
            receivers.places.each(all, |lane, place| places[lane] = Some(place));
            let seen = (receivers.point, receivers.smooth, lanes);
            let at = (receivers.position, receivers.curved);
            self.cast_one_by_one(seen, &places, at, of, found);
            return;
        }
        receivers.smooth.x.vectorized(
            #[inline(always)]
            || self.cast_to_lights(receivers, of, found),
        );
    }

    /// The same without vector kernels, lane by lane: V in the lanes of the first mask, openness in those of the
    /// second.
    fn cast_one_by_one<N: Lanes>(
        &self,
        (point, smooth, [lights, near]): (&SurfacePoint<N>, Vec3<N>, [u32; 2]),
        places: &[Option<SurfacePlace>; LANES],
        (position, curved): (&WindowPosition<'_>, Option<Curved<'_, N>>),
        (number, count): (usize, usize),
        found: &mut OcclusionLanes,
    ) {
        found.reset((number, count), self.sources.len());
        let BatchOcclusion { visibility, openness } = &mut found.of[number % BATCHES];
        if self.openness.is_some() {
            *openness = Some([1.0; LANES]);
        }
        let lit: Vec<u32> = self.lights[..self.sources.len()]
            .iter()
            .map(|light| lit(light, point) & lights)
            .collect();
        let any =
            lit.iter().fold(if self.openness.is_some() { near } else { 0 }, |any, of| any | of);
        for lane in lanes_of(any) {
            let Some(place) = &places[lane] else { continue };
            let (id, barycentric) = match curved {
                Some((ids, weights)) => {
                    (TriangleId(ids[lane]), weights.map(|weight| weight.lane(lane)))
                }
                None => (TriangleId::NONE, [0.0; 3]),
            };
            let of_lane = |Vec3 { x, y, z }: Vec3<N>| [x.lane(lane), y.lane(lane), z.lane(lane)];
            let (normal, smooth) = (of_lane(point.normal), of_lane(smooth));
            let position = position(lane);
            let receiver =
                Receiver { id, barycentric, normal, smooth, position, is_between: false };
            for light in (0..lit.len()).filter(|light| lit[*light] >> lane & 1 == 1) {
                visibility[light][lane] = self.visibility(light, place, &receiver);
            }
            if let (Some(rule), Some(openness)) = (self.openness, openness.as_mut())
                && near >> lane & 1 == 1
            {
                openness[lane] = self.openness(rule, place, normal, position);
            }
        }
    }

    /// Puts the rays to lights without extent among the pending ones; traces those to lights with an extent, and
    /// those of openness.
    #[inline(always)]
    fn cast_to_lights<N: Lanes>(
        &self,
        receivers: &Receivers<'_, N>,
        (number, count): (usize, usize),
        found: &mut OcclusionLanes,
    ) {
        found.reset((number, count), self.sources.len());
        let OcclusionLanes { of, batch, pending, .. } = found;
        let BatchOcclusion { visibility, openness } = &mut of[number % BATCHES];
        for (light, source) in self.sources.iter().enumerate() {
            let lit = lit(&self.lights[light], receivers.point) & receivers.placed;
            let at = light * count + number;
            if lit == 0 {
                continue;
            }
            if source.is_point() {
                let lanes = &mut pending.lights[at];
                lanes.lit = lit;
                self.rays_to_point(receivers, source, &mut pending.rays[at], lanes);
            } else {
                let source = (source, light as u32);
                self.soft(receivers, source, lit, batch, &mut visibility[light]);
            }
        }
        if let Some(rule) = self.openness {
            let normal = receivers.point.normal;
            let at = (&receivers.places, [normal.x, normal.y, normal.z], receivers.near);
            let own = openness.insert([1.0; LANES]);
            if receivers.near != 0 {
                self.open(rule, at, receivers.position, batch, own);
            }
        }
    }

    /// Traces the pending shadow rays of `count` batches, a light at a time, and stores V.
    #[inline(always)]
    pub(crate) fn trace_pending<N: Lanes>(
        &self,
        simd: N,
        count: usize,
        found: &mut OcclusionLanes,
    ) {
        if !N::IS_SPECIALIZED {
            return;
        }
        let OcclusionLanes { of, pending: PendingRays { rays, lights, through }, .. } = found;
        for light in 0..self.sources.len() {
            let all = light * count..(light + 1) * count;
            let lights = &lights[all.clone()];
            if lights.iter().all(|lanes| lanes.lit == 0) {
                continue;
            }
            let through = &mut through[..count.min(BATCHES)];
            self.rays.transmittance_of_lanes(&rays[all], Spread::Narrow, through);
            for ((lanes, through), of) in lights.iter().zip(through).zip(of.iter_mut()) {
                if lanes.lit != 0 {
                    let through = simd.load(through, 0) * simd.load(&lanes.terminator, 0);
                    let reached = through.masked(simd.mask_of(lanes.reached));
                    let own = reached.select(simd.mask_of(lanes.lit), simd.one());
                    own.store(&mut of.visibility[light], 0);
                }
            }
        }
    }

    /// The lanes of samples from which rays leave: with openness all, else those that any light with shadows lights.
    #[inline(always)]
    fn lanes_with_rays<N: Lanes>(&self, samples: &SeenSamples<'_, N>) -> u32 {
        let mut any = 0;
        for light in &self.lights[..self.sources.len()] {
            any |= lit(light, samples.point);
        }
        if self.openness.is_some() { samples.lanes } else { any & samples.lanes }
    }

    /// The rays to a light without extent, one from each lane that it lights.
    #[inline(always)]
    pub(super) fn rays_to_point<N: Lanes>(
        &self,
        receivers: &Receivers<'_, N>,
        source: &LightSource,
        rays: &mut RayLanes,
        lanes: &mut LightLanes,
    ) {
        let shadow =
            ShadowLanes::new(&receivers.places, source, receivers.normals(), receivers.is_mapped);
        let terminator = shadow.terminator;
        terminator.store(&mut lanes.terminator, 0);
        lanes.reached = terminator.zero().less(terminator).bits() & lanes.lit;
        shadow.put_rays(lanes.reached, rays);
        let raised = shadow.raised & lanes.reached;
        if raised != 0 {
            receivers.places.each(
                raised,
                #[inline(always)]
                |lane, place| {
                    let smooth = receivers.smooth_of(lane);
                    let offset = &|| self.offset_of(receivers, lane, &place);
                    let start = RayStart { place: &place, smooth, offset };
                    let axis = rays.ray(lane).direction;
                    rays.put(lane, &source.ray_to(&start, axis, [0.0; 2]));
                },
            );
        }
    }

    /// V of a light with an extent at the places whose bit is set.
    ///
    /// Outlined: the code around it is that of lights without.
    #[inline(never)]
    pub(super) fn soft<N: Lanes>(
        &self,
        receivers: &Receivers<'_, N>,
        (source, purpose): (&LightSource, u32),
        lit: u32,
        batch: &mut RayBatch,
        visibility: &mut [f32; LANES],
    ) {
        receivers.smooth.x.vectorized(
            #[inline(always)]
            || {
                let shadow = ShadowLanes::new(
                    &receivers.places,
                    source,
                    receivers.normals(),
                    receivers.is_mapped,
                );
                let terminator = shadow.terminator;
                let reached = terminator.zero().less(terminator).bits() & lit;
                let mut middle = RayLanes::NONE;
                shadow.put_rays(reached, &mut middle);
                let mut sums = terminator.zero();
                for first in (0..self.light_rays).step_by(TOGETHER as usize) {
                    let numbers = first..self.light_rays.min(first + TOGETHER);
                    batch.rays.clear();
                    batch.rays.resize(numbers.len(), RayLanes::NONE);
                    receivers.places.each(
                        reached,
                        #[inline(always)]
                        |lane, place| {
                            let scramble = Scramble::new((receivers.position)(lane), purpose);
                            let axis = middle.ray(lane).direction;
                            let smooth = receivers.smooth_of(lane);
                            let offset = &|| self.offset_of(receivers, lane, &place);
                            let start = RayStart { place: &place, smooth, offset };
                            let from = (source, &start, axis);
                            self.put_soft(from, (lane, scramble), numbers.clone(), batch);
                        },
                    );
                    batch.trace(self.rays, Spread::Narrow);
                    sums = batch.added_to(sums);
                }
                let own = terminator * (sums / sums.constant(self.light_rays as f32));
                let own = own.masked(sums.mask_of(reached));
                own.select(sums.mask_of(lit), sums.one()).store(visibility, 0);
            },
        );
    }

    /// Puts the rays of a lane to places of these numbers on a light with an extent.
    ///
    /// Outlined: one copy for all lane types.
    #[inline(never)]
    fn put_soft(
        &self,
        (source, start, axis): (&LightSource, &RayStart<'_>, DVec3),
        (lane, scramble): (usize, Scramble),
        numbers: Range<u32>,
        batch: &mut RayBatch,
    ) {
        for (rays, number) in batch.rays.iter_mut().zip(numbers) {
            let on_disc = self.disc.place(number, scramble);
            rays.put(lane, &source.ray_to(start, axis, on_disc));
        }
    }

    /// From the place of a lane to the curved surface that its triangle stands for.
    fn offset_of<N: Lanes>(
        &self,
        receivers: &Receivers<'_, N>,
        lane: usize,
        place: &SurfacePlace,
    ) -> DVec3 {
        let Some((ids, barycentric)) = receivers.curved else { return DVec3::ZERO };
        let weights = barycentric.map(|weight| weight.lane(lane));
        self.offset(TriangleId(ids[lane]), weights, place)
    }
}

/// The lanes where N.L > 0.
#[inline(always)]
fn lit<N: Lanes>(light: &PlacedLight, point: &SurfacePoint<N>) -> u32 {
    let n_dot_l = point.normal.dot(light.to_light(point.position));
    n_dot_l.zero().less(n_dot_l).bits()
}
