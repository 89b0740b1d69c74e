//! Terms of light that was computed elsewhere than at pixels: at corners, for whole polygons, or between pieces.

use super::witness::LayerWitness;
use crate::context::{LitAt, ShadingContext};
use crate::interpolate::Batch;
use crate::shade::{MixedTerms, ThreadCache, VisibleLights};
use luxel_math::{Lanes, lanes_of};
use luxel_visibility::TriangleId;

/// Gives the witness the terms of light that was computed elsewhere than at the pixels, lane by lane.
#[cold]
#[inline(never)]
pub(super) fn terms_elsewhere<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    witness: &mut LayerWitness<'_, N>,
) {
    for lane in lanes_of(seen) {
        let id = TriangleId(batch.ids[lane]);
        let Some(triangle) = cache.lit.get(scene, id) else { continue };
        let lit_at = scene.lit_at(triangle.material as usize);
        if lit_at == LitAt::Pixels {
            continue;
        }
        let barycentric = witness.weights.map(|weight| weight.lane(lane));
        let seen_at = (barycentric, batch.position(lane));
        let places = triangle.lit_at(seen_at.0, seen_at.1);
        let visible = VisibleLights::of(scene, id, seen_at, &places);
        let tint = witness.tint.lane(lane);
        // A texel under which the light was computed is a factor of its terms already.
        let texture = if lit_at == LitAt::PiecesUnderTexels { [1.0; 3] } else { tint };
        let mut terms = MixedTerms::of(&triangle.terms(scene, &places, tint), texture);
        let mut openness = 1.0;
        if let Some(visible) = visible {
            terms = terms.visible(scene, &visible);
            openness = visible.openness;
        }
        witness.put_lane(lane, &terms, openness);
    }
}
