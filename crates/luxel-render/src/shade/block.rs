//! Sixteen samples into light: the one way from what a batch sees to its colours.

use super::colors::{background, by_material, color_where, finished};
use super::display::displayed;
use super::flat_light::shade_flat;
use super::points::{point_heard, point_of};
use super::studied::{is_studied, shadow, study};
use super::thread_cache::ThreadCache;
use super::witness::BlockWitness;
use crate::context::{LitAt, ShadingContext, needs};
use crate::interpolate::{Batch, Fragments, Wanted};
use crate::material::{lit, lit_elsewhere, shading_normal};
use crate::setup::SetupCache;
use crate::shadow::{BATCHES, OcclusionLanes, SeenSamples};
use luxel_lighting::{Occlusion, Silent, SurfacePoint};
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_view::ShadingMode;
use luxel_visibility::TriangleId;

/// The colour (straight) and alpha of the samples, as the picture shows them; the background's where nothing
/// is seen. Witnesses hear the light before exposure and tone curve.
///
/// Outlined: one copy per lane type.
#[inline(never)]
pub(crate) fn shade<N: Lanes, W: BlockWitness<N>>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    witness: &mut W,
) -> [N; 4] {
    simd.vectorized(
        #[inline(always)]
        || {
            // A token of its own: the one that the closure refers to is copied through memory.
            let simd = simd.zero();
            let seen = seen_lanes(simd, batch);
            if seen == 0 {
                return background(simd, scene);
            }
            if scene.needs_flat_light_alone {
                return shade_flat(simd, scene, batch, &mut cache.flat, witness, seen);
            }
            // Witnesses hear all attributes.
            if !N::IS_SPECIALIZED
                || W::HEARS_SURFACES
                || is_shadowed_elsewhere(scene)
                || !is_plain(simd, scene, batch, &mut cache.setup, seen)
            {
                shade_everything(simd, scene, batch, cache, witness, seen)
            } else if !scene.needs_normals_alone || scene.shadows.is_some() {
                let mut colors = [[simd; 4]; BATCHES];
                shade_places(simd, scene, &[(batch, seen)], cache, witness, &mut colors);
                colors[0]
            } else {
                let mut found = Fragments::nothing(simd);
                let setup = &mut cache.setup;
                let (material, point) = see::<N, W, { needs::NORMALS }>(
                    scene,
                    (batch, seen),
                    setup,
                    &mut found,
                    witness,
                );
                let (of, occlusion) = ((material, seen), Occlusion::NONE);
                light_up::<N, W, { needs::NORMALS }>(scene, &found, &point, of, occlusion, witness)
            }
        },
    )
}

/// [`shade`] for batches whose shadow rays are traced together, without a witness.
///
/// Outlined: one copy per lane type.
#[inline(never)]
pub(crate) fn shade_together<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batches: &[Batch; BATCHES],
    cache: &mut ThreadCache,
) -> [[N; 4]; BATCHES] {
    simd.vectorized(
        #[inline(always)]
        || {
            let simd = simd.zero();
            let [first, second] = batches;
            let each = [(first, seen_lanes(simd, first)), (second, seen_lanes(simd, second))];
            let mut colors = [[simd; 4]; BATCHES];
            let is_together = N::IS_SPECIALIZED
                && scene.shadows.is_some()
                && scene.shading.mode == ShadingMode::Phong
                && each.iter().all(|(batch, seen)| {
                    *seen != 0 && is_plain(simd, scene, batch, &mut cache.setup, *seen)
                });
            if is_together {
                shade_places(simd, scene, &each, cache, &mut Silent, &mut colors);
            } else {
                for (batch, color) in batches.iter().zip(&mut colors) {
                    *color = shade(simd, scene, batch, cache, &mut Silent);
                }
            }
            colors
        },
    )
}

/// Whether shadows fall on light that was computed elsewhere than at pixels.
#[inline(always)]
fn is_shadowed_elsewhere(scene: &ShadingContext<'_>) -> bool {
    scene.shadows.is_some() && scene.shading.mode != ShadingMode::Phong
}

/// The lanes of a batch that see something.
#[inline(always)]
fn seen_lanes<N: Lanes>(simd: N, batch: &Batch) -> u32 {
    let all = simd.all_lanes();
    if batch.is_single { all } else { all & !simd.eq_mask(&batch.ids, TriangleId::NONE.0) }
}

/// Whether a batch is of one material, and reads no attributes beside positions, normals and light.
#[inline(always)]
fn is_plain<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    setup: &mut SetupCache,
    seen: u32,
) -> bool {
    if scene.is_plain {
        return true;
    }
    if is_studied(&scene.shading) || scene.edges.is_some() {
        return false;
    }
    setup.begin_tile(batch.tile);
    let begins = simd.run_starts(&batch.ids) & seen;
    setup.require(simd, scene, &batch.ids, begins);
    let first = batch.ids[seen.trailing_zeros() as usize & (LANES - 1)];
    let material = setup.material(first);
    lanes_of(begins).all(|lane| {
        let id = batch.ids[lane & (LANES - 1)];
        setup.has(id) && !setup.reads(id).any() && setup.material(id) == material
    })
}

