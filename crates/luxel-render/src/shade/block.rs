//! Sixteen samples into light: the one way from what a batch sees to its colours.

use crate::context::{LitAt, ShadingContext, needs};
use crate::interpolate::{Batch, Fragments, Wanted};
use crate::material::{Attributes, lit, lit_elsewhere, shading_normal};
use crate::setup::SetupCache;
use crate::shade::display::displayed;
use crate::shade::flat_light::FlatLights;
use crate::shade::kept_points::KeptPoints;
use crate::shade::lit_triangle::LitTriangles;
use crate::shade::studied::{draw_edges, is_studied, shadow, study};
use crate::shade::triangle_terms::TriangleTerms;
use crate::shade::witness::BlockWitness;
use crate::shadow::{BATCHES, OcclusionLanes, SeenSamples};
use luxel_lighting::{Occlusion, Silent, SurfacePoint};
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_view::ShadingMode;
use luxel_visibility::TriangleId;

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
    points: [KeptPoints; BATCHES],
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
            if scene.needs_flat_light_alone {
                let of = (&batch.ids, seen);
                found.attributes.light = cache.flat.of_lanes(simd, scene, of, &mut materials);
            } else {
                all_fragments(simd, scene, batch, cache, seen, &mut found, &mut materials);
            }
            let point = point_of(simd, scene, batch, &found);
            witness.fragments(scene, &found, &materials, &point, seen);
            let mut result = background(simd, scene);
            let mut left = seen;
            while left != 0 {
                let number = materials[left.trailing_zeros() as usize & (LANES - 1)];
                let lanes = left & simd.eq_mask(&materials, number);
                let own = &mut cache.occlusion;
                let of = (number, lanes);
                let color = light_of_material(scene, (batch, &found), &point, of, own, witness);
                if lanes == simd.all_lanes() {
                    result = color;
                    break;
                }
                result = color_where(simd, lanes, color, result);
                left &= !lanes;
            }
            // Surfaces alone: neither the background nor what is drawn over them.
            if let Some(display) = &scene.display {
                // A copy, because the call needs its arguments in memory, and only here.
                let copy = result;
                result = color_where(simd, seen, displayed(display, &copy), result);
            }
            if scene.edges.is_some() {
                return draw_edges(scene, batch, seen, result);
            }
            result
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
            let (mut material, mut point) = (0, point_of(simd, scene, batches[0].0, &found));
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
                    let samples = SeenSamples {
                        ids: &batch.ids,
                        lanes: seen,
                        position: &position_in(batch),
                        barycentric: &found.weights,
                        point: &point,
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
    let wanted = Wanted {
        position: NEEDS != needs::NORMALS && scene.needs_positions,
        normal: NEEDS == needs::NORMALS || scene.shading.mode == ShadingMode::Phong,
        light: NEEDS != needs::NORMALS && scene.shading.mode == ShadingMode::Gouraud,
    };
    setup.begin_tile(batch.tile);
    let wanted = (seen, wanted);
    let material = found.interpolate::<NEEDS>(simd, scene, batch, setup, wanted, &mut materials);
    let point = point_of(simd, scene, batch, found);
    witness.fragments(scene, found, &materials, &point, seen);
    (material, point)
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
    let mut color = if NEEDS == needs::NORMALS || scene.shading.mode == ShadingMode::Phong {
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

/// The background in all lanes.
#[inline(always)]
fn background<N: Lanes>(simd: N, scene: &ShadingContext<'_>) -> [N; 4] {
    let [r, g, b, alpha] = scene.background;
    [simd.constant(r), simd.constant(g), simd.constant(b), simd.constant(alpha)]
}

/// One colour in the lanes whose bit is set, another elsewhere.
#[inline(always)]
fn color_where<N: Lanes>(simd: N, lanes: u32, color: [N; 4], other: [N; 4]) -> [N; 4] {
    let mask = simd.mask_of(lanes);
    let ([r, g, b, alpha], [other_r, other_g, other_b, other_alpha]) = (color, other);
    [
        r.select(mask, other_r),
        g.select(mask, other_g),
        b.select(mask, other_b),
        alpha.select(mask, other_alpha),
    ]
}

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
