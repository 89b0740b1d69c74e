//! V of each light at one sample, and the rays that find it.

use super::batches::Receivers;
use super::occlusion::{LightLanes, RayBatch};
use super::sequence::Scramble;
use super::shadow_ray::{LightSource, RayStart, ShadowLanes};
use super::shadows::{Receiver, Shadows, wide};
use luxel_lighting::SurfacePoint;
use luxel_math::{LANES, Vec3};
use luxel_rays::{RayLanes, SurfacePlace, WorldRay};
use luxel_visibility::TriangleId;

impl Shadows<'_> {
    /// The light of this number, as a receiver sees it.
    fn source(&self, light: usize, place: &SurfacePlace, of: &Receiver) -> Option<LightSource> {
        let source = *self.sources.get(light)?;
        let at_horizon = || source.at_horizon(place.origin(), wide(of.smooth));
        Some(if of.is_between { at_horizon() } else { source })
    }

    /// V of the light of this number at a receiver's place.
    pub(crate) fn visibility(&self, light: usize, place: &SurfacePlace, of: &Receiver) -> f32 {
        let Some(source) = self.source(light, place, of) else { return 1.0 };
        let vector = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z);
        let point = SurfacePoint {
            position: vector([0.0; 3]),
            normal: vector(of.normal),
            view: vector([0.0; 3]),
            depth: 0.0,
        };
        let mut ids = [TriangleId::NONE.0; LANES];
        ids[0] = of.id.0;
        let receivers = Receivers {
            places: place.into(),
            point: &point,
            smooth: vector(of.smooth),
            is_mapped: true,
            placed: 1,
            near: 0,
            position: &|_| of.position,
            curved: Some((&ids, &of.barycentric)),
        };
        if !source.is_point() {
            let (mut visibility, mut batch) = ([1.0; LANES], RayBatch::default());
            self.soft(&receivers, (&source, light as u32), 1, &mut batch, &mut visibility);
            return visibility[0];
        }
        let mut lanes = LightLanes { lit: 1, ..LightLanes::default() };
        let mut rays = RayLanes::NONE;
        self.rays_to_point(&receivers, &source, &mut rays, &mut lanes);
        if lanes.reached == 0 {
            return 0.0;
        }
        lanes.terminator[0] * self.rays.transmittance(&rays.ray(0))
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
        let shadow = ShadowLanes::<f32>::new(&place.into(), &source, normals, true);
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
