//! What shadows and openness of a frame need, and places from which rays leave.

use super::floor::Floor;
use super::sequence::DiscSequence;
use super::shadow_ray::LightSource;
use glam::DVec3;
use luxel_lighting::PlacedLight;
use luxel_math::prelude::*;
use luxel_rays::{PlaceLanes, SceneRays, SurfacePlace, TrianglePlaces};
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

/// How openness is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OpennessRule {
    /// What lies farther away doesn't count.
    pub(crate) radius: f64,
    /// Rays a sample.
    pub(crate) rays: u32,
}

impl Shadows<'_> {
    /// Shares the rays of a pixel out among its samples, of which each has its own.
    pub(crate) fn share_rays(&mut self, samples: usize) {
        let each = |rays: u32| rays.div_ceil(samples as u32);
        self.light_rays = each(self.light_rays);
        self.openness = self.openness.map(|rule| OpennessRule { rays: each(rule.rays), ..rule });
    }

    /// The place of a sample on its triangle, on the side that is seen; `None` of points and lines.
    pub(crate) fn place(&self, id: TriangleId, barycentric: [f32; 3]) -> Option<SurfacePlace> {
        let mut places = TrianglePlaces::default();
        let place = self.places_into(id, &mut places).then(|| places.at(barycentric))?;
        Some(self.seen_side(place))
    }

    /// A place on the side that is seen.
    pub(super) fn seen_side(&self, place: SurfacePlace) -> SurfacePlace {
        self.facing(&PlaceLanes::from(&place)).place()
    }

    /// Writes the places of a triangle; returns whether there are any: points and lines have none.
    pub(super) fn places_into(&self, id: TriangleId, places: &mut TrianglePlaces) -> bool {
        let of = self.frame.triangle(id).map(|of| self.placed.object_of(of.instance, of.triangle));
        let Some((object, Some(triangle))) = of else { return false };
        self.rays.places_into(object, triangle, places)
    }

    /// Places on the side that is seen.
    #[inline(always)]
    pub(super) fn facing<F: F64Lanes>(&self, places: &PlaceLanes<F>) -> PlaceLanes<F> {
        let [x, y, z] = places.position;
        let far = self
            .towards_eye
            .map(|DVec3 { x: a, y: b, z: c }| [x.constant(a), x.constant(b), x.constant(c)]);
        let DVec3 { x: a, y: b, z: c } = self.eye;
        places.facing(far.unwrap_or([x.constant(a) - x, x.constant(b) - y, x.constant(c) - z]))
    }

    /// From a place on a triangle to the curved surface that it stands for.
    pub(super) fn offset(
        &self,
        id: TriangleId,
        barycentric: [f32; 3],
        place: &SurfacePlace,
    ) -> DVec3 {
        let of = self.frame.triangle(id).map(|of| self.placed.object_of(of.instance, of.triangle));
        let Some((object, Some(triangle))) = of else { return DVec3::ZERO };
        self.rays.terminator_offset((object, triangle), barycentric, place)
    }
}

pub(super) fn wide(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}
