//! What the equation takes of a material: each k O, brought within bounds once.

use crate::{Material, Reflectance, Reflection};
use luxel_math::{Number, Rgb};

/// Coefficients of reflection beyond this are taken as this, so that no product overflows.
const COEFFICIENT_LIMIT: f32 = 1e8;

/// What a surface reflects and sends, whatever its normal and whoever looks: each coefficient times
/// its colour, not negative, not huge, not NaN.
///
/// Of a material without textures it is the same at all its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<N> {
    /// O_e; k_d O_d of a surface that isn't lit; in a mix, both.
    pub(crate) own: Rgb<N>,
    /// k_a O_a, occluded.
    pub(crate) ambient: Rgb<N>,
    /// k_d O_d
    pub(crate) diffuse: Rgb<N>,
    /// k_s O_s
    pub(crate) specular: Rgb<N>,
    /// O_d of a microfacet surface, within 0 and 1.
    pub(crate) base: Rgb<N>,
    /// n
    pub(crate) shininess: N,
    /// Within 0 and 1.
    pub(crate) metallic: N,
    /// Within 0 and 1.
    pub(crate) roughness: N,
    /// Within 0 and 1.
    pub(crate) occlusion: N,
}

impl<N: Number> Coefficients<N> {
    /// Of what textures and vertex colours made of a material.
    #[inline(always)]
    pub fn new(reflectance: &Reflectance<N>, material: &Material) -> Self {
        let occlusion = reflectance.occlusion.limited(0.0, 1.0);
        let diffuse = coefficient(reflectance.diffuse, material.k_d);
        Self {
            own: own_light(diffuse, reflectance.emission, &material.reflection),
            ambient: coefficient(reflectance.ambient, material.k_a) * occlusion,
            diffuse,
            specular: coefficient(reflectance.specular, material.k_s),
            base: limited(reflectance.diffuse, 1.0),
            shininess: reflectance.shininess.limited(0.0, 1e9),
            metallic: reflectance.metallic.limited(0.0, 1.0),
            roughness: reflectance.roughness.limited(0.0, 1.0),
            occlusion,
        }
    }
}

impl Coefficients<f32> {
    /// The same in every lane; `like` tells only the kind of number.
    #[inline(always)]
    #[must_use]
    pub fn in_lanes<N: Number>(&self, like: N) -> Coefficients<N> {
        Coefficients {
            own: Rgb::splat(like, self.own.lane(0)),
            ambient: Rgb::splat(like, self.ambient.lane(0)),
            diffuse: Rgb::splat(like, self.diffuse.lane(0)),
            specular: Rgb::splat(like, self.specular.lane(0)),
            base: Rgb::splat(like, self.base.lane(0)),
            shininess: like.constant(self.shininess),
            metallic: like.constant(self.metallic),
            roughness: like.constant(self.roughness),
            occlusion: like.constant(self.occlusion),
        }
    }
}

/// k O, not negative, not huge, not NaN.
#[inline(always)]
fn coefficient<N: Number>(color: Rgb<N>, k: f32) -> Rgb<N> {
    limited(color * color.r.constant(k), COEFFICIENT_LIMIT)
}

/// A colour within 0 and `high`; 0 for NaN.
#[inline(always)]
pub(crate) fn limited<N: Number>(color: Rgb<N>, high: f32) -> Rgb<N> {
    Rgb::new(color.r.limited(0.0, high), color.g.limited(0.0, high), color.b.limited(0.0, high))
}

/// What the surface sends of its own: O_e. If it isn't lit, k_d O_d instead; in a mix, both.
#[inline(always)]
fn own_light<N: Number>(diffuse: Rgb<N>, emission: Rgb<N>, reflection: &Reflection) -> Rgb<N> {
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
