//! Sixteen samples into light: the one way from what a batch sees to its colours.

use crate::context::{LitAt, ShadingContext, needs};
use crate::coverage::edge_distance;
use crate::interpolate::{Batch, Fragments, Wanted};
use crate::material::{Attributes, base_texel, lit, lit_elsewhere, shading_normal};
use crate::setup::SetupCache;
use crate::shade::display::displayed;
use crate::shade::lit_triangle::LitTriangles;
use crate::shade::shadowed::VisibleLights;
use crate::shade::witness::BlockWitness;
use crate::shadow::{OcclusionLanes, SeenSamples};
use luxel_lighting::{Occlusion, SurfacePoint};
use luxel_math::{F64Lanes, LANES, Lanes, lanes_of};
use luxel_view::{Interpolation, Shading, ShadingMode};
use luxel_visibility::TriangleId;

/// What a thread keeps from block to block.
pub(crate) struct ThreadCache {
    pub(crate) setup: SetupCache,
    /// Triangles whose light is computed elsewhere than at their pixels, or interpolated in the window.
    pub(crate) lit: LitTriangles,
    /// What keeps light from a batch's samples.
    pub(crate) occlusion: OcclusionLanes,
}

impl ThreadCache {
    pub(crate) fn new() -> Self {
        Self {
            setup: SetupCache::new(),
            lit: LitTriangles::new(),
            occlusion: OcclusionLanes::default(),
        }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.setup.begin_frame();
        self.lit.begin_frame();
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
            let mut seen = simd.all_lanes();
            if !batch.is_single {
                seen &= !simd.eq_mask(&batch.ids, TriangleId::NONE.0);
            }
            if seen == 0 {
                return background(simd, scene);
            }
            if !N::IS_SPECIALIZED
                || W::HEARS_SURFACES
                || scene.shadows.is_some() && scene.shading.mode != ShadingMode::Phong
                || !is_plain(simd, scene, batch, &mut cache.setup, seen)
            {
                shade_outlined::<N, W, { needs::ALL }>(simd, scene, batch, cache, witness, seen)
            } else if W::HEARS_FRAGMENTS || !scene.needs_normals_alone || scene.shadows.is_some() {
                shade_outlined::<N, W, { needs::PLACES }>(simd, scene, batch, cache, witness, seen)
            } else {
                shade_seen::<N, W, { needs::NORMALS }>(simd, scene, batch, cache, witness, seen)
            }
        },
    )
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

#[inline(never)]
fn shade_outlined<N: Lanes, W: BlockWitness<N>, const NEEDS: u8>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    witness: &mut W,
    seen: u32,
) -> [N; 4] {
    simd.vectorized(
        #[inline(always)]
        || shade_seen::<N, W, NEEDS>(simd, scene, batch, cache, witness, seen),
    )
}

