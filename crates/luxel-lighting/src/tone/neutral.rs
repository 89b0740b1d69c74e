//! Khronos PBR Neutral (*PBR Neutral Specification*, Khronos, 2024).
//!
//! A base colour seen under white light of its own brightness is shown as it is: the curve takes the
//! highlight of a dielectric, F90 = 0.04, off all three channels, leaves what is then below K_s = 0.76 as
//! it is, and compresses and desaturates what is beyond.

use luxel_math::{Lanes, Rgb};

/// F90 of the specification: what a dielectric of index 1.5 mirrors of the light in front of it.
const F90: f32 = 0.04;
/// K_s: where compression begins.
const START: f32 = 0.8 - F90;
/// K_d: how fast bright colours fade to white.
const DESATURATION: f32 = 0.15;

/// The curve of a colour that is not negative.
#[inline(always)]
pub(super) fn curve<N: Lanes>(color: Rgb<N>) -> Rgb<N> {
    let Rgb { r, g, b } = color;
    let simd = r;
    let one = simd.one();
    let least = r.minimum(g).minimum(b);
    let is_dark = least.less_or_equal(simd.constant(2.0 * F90));
    let toe = least - least * least * simd.constant(1.0 / (4.0 * F90));
    let offset = toe.select(is_dark, simd.constant(F90));
    let (r, g, b) = (r - offset, g - offset, b - offset);
    let peak = r.maximum(g).maximum(b);
    let is_plain = peak.less_or_equal(simd.constant(START));
    // Where the colour is plain, a peak that no division minds.
    let peak = one.select(is_plain, peak);
    let room = 1.0 - START;
    let compressed = one - simd.constant(room * room) / (peak + simd.constant(1.0 - 2.0 * START));
    let kept = one / (simd.constant(DESATURATION) * (peak - compressed) + one);
    let scale = compressed / peak * kept;
    let white = compressed * (one - kept);
    Rgb::new(
        r.select(is_plain, r * scale + white),
        g.select(is_plain, g * scale + white),
        b.select(is_plain, b * scale + white),
    )
}
