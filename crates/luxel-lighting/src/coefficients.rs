//! The material coefficients of the equation: each k O, clamped once.
//!
//! Where textures change it, it comes in lanes; else it is one value for all points of the
//! material, broadcast to the lanes where it is used: sixteen values of everything would be more
//! than there are registers.

use luxel_math::{Lanes, Rgb};

/// The direction-independent part of reflection and emission: each coefficient times
/// its colour, not negative, not huge, not NaN.
///
/// Of a material without textures it is the same at all its points: `Coefficients<Uniform>`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<K> {
    /// O_e; k_d O_d of a surface that isn't lit; in a mix, both.
    pub(crate) emitted: Rgb<K>,
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

/// A value for each lane, or [one for all](Uniform).
pub trait Broadcast<N: Lanes>: Copy {
    /// The value in every lane; `simd` selects the lane type.
    fn broadcast(self, simd: N) -> N;
}

/// One value for all lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform(pub f32);

impl<N: Lanes> Broadcast<N> for Uniform {
    #[inline(always)]
    fn broadcast(self, simd: N) -> N {
        simd.constant(self.0)
    }
}

impl<N: Lanes> Broadcast<N> for N {
    #[inline(always)]
    fn broadcast(self, _: N) -> N {
        self
    }
}

/// A colour in every lane.
#[inline(always)]
pub(crate) fn broadcast<N: Lanes, K: Broadcast<N>>(color: Rgb<K>, simd: N) -> Rgb<N> {
    Rgb::new(color.r.broadcast(simd), color.g.broadcast(simd), color.b.broadcast(simd))
}

/// A colour within 0 and `high`; 0 for NaN.
#[inline(always)]
pub(crate) fn limited<N: Lanes>(color: Rgb<N>, high: f32) -> Rgb<N> {
    Rgb::new(color.r.clamped(0.0, high), color.g.clamped(0.0, high), color.b.clamped(0.0, high))
}
