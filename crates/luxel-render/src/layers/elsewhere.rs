//! Terms of light that was computed elsewhere than at pixels: at corners, for whole polygons, or between pieces.

use super::witness::LayerWitness;
use crate::context::{LitAt, ShadingContext};
use crate::interpolate::Batch;
use crate::shade::{BlockWitness, MixedTerms, Term, ThreadCache, TriangleTerms, VisibleLights};
use luxel_lighting::Witness;
use luxel_math::{Lanes, Rgb, lanes_of};
use luxel_visibility::TriangleId;

/// Gives the witness the terms of light that was computed elsewhere than at the pixels: all lanes together, or
/// sample by sample where each mixes the light of places of its own.
pub(super) fn terms_elsewhere<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    witness: &mut LayerWitness<'_, N>,
) {
    if TriangleTerms::are_mixed(scene) {
        let (weights, texture) = (witness.weights, witness.tint);
        cache.terms.mix(
            scene,
            (&batch.ids, seen),
            &weights,
            texture,
            #[inline(always)]
            |lanes, mix| {
                witness.lanes(lanes);
                for index in 0..mix.lights() {
                    witness.put_light(index, &mix.light(index));
                }
                let [emission, ambient] = [mix.sum(Term::Emission), mix.sum(Term::SceneAmbient)];
                witness.keep_terms(emission, ambient, mix.sum(Term::Environment));
            },
        );
        return;
    }
    for lane in lanes_of(seen) {
        let weights = witness.weights.map(|weight| weight.lane(lane));
        let seen_at = (weights, batch.position(lane));
        let of = (TriangleId(batch.ids[lane]), seen_at, witness.tint.lane(lane));
        if let Some((terms, openness)) = terms_of_sample(scene, cache, of) {
            put_sample(1 << lane, &terms, openness, witness);
        }
    }
}

/// The terms of one sample of a triangle, by barycentrics, place in the window and texture, and the openness there.
fn terms_of_sample(
    scene: &ShadingContext<'_>,
    cache: &mut ThreadCache,
    (id, seen_at, tint): (TriangleId, ([f32; 3], [f64; 2]), [f32; 3]),
) -> Option<(MixedTerms, f32)> {
    let triangle = cache.lit.get(scene, id)?;
    // A texel under which the light was computed is a factor of its terms already.
    let texture = match scene.lit_at(triangle.material as usize) {
        LitAt::Pixels => return None,
        LitAt::PiecesUnderTexels => [1.0; 3],
        LitAt::Elsewhere => tint,
    };
    let places = triangle.lit_at(seen_at.0, seen_at.1);
    let visible = VisibleLights::of(scene, id, seen_at, &places);
    let terms = triangle.terms(scene, &places, tint);
    let weighted: Vec<_> = places.iter().map(|place| place.weight).zip(terms).collect();
    let terms = MixedTerms::of(&weighted, Rgb::splat(0.0, texture));
    Some(match visible {
        Some(visible) => (terms.visible(scene, &visible), visible.openness),
        None => (terms, 1.0),
    })
}

/// Gives the witness the terms of one lane.
///
/// Outlined: one copy per lane type.
#[inline(never)]
fn put_sample<N: Lanes>(
    lane: u32,
    terms: &MixedTerms,
    openness: f32,
    witness: &mut LayerWitness<'_, N>,
) {
    let simd = witness.depth.zero();
    simd.vectorized(
        #[inline(always)]
        || {
            witness.lanes(lane);
            witness.openness(simd.constant(openness));
            for (index, light) in terms.lights.iter().enumerate() {
                witness.put_light(index, &light.in_all_lanes(simd));
            }
            let emission = Rgb::splat(simd, terms.emission.lane(0));
            let ambient = Rgb::splat(simd, terms.scene_ambient.lane(0));
            witness.keep_terms(emission, ambient, Rgb::splat(simd, terms.environment.lane(0)));
        },
    );
}
