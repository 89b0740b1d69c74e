//! The point that is lit, and what its surface reflects.

use crate::Material;
use luxel_math::{Lanes, Rgb, Vec3};

/// A point of a surface, as the equation wants it.
///
/// World directions, with the eye as the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint<N> {
    /// Where it lies, relative to the eye.
    pub position: Vec3<N>,
    /// N: the normal of the side that is seen, of unit length.
    pub normal: Vec3<N>,
    /// V: towards the eye, of unit length; against the viewing direction for parallel projections.
    pub view: Vec3<N>,
    /// The distance from the eye along the viewing axis, which fog goes by.
    pub depth: N,
}

/// What textures and vertex colours made of a [`Material`] at one point.
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