/// Shades batches that read any attribute, and those of several materials.
#[inline(never)]
fn shade_everything<N: Lanes, W: BlockWitness<N>>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    witness: &mut W,
    seen: u32,
) -> [N; 4] {
    simd.vectorized(
        #[inline(always)]
        || {
            let simd = simd.zero();
            let mut materials = [0; LANES];
            let mut found = Fragments::nothing(simd);
            all_fragments(simd, scene, batch, cache, seen, &mut found, &mut materials);
            let point = point_of(simd, scene, batch, &found);
            witness.fragments(scene, &found, &materials, &point, seen);
            let own = &mut cache.occlusion;
            let result = by_material(
                simd,
                scene,
                (&materials, seen),
                #[inline(always)]
                |of| light_of_material(scene, (batch, &found), &point, of, own, witness),
            );
            finished(simd, scene, batch, seen, result)
        },
    )
}

/// Shades batches of one material each that need places. The shadow rays of all batches are cast before any is
/// traced.
#[inline(never)]
fn shade_places<N: Lanes, W: BlockWitness<N>>(
    simd: N,
    scene: &ShadingContext<'_>,
    batches: &[(&Batch, u32)],
    cache: &mut ThreadCache,
    witness: &mut W,
    colors: &mut [[N; 4]; BATCHES],
) {
    simd.vectorized(
        #[inline(always)]
        || {
            let simd = simd.zero();
            let count = batches.len().min(BATCHES);
            let shadows = scene.shadows.filter(|_| scene.shading.mode == ShadingMode::Phong);
            let mut found = Fragments::nothing(simd);
            // Taken by no batch: the first replaces them.
            let (mut material, mut point) =
                (0, scene.point_lit_elsewhere(found.attributes.position));
            for (number, &(batch, seen)) in batches.iter().take(count).enumerate() {
                if number > 0 {
                    cache.points[number - 1].keep(material, &point);
                }
                let setup = &mut cache.setup;
                (material, point) = see::<N, W, { needs::PLACES }>(
                    scene,
                    (batch, seen),
                    setup,
                    &mut found,
                    witness,
                );
                if let Some(shadows) = shadows {
                    // Copies, because the call needs its arguments in memory, and only here.
                    let (barycentric, seen_point) = (found.weights, point);
                    let samples = SeenSamples {
                        ids: &batch.ids,
                        lanes: seen,
                        position: &position_in(batch),
                        barycentric: &barycentric,
                        point: &seen_point,
                        smooth: point.normal,
                        is_mapped: false,
                    };
                    shadows.cast(&samples, (number, count), &mut cache.occlusion);
                }
            }
            if let Some(shadows) = shadows {
                shadows.trace_pending(simd, count, &mut cache.occlusion);
            }
            // The last first, whose points are in registers.
            for number in (0..count).rev() {
                if number + 1 < count {
                    (material, point) = cache.points[number].of(simd);
                }
                let occlusion = match shadows {
                    Some(_) => cache.occlusion.occlusion(number),
                    None => Occlusion::NONE,
                };
                let of = (material, batches[number].1);
                colors[number] = light_up::<N, W, { needs::PLACES }>(
                    scene, &found, &point, of, occlusion, witness,
                );
            }
        },
    );
}

/// Where a batch's samples are in the window.
fn position_in(batch: &Batch) -> impl Fn(usize) -> [f64; 2] {
    |lane| batch.position(lane)
}

/// Interpolates a batch of one material: returns the material and the surface points.
#[inline(always)]
fn see<N: Lanes, W: BlockWitness<N>, const NEEDS: u8>(
    scene: &ShadingContext<'_>,
    (batch, seen): (&Batch, u32),
    setup: &mut SetupCache,
    found: &mut Fragments<N>,
    witness: &mut W,
) -> (u32, SurfacePoint<N>) {
    let (simd, mut materials) = (found.weights[0].zero(), [0; LANES]);
    let is_lit_here = is_lit_at_pixels::<NEEDS>(scene);
    let wanted = Wanted {
        position: NEEDS != needs::NORMALS && scene.needs_positions,
        normal: is_lit_here,
        light: NEEDS != needs::NORMALS && scene.shading.mode == ShadingMode::Gouraud,
    };
    setup.begin_tile(batch.tile);
    let wanted = (seen, wanted);
    let material = found.interpolate::<NEEDS>(simd, scene, batch, setup, wanted, &mut materials);
    let point = if is_lit_here {
        point_of(simd, scene, batch, found)
    } else {
        point_heard::<N, W>(simd, scene, batch, found)
    };
    witness.fragments(scene, found, &materials, &point, seen);
    (material, point)
}

