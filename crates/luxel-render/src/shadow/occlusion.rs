//! Occlusion of the samples of batches: V of each light, openness, and shadow rays that are not traced yet.

use super::place_cache::PlaceCache;
use luxel_lighting::Occlusion;
use luxel_math::LANES;
use luxel_math::prelude::*;
use luxel_rays::{RayLanes, SceneRays, Spread};

/// Occlusion of the samples of batches, with its memory, which a thread reuses.
#[derive(Default)]
pub(crate) struct OcclusionLanes {
    pub(super) of: [BatchOcclusion; BATCHES],
    pub(super) cache: PlaceCache,
    pub(super) batch: RayBatch,
    pub(super) pending: PendingRays,
}

/// Occlusion of the samples of one batch.
#[derive(Default)]
pub(super) struct BatchOcclusion {
    /// V of each light.
    pub(super) visibility: Vec<[f32; LANES]>,
    pub(super) openness: Option<[f32; LANES]>,
}

/// Batches whose rays to a light are traced as one packet. Of packets alone, those of four batches took as long as
/// those of two (`docs/notebook/rays-shadows-and-openness.md`).
pub(crate) const BATCHES: usize = 2;

/// Rays that are traced together, and what comes along them.
#[derive(Default)]
pub(super) struct RayBatch {
    pub(super) rays: Vec<RayLanes>,
    pub(super) through: Vec<[f32; LANES]>,
}

/// How many rays of each sample are traced together.
pub(super) const TOGETHER: u32 = 16;

impl OcclusionLanes {
    /// Clears the batch `number` out of `count`: no occlusion, and no pending ray to any of so many lights.
    #[inline(always)]
    pub(super) fn reset(&mut self, (number, count): (usize, usize), lights: usize) {
        let BatchOcclusion { visibility, openness } = &mut self.of[number % BATCHES];
        visibility.clear();
        visibility.resize(lights, [1.0; LANES]);
        *openness = None;
        let PendingRays { rays, lights: lanes, .. } = &mut self.pending;
        if rays.len() < lights * count {
            rays.resize(lights * count, RayLanes::NONE);
            lanes.resize(lights * count, LightLanes::default());
        }
        for light in 0..lights {
            rays[light * count + number].lanes = 0;
            lanes[light * count + number].lit = 0;
        }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.cache.begin_frame();
    }

    /// The openness of the first lane of the first batch.
    pub(crate) fn openness(&self) -> f32 {
        self.of[0].openness.map_or(1.0, |[first, ..]| first)
    }

    /// Of the batch of this number, as the lighting equation takes it.
    pub(crate) fn occlusion(&self, number: usize) -> Occlusion<'_> {
        let BatchOcclusion { visibility, openness } = &self.of[number % BATCHES];
        let visibility = (!visibility.is_empty()).then_some(&**visibility);
        Occlusion { visibility, openness: openness.as_ref() }
    }
}

/// Shadow rays to lights without extent that are not traced yet: light by light, for each batch.
pub(super) struct PendingRays {
    pub(super) rays: Vec<RayLanes>,
    pub(super) lights: Vec<LightLanes>,
    pub(super) through: [[f32; LANES]; BATCHES],
}

impl Default for PendingRays {
    fn default() -> Self {
        Self { rays: Vec::new(), lights: Vec::new(), through: [[1.0; LANES]; BATCHES] }
    }
}

/// One light at the samples of a batch: the lanes that face it, those that have a ray, and the terminator's
/// factor.
#[derive(Clone, Copy, Default)]
pub(super) struct LightLanes {
    pub(super) lit: u32,
    pub(super) reached: u32,
    pub(super) terminator: [f32; LANES],
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
