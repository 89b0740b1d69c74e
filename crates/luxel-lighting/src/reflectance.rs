//! The reflectance of a surface at a point: its material, modulated by textures.

use crate::coefficients::limited;
use crate::{Coefficients, Material, Reflection, Uniform};
use luxel_math::{Lanes, Rgb};

/// Coefficients of reflection beyond this are taken as this, so that no product overflows.
const COEFFICIENT_LIMIT: f32 = 1e8;

/// A [`Material`] modulated by textures and vertex colours at one point.
///
/// The equation takes these in the place of the material's own; k_a, k_d and k_s it takes from the
/// material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflectance<N> {
    /// O_a
    pub ambient: Rgb<N>,
    /// O_d; the base colour of a microfacet material.
    pub diffuse: Rgb<N>,
    /// O_s
    pub specular: Rgb<N>,
    /// O_e
    pub emission: Rgb<N>,
    /// n: the exponent of the highlight.
    pub shininess: N,
    /// 0 for dielectrics, 1 for metals.
    pub metallic: N,
    /// Perceptual roughness, 0 to 1.
    pub roughness: N,
    /// How much of the ambient light and of the environment reaches the point, 0 to 1.
    pub occlusion: N,
}

impl<N: Lanes> Reflectance<N> {
    /// The material's own constants, nowhere occluded; `simd` selects the lane type.
    #[inline(always)]
    pub fn of(simd: N, material: &Material) -> Self {
        Self {
            ambient: Rgb::splat(simd, material.ambient.unwrap_or(material.diffuse)),
            diffuse: Rgb::splat(simd, material.diffuse),
            specular: Rgb::splat(simd, material.specular),
            emission: Rgb::splat(simd, material.emission),
            shininess: simd.constant(material.shininess),
            metallic: simd.constant(material.metallic),
            roughness: simd.constant(material.roughness),
            occlusion: simd.one(),
        }
    }

    /// The same with O_d multiplied by `color`, and O_a too where the material's ambient colour is
    /// that of its diffuse reflection.
    #[inline(always)]
    #[must_use]
    pub fn times_base_color(mut self, color: Rgb<N>, material: &Material) -> Self {
        self.diffuse = self.diffuse * color;
        if material.ambient.is_none() {
            self.ambient = self.ambient * color;
        }
        self
    }
}

impl<N: Lanes> Coefficients<N> {
    /// The coefficients of a textured material.
    #[inline(always)]
    pub fn new(reflectance: &Reflectance<N>, material: &Material) -> Self {
        let occlusion = reflectance.occlusion.clamped(0.0, 1.0);
        let diffuse = coefficient(reflectance.diffuse, material.k_d);
        Self {
            emitted: emitted_light(diffuse, reflectance.emission, &material.reflection),
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
    /// The coefficients of a material without textures.
    #[must_use]
    pub fn uniform(material: &Material) -> Self {
        let of = Coefficients::new(&Reflectance::of(0.0, material), material);
        let rgb = |Rgb { r, g, b }| Rgb::new(Uniform(r), Uniform(g), Uniform(b));
        Self {
            emitted: rgb(of.emitted),
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

/// k O, not negative, not huge, not NaN.
#[inline(always)]
fn coefficient<N: Lanes>(color: Rgb<N>, k: f32) -> Rgb<N> {
    limited(color * color.r.constant(k), COEFFICIENT_LIMIT)
}

/// The emitted light: O_e. For an unlit model, k_d O_d instead; in a mixture, both.
#[inline(always)]
fn emitted_light<N: Lanes>(diffuse: Rgb<N>, emission: Rgb<N>, reflection: &Reflection) -> Rgb<N> {
    match reflection {
        Reflection::Unlit => diffuse,
        Reflection::Mixed(_) => {
            let mut emitted = limited(emission, COEFFICIENT_LIMIT);
            for index in 0..reflection.part_count() {
                if let (Reflection::Unlit, weight) = reflection.part(index) {
                    emitted = emitted + diffuse * diffuse.r.constant(weight);
                }
            }
            emitted
        }
        _ => limited(emission, COEFFICIENT_LIMIT),
    }
}
