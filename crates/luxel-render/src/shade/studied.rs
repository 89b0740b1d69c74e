//! What is there to be studied, sample by sample: light that is computed elsewhere than at pixels, attributes that are
//! interpolated in the window, and edges of polygons.

use super::shadowed::VisibleLights;
use super::thread_cache::ThreadCache;
use crate::context::{LitAt, ShadingContext};
use crate::coverage::edge_distance;
use crate::interpolate::{Batch, Fragments};
use crate::material::base_texel;
use luxel_math::{F64Lanes, LANES, Lanes, lanes_of};
use luxel_view::{Interpolation, Shading, ShadingMode};
use luxel_visibility::TriangleId;

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
pub(super) fn study<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    seen: u32,
    found: &mut Fragments<N>,
) {
    let Shading { mode, interpolation, .. } = scene.shading;
    if mode == ShadingMode::Flat && interpolation == Interpolation::Perspective {
        let simd = found.weights[0].zero();
        simd.vectorized(
            #[inline(always)]
            || {
                let of = (&batch.ids, seen);
                found.attributes.light =
                    cache.flat.of_lanes(simd.zero(), scene, of, &mut [0; LANES]);
            },
        );
        return;
    }
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
pub(super) fn shadow<N: Lanes>(
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
pub(super) fn draw_edges<N: Lanes>(
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