#[inline(always)]
fn shade_seen<N: Lanes, W: BlockWitness<N>, const NEEDS: u8>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    witness: &mut W,
    seen: u32,
) -> [N; 4] {
    let mut materials = [0; LANES];
    let mut found = Fragments::nothing(simd);
    if NEEDS == needs::ALL {
        all_fragments(simd, scene, batch, cache, seen, &mut found, &mut materials);
        let point = point_of(simd, scene, batch, &found);
        witness.fragments(scene, &found, &materials, &point, seen);
        let mut result = background(simd, scene);
        let mut left = seen;
        while left != 0 {
            let number = materials[left.trailing_zeros() as usize & (LANES - 1)];
            let lanes = left & simd.eq_mask(&materials, number);
            let occluded = (batch, &mut cache.occlusion);
            let of = (number, lanes);
            let color = light::<N, W, NEEDS>(scene, &found, &point, of, Some(occluded), witness);
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
        return result;
    }
    let wanted = Wanted {
        position: NEEDS != needs::NORMALS && scene.needs_positions,
        normal: NEEDS == needs::NORMALS
            || scene.shading.mode == ShadingMode::Phong
            || W::HEARS_FRAGMENTS,
        light: NEEDS != needs::NORMALS && scene.shading.mode == ShadingMode::Gouraud,
    };
    cache.setup.begin_tile(batch.tile);
    let setup = &mut cache.setup;
    let material =
        found.interpolate::<NEEDS>(simd, scene, batch, setup, (seen, wanted), &mut materials);
    let point = point_of(simd, scene, batch, &found);
    witness.fragments(scene, &found, &materials, &point, seen);
    let occluded = (NEEDS == needs::PLACES).then_some((batch, &mut cache.occlusion));
    let of = (material, seen);
    let mut color = light::<N, W, NEEDS>(scene, &found, &point, of, occluded, witness);
    if let Some(display) = &scene.display {
        let copy = color;
        color = displayed(display, &copy);
    }
    if seen == simd.all_lanes() {
        return color;
    }
    color_where(simd, seen, color, background(simd, scene))
}

/// The light of the lanes that see one material.
#[inline(always)]
fn light<N: Lanes, W: BlockWitness<N>, const NEEDS: u8>(
    scene: &ShadingContext<'_>,
    found: &Fragments<N>,
    point: &SurfacePoint<N>,
    (material, lanes): (u32, u32),
    occluded: Option<(&Batch, &mut OcclusionLanes)>,
    witness: &mut W,
) -> [N; 4] {
    let number = material as usize;
    witness.lanes(lanes);
    let attributes = &found.attributes;
    let at_pixels = NEEDS == needs::NORMALS
        || scene.shading.mode == ShadingMode::Phong
        || NEEDS == needs::ALL && scene.lit_at(number) == LitAt::Pixels;
    if at_pixels {
        let smooth = point.normal;
        let normal = shading_normal(scene, attributes, smooth, number, lanes);
        let point = SurfacePoint { normal, ..*point };
        let mut occlusion = Occlusion::NONE;
        if let (Some(shadows), Some((batch, own))) = (scene.shadows, occluded) {
            let samples =
                SeenSamples { ids: &batch.ids, lanes, position: &|lane| batch.position(lane) };
            shadows.occlude(&samples, &found.weights, (&point, smooth), own);
            occlusion = own.occlusion();
        }
        let of = (number, lanes);
        lit::<N, W, NEEDS>(scene, attributes, &point, of, occlusion, witness)
    } else {
        lit_elsewhere::<N, W, NEEDS>(scene, attributes, point, number, lanes, witness)
    }
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
    simd.vectorized(
        #[inline(always)]
        || {
            let wanted = Wanted {
                position: scene.needs_positions,
                normal: true,
                light: scene.shading.mode == ShadingMode::Gouraud,
            };
            cache.setup.begin_tile(batch.tile);
            let setup = &mut cache.setup;
            found.interpolate::<{ needs::ALL }>(
                simd,
                scene,
                batch,
                setup,
                (seen, wanted),
                materials,
            );
            if is_studied(&scene.shading) {
                study(scene, batch, cache, seen, found);
            }
            if scene.shadows.is_some() && scene.shading.mode != ShadingMode::Phong {
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
) {
    simd.vectorized(
        #[inline(always)]
        || {
            setup.begin_tile(batch.tile);
            let materials = &mut [0; LANES];
            let wanted = (seen, wanted);
            found.interpolate::<{ needs::PLACES }>(simd, scene, batch, setup, wanted, materials);
        },
    );
}

/// Whether light is computed elsewhere than at pixels and corners, or attributes are interpolated in the
/// window.
#[inline(always)]
pub(crate) fn is_studied(shading: &Shading) -> bool {
    matches!(shading.mode, ShadingMode::Flat | ShadingMode::Subdivided { .. })
        || shading.interpolation != Interpolation::Perspective
}

/// Interpolation in the window, and light of whole polygons and of pieces: sample by sample.
#[cold]
#[inline(never)]
fn study<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    found: &mut Fragments<N>,
) {
    for lane in lanes_of(seen) {
        let Some(triangle) = cache.lit.get(scene, TriangleId(batch.ids[lane])) else { continue };
        let weights = found.weights.map(|weight| weight.lane(lane));
        if scene.shading.interpolation != Interpolation::Perspective {
            found.attributes.put_lane(lane, &triangle.in_window(batch.position(lane), weights));
        }
        let number = triangle.material as usize;
        let texel = || match scene.lit_at(number) {
            LitAt::PiecesUnderTexels => {
                base_texel(scene, &found.attributes, number, 1 << lane).lane(lane)
            }
            LitAt::Pixels | LitAt::Elsewhere => [1.0; 3],
        };
        if let Some(light) = triangle.own_light(weights, texel) {
            found.attributes.put_light(lane, light);
        }
    }
}

/// Shadows on light that was computed elsewhere: sample by sample.
#[cold]
#[inline(never)]
fn shadow<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    found: &mut Fragments<N>,
) {
    for lane in lanes_of(seen) {
        let id = TriangleId(batch.ids[lane]);
        let Some(triangle) = cache.lit.get(scene, id) else { continue };
        let number = triangle.material as usize;
        if scene.lit_at(number) == LitAt::Pixels {
            continue;
        }
        let weights = found.weights.map(|weight| weight.lane(lane));
        let places = triangle.lit_at(weights, batch.position(lane));
        let texel = base_texel(scene, &found.attributes, number, 1 << lane).lane(lane);
        let position = batch.position(lane);
        let visible = VisibleLights::of(scene, id, (weights, position), &places);
        let light = visible.and_then(|visible| visible.light(scene, triangle, &places, texel));
        if let Some(light) = light {
            found.attributes.put_light(lane, light);
        }
    }
}

/// Draws edges of polygons over their faces: an edge covers the pixels within half its width, and fades
/// over one pixel more.
#[cold]
#[inline(never)]
fn draw_edges<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    seen: u32,
    mut colors: [N; 4],
) -> [N; 4] {
    let Some(edges) = scene.edges else { return colors };
    let simd = colors[0];
    simd.vectorized(
        #[inline(always)]
        || {
            let [tile_x, tile_y] = batch.tile;
            let (x, y) = (simd.load(&batch.x, 0).to_f64(), simd.load(&batch.y, 0).to_f64());
            let (x, y) = (x + x.constant(tile_x.into()), y + y.constant(tile_y.into()));
            let mut left = seen;
            while left != 0 {
                let id = batch.ids[left.trailing_zeros() as usize & (LANES - 1)];
                let lanes = simd.eq_mask(&batch.ids, id) & left;
                left &= !lanes;
                let Some(of) = scene.frame.triangle(TriangleId(id)) else { continue };
                let Some(flags) = scene.edge_flags[of.instance] else { continue };
                let distance = edge_distance(&scene.frame.forms(of), flags.of(of.triangle), x, y);
                let half = simd.constant(edges.width * 0.5 + 0.5);
                let cover = (half - distance).clamped(0.0, 1.0);
                let mask = simd.mask_of(lanes);
                for (color, edge) in colors.iter_mut().zip(edges.color) {
                    let over = *color + (simd.constant(edge) - *color) * cover;
                    *color = over.select(mask, *color);
                }
            }
            colors
        },
    )
}
