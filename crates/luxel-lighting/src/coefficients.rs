//! What the equation takes of a material: each k O, brought within bounds once.
//!
//! Where textures change it, it comes in lanes; else it is one value for all points of the material
//! and is spread over the lanes at the very place where it is used. Sixteen values of everything
//! would be more than there are registers.

use crate::{Material, Reflectance, Reflection};
use luxel_math::{Lanes, Rgb};

/// Coefficients of reflection beyond this are taken as this, so that no product overflows.
const COEFFICIENT_LIMIT: f32 = 1e8;

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

impl<N: Lanes> Coefficients<N> {
    /// Of what textures and vertex colours made of a material.
    #[inline(always)]
    pub fn new(reflectance: &Reflectance<N>, material: &Material) -> Self {
        let occlusion = reflectance.occlusion.clamped(0.0, 1.0);
        let diffuse = coefficient(reflectance.diffuse, material.k_d);
        Self {
            own: own_light(diffuse, reflectance.emission, &material.reflection),
            ambient: coefficient(reflectance.ambient, material.k_a) * occlusion,
            diffuse,
            specular: coefficient(reflectance.specular, material.k_s),
            base: limited(reflectance.diffuse, 1.0),
            shininess: material.shininess.clamped(0.0, 1e9),
            metallic: reflectance.metallic.clamped(0.0, 1.0),
            roughness: reflectance.roughness.clamped(0.0, 1.0),
            occlusion,
        }
    }
}

impl Coefficients<Uniform> {
    /// Of what a material reflects that has no textures.
    #[must_use]
    pub fn uniform(material: &Material) -> Self {
        let of = Coefficients::new(&Reflectance::of(0.0, material), material);
        let rgb = |Rgb { r, g, b }| Rgb::new(Uniform(r), Uniform(g), Uniform(b));
        Self {
            own: rgb(of.own),
            ambient: rgb(of.ambient),
            diffuse: rgb(of.diffuse),
            specular: rgb(of.specular),
            base: rgb(of.base),
            shininess: of.shininess,
            metallic: Uniform(of.metallic),
            roughness: Uniform(of.roughness),
            occlusion: Uniform(of.occlusion),
        }
    }
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

/// k O, not negative, not huge, not NaN.
#[inline(always)]
fn coefficient<N: Lanes>(color: Rgb<N>, k: f32) -> Rgb<N> {
    limited(color * color.r.constant(k), COEFFICIENT_LIMIT)
}

/// A colour within 0 and `high`; 0 for NaN.
#[inline(always)]
pub(crate) fn limited<N: Lanes>(color: Rgb<N>, high: f32) -> Rgb<N> {
    Rgb::new(color.r.clamped(0.0, high), color.g.clamped(0.0, high), color.b.clamped(0.0, high))
}

/// What the surface sends of its own: O_e. If it isn't lit, k_d O_d instead; in a mix, both.
#[inline(always)]
fn own_light<N: Lanes>(diffuse: Rgb<N>, emission: Rgb<N>, reflection: &Reflection) -> Rgb<N> {
    match reflection {
        Reflection::Unlit => diffuse,
        Reflection::Mixed(_) => {
            let mut own = limited(emission, COEFFICIENT_LIMIT);
            for index in 0..reflection.part_count() {
                if let (Reflection::Unlit, weight) = reflection.part(index) {
                    own = own + diffuse * diffuse.r.constant(weight);
                }
            }
            own
        }
        _ => limited(emission, COEFFICIENT_LIMIT),
    }
}
