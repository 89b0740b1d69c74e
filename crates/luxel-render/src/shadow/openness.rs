//! Openness: how much of the sky over a place nothing is in the way of.

use super::occlusion::{RayBatch, TOGETHER};
use super::sequence::{DiscSequence, Scramble};
use super::shadow_ray::dot;
use super::shadows::{OpennessRule, Shadows};
use glam::DVec3;
use luxel_math::prelude::*;
use luxel_math::{LANES, lanes_of};
use luxel_rays::{PlaceLanes, RayLanes, Spread, SurfacePlace};

/// The purpose of openness among the sequences of a sample; lights have their numbers.
const PURPOSE: u32 = u32::MAX;

impl Shadows<'_> {
    /// The openness of places with the shading normals N: the mean of what comes along rays about N, more
    /// of them near it by the cosine of their angle, as ambient light arrives:
    ///
    /// ```text
    /// openness = 1/pi integral over the hemisphere of T(d) (N.d) dd
    /// ```
    ///
    /// A ground under the model counts as near, too. Directions below the triangle itself are mirrored at its plane: a convex surface is open, however
    /// its normals lean.
    ///
    /// Outlined: one copy per lane type, for surfaces and the ground.
    #[inline(never)]
    pub(super) fn open<N: Lanes>(
        &self,
        rule: OpennessRule,
        (places, normal, lanes): (&PlaceLanes<N::F64>, [N; 3], u32),
        position: &dyn Fn(usize) -> [f64; 2],
        batch: &mut RayBatch,
        openness: &mut [f32; LANES],
    ) {
        normal[0].vectorized(
            #[inline(always)]
            || {
                let simd = normal[0];
                let mut frames = Frames::new(normal, lanes, position);
                let wide = places.position[0];
                let [normal, tangent, bitangent] = frames.axes.map(
                    #[inline(always)]
                    |axis| {
                        axis.map(
                            #[inline(always)]
                            |side| wide.load(&side),
                        )
                    },
                );
                let origin = places.origin();
                let mut sums = simd.zero();
                for first in (0..rule.rays).step_by(TOGETHER as usize) {
                    let numbers = first..rule.rays.min(first + TOGETHER);
                    batch.rays.resize(numbers.len(), RayLanes::NONE);
                    for (rays, number) in batch.rays.iter_mut().zip(numbers) {
                        frames.place(&self.disc, number);
                        let [u, v] = [wide.load(&frames.disc[0]), wide.load(&frames.disc[1])];
                        let one = wide.constant(1.0);
                        let squared = one - u * u - v * v;
                        let up = squared.if_positive(squared, wide.constant(0.0)).sqrt();
                        let mut direction = [wide; 3];
                        for axis in 0..3 {
                            direction[axis] =
                                tangent[axis] * u + bitangent[axis] * v + normal[axis] * up;
                        }
                        let above = dot(places.normal, direction);
                        let below = (-above).if_positive(above, wide.constant(0.0));
                        let twice = wide.constant(2.0) * below;
                        rays.lanes = frames.lanes;
                        for axis in 0..3 {
                            let along = direction[axis] - places.normal[axis] * twice;
                            along.store(&mut rays.direction[axis]);
                            origin[axis].store(&mut rays.origin[axis]);
                        }
                        rays.end = [rule.radius; LANES];
                        if let Some(floor) = self.floor {
                            rays.lanes &= !floor.met_by(rays);
                        }
                    }
                    batch.trace(self.rays, Spread::Wide);
                    sums = batch.added_to(sums);
                }
                let own = sums / sums.constant(rule.rays as f32);
                own.select(sums.mask_of(frames.lanes), sums.one()).store(openness, 0);
            },
        );
    }

    /// The openness of one place with the shading normal N, for a sample of the window.
    pub(crate) fn openness(
        &self,
        rule: OpennessRule,
        place: &SurfacePlace,
        normal: [f32; 3],
        position: [f64; 2],
    ) -> f32 {
        let (mut openness, mut batch) = ([1.0; LANES], RayBatch::default());
        let at = (&place.into(), normal, 1);
        self.open(rule, at, &|_| position, &mut batch, &mut openness);
        openness[0]
    }
}

/// Where the hemispheres over samples are, and where a ray of each crosses the disc under them.
struct Frames {
    /// The lanes whose normal has a direction.
    lanes: u32,
    /// The normals, and two directions across each.
    axes: [[[f64; LANES]; 3]; 3],
    scrambles: [Scramble; LANES],
    disc: [[f64; LANES]; 2],
}

impl Frames {
    #[inline(always)]
    fn new<N: Lanes>(normals: [N; 3], lanes: u32, position: &dyn Fn(usize) -> [f64; 2]) -> Self {
        let mut frames = Self {
            lanes: 0,
            axes: [[[0.0; LANES]; 3]; 3],
            scrambles: [Scramble::default(); LANES],
            disc: [[0.0; LANES]; 2],
        };
        let [x, y, z] = [normals[0].to_f64(), normals[1].to_f64(), normals[2].to_f64()];
        let over_length = x.constant(1.0) / dot([x, y, z], [x, y, z]).sqrt();
        let mut over_lengths = [0.0; LANES];
        over_length.store(&mut over_lengths);
        for (axis, side) in [x, y, z].into_iter().enumerate() {
            (side * over_length).store(&mut frames.axes[0][axis]);
        }
        frames.turn(lanes, &over_lengths, position);
        frames
    }

    /// Finds the directions across the normals of lanes, of which those without one are left out.
    ///
    /// Outlined: one copy for all lane types.
    #[inline(never)]
    fn turn(
        &mut self,
        lanes: u32,
        over_lengths: &[f64; LANES],
        position: &dyn Fn(usize) -> [f64; 2],
    ) {
        for lane in lanes_of(lanes) {
            if !(over_lengths[lane].is_finite() && over_lengths[lane] > 0.0) {
                continue;
            }
            let [x, y, z] = &self.axes[0];
            let normal = DVec3::new(x[lane], y[lane], z[lane]);
            let (tangent, bitangent) = normal.any_orthonormal_pair();
            for (of, axis) in self.axes[1..].iter_mut().zip([tangent, bitangent]) {
                (of[0][lane], of[1][lane], of[2][lane]) = (axis.x, axis.y, axis.z);
            }
            self.scrambles[lane] = Scramble::new(position(lane), PURPOSE);
            self.lanes |= 1 << lane;
        }
    }

    /// Goes to the place of this number on each disc.
    ///
    /// Outlined: one copy for all lane types.
    #[inline(never)]
    fn place(&mut self, disc: &DiscSequence, number: u32) {
        for lane in lanes_of(self.lanes) {
            [self.disc[0][lane], self.disc[1][lane]] = disc.place(number, self.scrambles[lane]);
        }
    }
}
