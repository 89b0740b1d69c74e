//! Colours of a batch: put together from its materials', the background behind them, and what is drawn over them.

use super::display::displayed;
use super::studied::draw_edges;
use crate::context::ShadingContext;
use crate::interpolate::Batch;
use luxel_math::{LANES, Lanes};

/// The background in all lanes.
#[inline(always)]
pub(super) fn background<N: Lanes>(simd: N, scene: &ShadingContext<'_>) -> [N; 4] {
    let [r, g, b, alpha] = scene.background;
    [simd.constant(r), simd.constant(g), simd.constant(b), simd.constant(alpha)]
}

/// One colour in the lanes whose bit is set, another elsewhere.
#[inline(always)]
pub(super) fn color_where<N: Lanes>(simd: N, lanes: u32, color: [N; 4], other: [N; 4]) -> [N; 4] {
    let mask = simd.mask_of(lanes);
    let ([r, g, b, alpha], [other_r, other_g, other_b, other_alpha]) = (color, other);
    [
        r.select(mask, other_r),
        g.select(mask, other_g),
        b.select(mask, other_b),
        alpha.select(mask, other_alpha),
    ]
}

/// The colours of a batch, from those of the lanes that see one material; the background's in other lanes than `seen`.
#[inline(always)]
pub(super) fn by_material<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    (materials, seen): (&[u32; LANES], u32),
    mut color_of: impl FnMut((u32, u32)) -> [N; 4],
) -> [N; 4] {
    let mut result = background(simd, scene);
    let mut left = seen;
    while left != 0 {
        let number = materials[left.trailing_zeros() as usize & (LANES - 1)];
        let lanes = left & simd.eq_mask(materials, number);
        let color = color_of((number, lanes));
        if lanes == simd.all_lanes() {
            return color;
        }
        result = color_where(simd, lanes, color, result);
        left &= !lanes;
    }
    result
}

/// Finishes the colours of a batch: exposure and tone curve of the surfaces alone, then edges over them.
#[inline(always)]
pub(super) fn finished<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    seen: u32,
    mut color: [N; 4],
) -> [N; 4] {
    if let Some(display) = &scene.display {
        // A copy, here and below, because the calls need their arguments in memory, and only there.
        let copy = color;
        color = color_where(simd, seen, displayed(display, &copy), color);
    }
    if scene.edges.is_some() {
        let copy = color;
        return draw_edges(scene, batch, seen, copy);
    }
    color
}
