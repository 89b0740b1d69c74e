//! Terms of light that was computed elsewhere than at pixels: at corners, for whole polygons, or between pieces.

use super::witness::LayerWitness;
use crate::context::{LitAt, ShadingContext};
use crate::interpolate::Batch;
use crate::shade::{LitTriangle, MixedTerms, ThreadCache, VisibleLights};
use luxel_math::{LANES, Lanes, Rgb};
use luxel_visibility::TriangleId;

/// Gives the witness the terms of light that was computed elsewhere than at the pixels: all lanes together that see one
/// triangle, if they mix the light of the same places.
///
/// Outlined: one copy per lane type.
#[inline(never)]
pub(super) fn terms_elsewhere<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    witness: &mut LayerWitness<'_, N>,
) {
    witness.depth.vectorized(
        #[inline(always)]
        || {
            let simd = witness.depth;
            let mut left = seen;
            while left != 0 {
                let lane = left.trailing_zeros() as usize & (LANES - 1);
                let id = batch.ids[lane];
                let mut lanes = simd.eq_mask(&batch.ids, id) & left;
                let lit_at = |of: &LitTriangle| scene.lit_at(of.material as usize);
                let triangle = cache.lit.get(scene, TriangleId(id));
                let Some(triangle) = triangle.filter(|of| lit_at(of) != LitAt::Pixels) else {
                    left &= !lanes;
                    continue;
                };
                let are_together = scene.shadows.is_none() && triangle.has_same_places();
                if !are_together {
                    lanes = 1 << lane;
                }
                left &= !lanes;
                let seen_at =
                    (witness.weights.map(|weight| weight.lane(lane)), batch.position(lane));
                let places = triangle.lit_at(seen_at.0, seen_at.1);
                let visible = VisibleLights::of(scene, TriangleId(id), seen_at, &places);
                let weights = places.iter().map(|place| match are_together && places.len() > 1 {
                    true => witness.weights[place.number as usize],
                    false => simd.constant(place.weight),
                });
                // A texel under which the light was computed is a factor of its terms already.
                let texture = match lit_at(triangle) {
                    LitAt::PiecesUnderTexels => Rgb::splat(simd, [1.0; 3]),
                    LitAt::Elsewhere | LitAt::Pixels => witness.tint,
                };
                let terms = triangle.terms(scene, &places, witness.tint.lane(lane));
                let weighted: Vec<_> = weights.zip(terms).collect();
                let mut terms = MixedTerms::of(&weighted, texture);
                let mut openness = 1.0;
                if let Some(visible) = visible {
                    terms = terms.visible(scene, &visible);
                    openness = visible.openness;
                }
                witness.put_terms(lanes, &terms, openness);
            }
        },
    );
}
