//! The kinds of reflection: which part of a light's intensity a surface sends to the eye.
//!
//! A model gives two factors for each light, one for I_d and one for I_s, without the light's own
//! attenuation; the equation does the rest. No hidden factors: where physics has a BRDF f, the
//! factor is pi f (N.L), so that a white Lambert surface facing a light of intensity 1 sends 1.
//!
//! Each model has a file with its formula and its [`ReflectionModel`]: its name, help, its
//! parameters, and the factors of its terms. Flags, scene files, sliders, `explain` and the
//! documents read them from [`REFLECTION_MODELS`].

mod blinn_phong;
mod description;
mod highlight;
mod lambert;
mod microfacet;
mod mirror;
mod oren_nayar;
mod phong;
mod retro;
mod surface;
mod toon;
mod unlit;
mod vocabulary;

use crate::Broadcast;
use crate::reflection::highlight::Highlight;
use luxel_math::Lanes;

pub use description::{
    HighlightVector, ModelFactor, NOT_METAL, OwnParameter, Quantity, ReflectionModel, Symbol,
};
use surface::any_lit;
pub(crate) use surface::{Incidence, Reflected, Surface};
pub use vocabulary::{own_parameters, parameters};

/// All models but the mix, in the order of lists.
pub static REFLECTION_MODELS: &[&ReflectionModel] = &[
    &unlit::MODEL,
    &lambert::MODEL,
    &oren_nayar::MODEL,
    &phong::MODEL,
    &blinn_phong::MODEL,
    &toon::MODEL,
    &microfacet::MODEL,
    &mirror::MODEL,
    &retro::MODEL,
];

/// How a surface reflects.
///
/// Of a `u8`, so that kernels read which one, block by block, instead of finding out from what a mix has.
#[derive(Clone, Debug, PartialEq)]
#[repr(u8)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// Diffuse and k_s (N.H)^n in steps (after Lake et al. 2000).
    Toon {
        /// How many; whole, 1 to 64.
        steps: f32,
    },
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
    /// A weighted sum of models; mixes among them are dissolved into their parts. One part of weight 1 is
    /// that model itself, with its ambient light, emission and environment.
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
        match simple.pop() {
            Some((only, 1.0)) if simple.is_empty() => only,
            last => {
                simple.extend(last);
                Self::Mixed(simple)
            }
        }
    }

    /// The description of the model; `None` for a mix.
    #[must_use]
    pub fn model(&self) -> Option<&'static ReflectionModel> {
        Some(match self {
            Self::Unlit => &unlit::MODEL,
            Self::Lambert => &lambert::MODEL,
            Self::OrenNayar => &oren_nayar::MODEL,
            Self::Phong => &phong::MODEL,
            Self::BlinnPhong => &blinn_phong::MODEL,
            Self::Toon { .. } => &toon::MODEL,
            Self::Microfacet => &microfacet::MODEL,
            Self::Mirror => &mirror::MODEL,
            Self::Retro => &retro::MODEL,
            Self::Mixed(_) => return None,
        })
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

impl<N: Lanes, K: Broadcast<N>> Surface<'_, N, K> {
    /// Models that are a cosine, or a power of one; `None` for all others.
    #[inline(always)]
    pub(super) fn by_cosines(
        &self,
        kind: &Reflection,
        incidence: &Incidence<N>,
    ) -> Option<Reflected<N>> {
        let of_cosine = |cosine: N| (cosine, Highlight::Cosine(cosine.clamped(0.0, 1.0)));
        let (cosine, highlight) = match kind {
            Reflection::Lambert => {
                let diffuse = lambert::diffuse(self, incidence);
                return Some(Reflected { diffuse, ..Reflected::nothing(self.simd()) });
            }
            // One power for the three: code of lanes is long, and the compiler's time dear.
            Reflection::Phong => of_cosine(phong::r_dot_v(self, incidence)),
            Reflection::BlinnPhong => {
                let (cosine, square) = blinn_phong::n_dot_h(self, incidence);
                (cosine, Highlight::Square(square))
            }
            Reflection::Retro => of_cosine(self.view.dot(incidence.to_light)),
            _ => return None,
        };
        Some(highlight::with_lobe(self, incidence, cosine, highlight))
    }

    #[inline(always)]
    pub(super) fn part_reflected(
        &self,
        kind: &Reflection,
        incidence: &Incidence<N>,
    ) -> Reflected<N> {
        match kind {
            Reflection::OrenNayar => oren_nayar::reflected(self, incidence),
            Reflection::Toon { steps } => toon::reflected(self, incidence, *steps),
            Reflection::Microfacet => microfacet::reflected(self, incidence),
            // A mirror sends a light to the eye from single points only, of no extent. A mix within
            // a mix has no meaning here: `Reflection::mixed` dissolves it.
            _ => match self.by_cosines(kind, incidence) {
                Some(part) => part,
                None => Reflected::nothing(self.simd()),
            },
        }
    }
}
