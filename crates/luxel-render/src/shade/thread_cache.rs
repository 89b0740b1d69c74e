//! What a thread keeps from block to block.

use super::flat_light::FlatLights;
use super::kept_points::KeptPoints;
use super::lit_triangle::LitTriangles;
use super::triangle_terms::TriangleTerms;
use crate::setup::SetupCache;
use crate::shadow::{BATCHES, OcclusionLanes};

/// What a thread keeps from block to block.
pub(crate) struct ThreadCache {
    pub(crate) setup: SetupCache,
    /// Triangles whose light is computed elsewhere than at their pixels, or interpolated in the window.
    pub(crate) lit: LitTriangles,
    /// Lights of triangles in flat shading.
    pub(super) flat: FlatLights,
    /// Terms of the light of corners and whole polygons, for layers.
    pub(crate) terms: TriangleTerms,
    /// Occlusion of batches' samples.
    pub(crate) occlusion: OcclusionLanes,
    /// Surface points of batches, while shadow rays are traced.
    pub(super) points: [KeptPoints; BATCHES],
}

impl ThreadCache {
    pub(crate) fn new() -> Self {
        Self {
            setup: SetupCache::new(),
            lit: LitTriangles::new(),
            flat: FlatLights::new(),
            terms: TriangleTerms::new(),
            occlusion: OcclusionLanes::default(),
            points: [KeptPoints::NONE; BATCHES],
        }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.setup.begin_frame();
        self.lit.begin_frame();
        self.flat.begin_frame();
        self.occlusion.begin_frame();
    }
}
