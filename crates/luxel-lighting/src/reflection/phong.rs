//! Highlights as a power of a cosine: Phong, Blinn-Phong, and back to the light.

use super::{Incidence, Reflected, Surface, any_lit, lambert};
use crate::Spread;
use crate::witness::Lobe;
use luxel_math::{Lanes, Rgb, elementary};

/// R.V with R = 2 N (N.L) - L, the direction of mirroring (Phong, *Illumination for Computer
/// Generated Pictures*, 1975), which is 2 (N.L) (N.V) - L.V.
#[inline(always)]
pub(crate) fn r_dot_v<N: Lanes, K: Spread<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> N {
    let n_dot_l = incidence.n_dot_l;
    (n_dot_l + n_dot_l) * surface.n_dot_v() - incidence.to_light.dot(surface.view)
}

/// (N.H, (N.H)^2) with H = (L + V) / |L + V|, the normal that would mirror the light into the eye
/// (Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, 1977); the square is 0 where
/// N.H < 0.
///
/// The highlight takes the square, which needs no root: (N.(L + V))^2 / |L + V|^2. H is summed by its
/// components: from dot products, |L + V|^2 = 2 + 2 L.V would cancel where the light is behind.
#[inline(always)]
pub(crate) fn n_dot_h<N: Lanes, K: Spread<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> (N, N) {
    let half = incidence.to_light + surface.view;
    let squared_length = half.dot(half);
    let sound = squared_length.zero().less(squared_length);
    let scale = (half.x.one() / squared_length).masked(sound);
    let along = surface.normal.dot(half);
    let positive = along.positive_part();
    let square = (positive * positive * scale).minimum(along.one());
    (along * scale * squared_length.sqrt(), square)
}

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
pub(crate) fn with_lobe<N: Lanes, K: Spread<N>>(
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
