//! The surface points of a batch.

use super::witness::BlockWitness;
use crate::context::ShadingContext;
use crate::interpolate::{Batch, Fragments};
use crate::material::Attributes;
use luxel_lighting::SurfacePoint;
use luxel_math::Lanes;

/// The surface points of a batch.
#[inline(always)]
pub(crate) fn point_of<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    found: &Fragments<N>,
) -> SurfacePoint<N> {
    let Attributes { position, normal, .. } = found.attributes;
    let [tile_x, tile_y] = batch.tile;
    let x = simd.load(&batch.x, 0) + simd.constant(tile_x as f32);
    let y = simd.load(&batch.y, 0) + simd.constant(tile_y as f32);
    scene.point_at_sample([x, y], position, normal)
}

/// The surface points of a batch whose light was computed elsewhere: with N and V if the witness hears surfaces.
#[inline(always)]
pub(super) fn point_heard<N: Lanes, W: BlockWitness<N>>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    found: &Fragments<N>,
) -> SurfacePoint<N> {
    if W::HEARS_SURFACES {
        point_of(simd, scene, batch, found)
    } else {
        scene.point_lit_elsewhere(found.attributes.position)
    }
}
