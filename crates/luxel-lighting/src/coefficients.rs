//! What the equation takes of a material: each k O, brought within bounds once.
//!
//! Where textures change it, it comes in lanes; else it is one value for all points of the material
//! and is spread over the lanes at the very place where it is used. Sixteen values of everything
//! would be more than there are registers.

use luxel_math::{Lanes, Rgb};

/// What a surface reflects and sends, whatever its normal and whoever looks: each coefficient times
/// its colour, not negative, not huge, not NaN.
///
/// Of a material without textures it is the same at all its points: `Coefficients<Uniform>`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<K> {
    /// O_e; k_d O_d of a surface that isn't lit; in a mix, both.
    pub(crate) own: Rgb<K>,
    /// k_a O_a, occluded.
    pub(crate) ambient: Rgb<K>,
    /// k_d O_d
    pub(crate) diffuse: Rgb<K>,
    /// k_s O_s
    pub(crate) specular: Rgb<K>,
    /// O_d of a microfacet surface, within 0 and 1.
    pub(crate) base: Rgb<K>,
    /// n, the same at all points of a material.
    pub(crate) shininess: f32,
    /// Within 0 and 1.
    pub(crate) metallic: K,
    /// Within 0 and 1.
    pub(crate) roughness: K,
    /// Within 0 and 1.
    pub(crate) occlusion: K,
}

/// What can be had in every lane: a value for each, or [one for all](Uniform).
pub trait Spread<N: Lanes>: Copy {
    /// It in every lane; `simd` selects the lane type.
    fn spread(self, simd: N) -> N;
}

/// One value for all lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform(pub f32);

impl<N: Lanes> Spread<N> for Uniform {
    #[inline(always)]
    fn spread(self, simd: N) -> N {
        simd.constant(self.0)
    }
}

impl<N: Lanes> Spread<N> for N {
    #[inline(always)]
    fn spread(self, _: N) -> N {
        self
    }
}

/// A colour in every lane.
#[inline(always)]
pub(crate) fn spread<N: Lanes, K: Spread<N>>(color: Rgb<K>, simd: N) -> Rgb<N> {
    Rgb::new(color.r.spread(simd), color.g.spread(simd), color.b.spread(simd))
}

/// A colour within 0 and `high`; 0 for NaN.
#[inline(always)]
pub(crate) fn limited<N: Lanes>(color: Rgb<N>, high: f32) -> Rgb<N> {
    Rgb::new(color.r.clamped(0.0, high), color.g.clamped(0.0, high), color.b.clamped(0.0, high))
}
