//! Highlights as a power of a cosine.

use super::{Incidence, Reflected, Surface, any_lit, lambert};
use crate::{Broadcast, Lobe};
use luxel_math::{Lanes, Rgb, elementary};

/// The powers of a cosine that a highlight is made of.
pub(crate) enum Highlight<N> {
    /// max(c, 0)
    Cosine(N),
    /// max(c, 0)^2
    Square(N),
}

/// Lambert's diffuse reflection and the highlight k_s O_s max(c, 0)^n, the latter only where
/// N.L > 0. `cosine` is c as it is.
#[inline(always)]
pub(crate) fn with_lobe<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
    cosine: N,
    highlight: Highlight<N>,
) -> Reflected<N> {
    let lobe = if any_lit(incidence) {
        let shininess = surface.of.shininess;
        let (base, exponent) = match highlight {
            Highlight::Cosine(cosine) => (cosine, shininess),
            Highlight::Square(square) => (square, shininess * 0.5),
        };
        elementary::power_of_one_exponent(base, exponent)
            .masked(cosine.zero().less(incidence.n_dot_l))
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