/// Whether light is computed at pixels.
#[inline(always)]
fn is_lit_at_pixels<const NEEDS: u8>(scene: &ShadingContext<'_>) -> bool {
    // Known when this is compiled, where normals alone are needed.
    NEEDS == needs::NORMALS || scene.shading.mode == ShadingMode::Phong
}

/// The colour of a batch of one material.
#[inline(always)]
fn light_up<N: Lanes, W: BlockWitness<N>, const NEEDS: u8>(
    scene: &ShadingContext<'_>,
    found: &Fragments<N>,
    point: &SurfacePoint<N>,
    (material, seen): (u32, u32),
    occlusion: Occlusion<'_>,
    witness: &mut W,
) -> [N; 4] {
    let simd = point.depth.zero();
    let attributes = &found.attributes;
    let of = (material as usize, seen);
    witness.lanes(seen);
    let mut color = if is_lit_at_pixels::<NEEDS>(scene) {
        lit::<N, W, NEEDS>(scene, attributes, point, of, occlusion, witness)
    } else {
        lit_elsewhere::<N, W, NEEDS>(scene, attributes, point, of.0, seen, witness)
    };
    if let Some(display) = &scene.display {
        let copy = color;
        color = displayed(display, &copy);
    }
    if seen == simd.all_lanes() {
        return color;
    }
    color_where(simd, seen, color, background(simd, scene))
}

/// The light of the lanes that see one material, of a batch that reads any attribute.
#[inline(always)]
fn light_of_material<N: Lanes, W: BlockWitness<N>>(
    scene: &ShadingContext<'_>,
    (batch, found): (&Batch, &Fragments<N>),
    point: &SurfacePoint<N>,
    (material, lanes): (u32, u32),
    own: &mut OcclusionLanes,
    witness: &mut W,
) -> [N; 4] {
    let number = material as usize;
    witness.lanes(lanes);
    let attributes = &found.attributes;
    if scene.shading.mode != ShadingMode::Phong && scene.lit_at(number) != LitAt::Pixels {
        return lit_elsewhere::<N, W, { needs::ALL }>(
            scene, attributes, point, number, lanes, witness,
        );
    }
    let smooth = point.normal;
    let normal = shading_normal(scene, attributes, smooth, number, lanes);
    let point = &SurfacePoint { normal, ..*point };
    let mut occlusion = Occlusion::NONE;
    if let Some(shadows) = scene.shadows {
        let position = &position_in(batch);
        let (ids, barycentric) = (&batch.ids, &found.weights);
        let is_mapped = true;
        let samples = SeenSamples { ids, lanes, position, barycentric, point, smooth, is_mapped };
        shadows.cast(&samples, (0, 1), own);
        shadows.trace_pending(point.depth, 1, own);
        occlusion = own.occlusion(0);
    }
    let of = (number, lanes);
    lit::<N, W, { needs::ALL }>(scene, attributes, point, of, occlusion, witness)
}

/// All attributes of a batch, as the view interpolates and lights them. Other lanes than `seen` hold
/// anything.
///
/// Outlined: one copy per lane type, for drawing and for layers.
#[inline(never)]
pub(crate) fn all_fragments<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    found: &mut Fragments<N>,
    materials: &mut [u32; LANES],
) {
    let wanted = Wanted {
        position: scene.needs_positions,
        normal: true,
        light: scene.shading.mode == ShadingMode::Gouraud,
    };
    let is_studied = is_studied(&scene.shading);
    let is_shadowed = is_shadowed_elsewhere(scene);
    if N::IS_SPECIALIZED && !scene.has_extras && !is_studied && !is_shadowed {
        geometry_of(simd, scene, batch, &mut cache.setup, (seen, wanted), found, materials);
        return;
    }
    simd.vectorized(
        #[inline(always)]
        || {
            cache.setup.begin_tile(batch.tile);
            let setup = &mut cache.setup;
            let wanted = (seen, wanted);
            found.interpolate::<{ needs::ALL }>(simd, scene, batch, setup, wanted, materials);
            if is_studied {
                study(scene, batch, cache, seen, found);
            }
            if is_shadowed {
                shadow(scene, batch, cache, seen, found);
            }
        },
    );
}

/// Interpolates the barycentrics of a batch, and positions and normals as `wanted` says, for views that interpolate
/// in perspective. Lanes outside `seen` are unspecified.
///
/// Outlined: one copy per lane type.
#[inline(never)]
pub(crate) fn geometry_of<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    setup: &mut SetupCache,
    (seen, wanted): (u32, Wanted),
    found: &mut Fragments<N>,
    materials: &mut [u32; LANES],
) {
    simd.vectorized(
        #[inline(always)]
        || {
            setup.begin_tile(batch.tile);
            let wanted = (seen, wanted);
            found.interpolate::<{ needs::PLACES }>(simd, scene, batch, setup, wanted, materials);
        },
    );
}
