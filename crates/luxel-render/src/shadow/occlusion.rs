//! What keeps light from the samples of batches, and the rays that are asked for it.

use super::place_cache::PlaceCache;
use luxel_lighting::Occlusion;
use luxel_math::LANES;
use luxel_math::prelude::*;
use luxel_rays::{RayLanes, SceneRays, Spread};

/// What keeps light from the samples of batches, kept from batch to batch.
#[derive(Default)]
pub(crate) struct OcclusionLanes {
    pub(super) of: [BatchOcclusion; BATCHES],
    pub(super) cache: PlaceCache,
    pub(super) batch: RayBatch,
    pub(super) asking: Asking,
}

/// What keeps light from the samples of one batch.
#[derive(Default)]
pub(super) struct BatchOcclusion {
    /// V of each light.
    pub(super) visibility: Vec<[f32; LANES]>,
    pub(super) openness: Option<[f32; LANES]>,
}

/// Batches whose rays to a light are traced together. Two share 40 % of the nodes that they visit, four are
/// as fast.
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
    /// Forgets what kept so many lights from one of some batches.
    #[inline(always)]
    pub(super) fn forget(&mut self, (number, count): (usize, usize), lights: usize) {
        let BatchOcclusion { visibility, openness } = &mut self.of[number % BATCHES];
        visibility.clear();
        visibility.resize(lights, [1.0; LANES]);
        *openness = None;
        let Asking { rays, asked, .. } = &mut self.asking;
        if rays.len() < lights * count {
            rays.resize(lights * count, RayLanes::NONE);
            asked.resize(lights * count, Asked::default());
        }
        for light in 0..lights {
            rays[light * count + number].lanes = 0;
            asked[light * count + number].lit = 0;
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

/// What is asked of lights without extent: light by light, for each batch.
pub(super) struct Asking {
    pub(super) rays: Vec<RayLanes>,
    pub(super) asked: Vec<Asked>,
    pub(super) through: [[f32; LANES]; BATCHES],
}

impl Default for Asking {
    fn default() -> Self {
        Self { rays: Vec::new(), asked: Vec::new(), through: [[1.0; LANES]; BATCHES] }
    }
}

/// What comes of a light's rays from a batch: the lanes that face the light, those that have a ray, and what
/// normal maps let through.
#[derive(Clone, Copy, Default)]
pub(super) struct Asked {
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
