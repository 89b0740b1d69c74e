//! Materials: the constants of reflection.

/// How a surface reflects.
#[derive(Clone, Debug, PartialEq)]
pub enum Reflection {
    /// Not at all: I = O_d k_d, the object's own intensity, whatever the lights.
    Unlit,
    /// Diffuse only: k_d (N.L).
    Lambert,
    /// Rough diffuse (Oren and Nayar 1994); `roughness` is the slope's standard deviation.
    OrenNayar,
    /// Diffuse and k_s (R.V)^n (Phong 1975).
    Phong,
    /// Diffuse and k_s (N.H)^n (Blinn 1977).
    BlinnPhong,
    /// Torrance-Sparrow with GGX, as glTF's metallic-roughness material.
    Microfacet,
    /// An ideal mirror of the environment.
    Mirror,
    /// Diffuse and a lobe back to the light: k_s max(V.L, 0)^n.
    Retro,
    /// A weighted sum of models, none of them a mix: [`Reflection::mixed`] sees to that.
    Mixed(Vec<(Self, f32)>),
}

impl Reflection {
    /// A weighted sum of models; mixes among them are dissolved into their parts.
    #[must_use]
    pub fn mixed(parts: Vec<(Self, f32)>) -> Self {
        let mut simple = Vec::with_capacity(parts.len());
        let mut rest: Vec<_> = parts.into_iter().rev().collect();
        while let Some((part, weight)) = rest.pop() {
            match part {
                Self::Mixed(inner) => {
                    rest.extend(inner.into_iter().rev().map(|(part, w)| (part, w * weight)));
                }
                simple_part => simple.push((simple_part, weight)),
            }
        }
        Self::Mixed(simple)
    }

    /// How many models are summed.
    #[inline(always)]
    pub(crate) fn part_count(&self) -> usize {
        match self {
            Self::Mixed(parts) => parts.len(),
            _ => 1,
        }
    }

    /// One of the models that are summed, with its weight, kept within 1e3.
    #[inline(always)]
    pub fn part(&self, index: usize) -> (&Self, f32) {
        match self {
            Self::Mixed(parts) => {
                let (part, weight) = &parts[index];
                (part, if weight.is_nan() { 0.0 } else { weight.clamp(-1e3, 1e3) })
            }
            simple => (simple, 1.0),
        }
    }
}

/// The constants of a surface's reflection; what textures and vertex colours multiply.
///
/// Colours are linear.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The model.
    pub reflection: Reflection,
    /// O_a; `None` means O_d, textures and vertex colours included.
    pub ambient: Option<[f32; 3]>,
    /// O_d; the base colour of a microfacet material.
    pub diffuse: [f32; 3],
    /// O_s.
    pub specular: [f32; 3],
    /// O_e: light of its own.
    pub emission: [f32; 3],
    /// k_a
    pub k_a: f32,
    /// k_d
    pub k_d: f32,
    /// k_s
    pub k_s: f32,
    /// n: the exponent of the highlight.
    pub shininess: f32,
    /// 0 for dielectrics, 1 for metals (microfacet).
    pub metallic: f32,
    /// Perceptual roughness, 0 to 1; alpha = roughness^2 (microfacet, Oren-Nayar).
    pub roughness: f32,
}

impl Default for Material {
    /// A warm light grey (sRGB 0.80, 0.78, 0.75), slightly glossy, for files that say nothing: form
    /// is read from shading alone.
    fn default() -> Self {
        Self {
            reflection: Reflection::BlinnPhong,
            ambient: None,
            diffuse: [0.603_827_4, 0.570_481_6, 0.522_521_5],
            specular: [1.0; 3],
            emission: [0.0; 3],
            k_a: 1.0,
            k_d: 1.0,
            k_s: 0.2,
            shininess: 32.0,
            metallic: 0.0,
            roughness: 1.0,
        }
    }
}
