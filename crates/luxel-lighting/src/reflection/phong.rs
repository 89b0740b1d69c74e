//! Highlights as a power of a cosine: Phong, Blinn-Phong, and back to the light.

use super::{Incidence, Reflected, Surface, any_lit, lambert};
use crate::Spread;
use crate::witness::Lobe;
use luxel_math::{Number, Rgb, elementary};

/// R.V with R = 2 N (N.L) - L, the direction of mirroring (Phong, *Illumination for Computer
/// Generated Pictures*, 1975), which is 2 (N.L) (N.V) - L.V.
#[inline(always)]
pub(crate) fn r_dot_v<N: Number, K: Spread<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> N {
    let n_dot_l = incidence.n_dot_l;
    (n_dot_l + n_dot_l) * surface.n_dot_v() - incidence.to_light.dot(surface.view)
}

/// N.H with H = (L + V) / |L + V|, the normal that would mirror the light into the eye (Blinn,
/// *Models of Light Reflection for Computer Synthesized Pictures*, 1977).
#[inline(always)]
pub(crate) fn n_dot_h<N: Number, K: Spread<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> N {
    surface.normal.dot((incidence.to_light + surface.view).normalized_or_zero())
}

/// Lambert's diffuse reflection and the highlight k_s O_s max(c, 0)^n, the latter only where
/// N.L > 0.
#[inline(always)]
pub(crate) fn with_lobe<N: Number, K: Spread<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
    cosine: N,
) -> Reflected<N> {
    let lobe = if any_lit(incidence) {
        elementary::power(cosine.limited(0.0, 1.0), surface.of.shininess.spread(cosine))
            .only_where(cosine.zero().less(incidence.n_dot_l))
    } else {
        cosine.zero()
    };
    let specular: Rgb<N> = surface.specular() * lobe;
    Reflected {
        diffuse: lambert::diffuse(surface, incidence),
        specular,
        specular_cosine: Some(cosine),
        lobe: Lobe::Plain,
    }
}
