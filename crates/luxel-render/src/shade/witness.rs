//! Who hears what a block sees, beside the terms of its light.

use crate::context::ShadingContext;
use crate::interpolate::Fragments;
use crate::material::SurfaceWitness;
use luxel_lighting::{Silent, SurfacePoint};
use luxel_math::LANES;

/// Hears what sixteen samples see.
pub(crate) trait BlockWitness<N>: SurfaceWitness<N> {
    /// What is seen in the lanes whose bit is set, and the number of its material.
    #[inline(always)]
    fn fragments(
        &mut self,
        scene: &ShadingContext<'_>,
        found: &Fragments<N>,
        materials: &[u32; LANES],
        point: &SurfacePoint<N>,
        seen: u32,
    ) {
        let _ = (scene, found, materials, point, seen);
    }

    /// The lanes whose light is heard next.
    #[inline(always)]
    fn lanes(&mut self, lanes: u32) {
        let _ = lanes;
    }
}

impl<N> BlockWitness<N> for Silent {}
