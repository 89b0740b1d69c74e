//! Light in steps, as cartoons show it.

use super::{
    HighlightVector, Incidence, ModelFactor, OwnParameter, Quantity, Reflected, Reflection,
    ReflectionModel, Surface, Symbol, blinn_phong,
};
use crate::parameter::{K_A, K_D, K_S, Parameter, SHININESS};
use crate::{Broadcast, Lobe};
use luxel_math::{Lanes, elementary};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Toon { steps: STEPS.default },
    name: "toon",
    help: "diffuse light and highlight in steps, as cartoons show them",
    formula: "k_d O_d q(max(N.L, 0)) + k_s O_s q(max(N.H, 0)^n), \
              q(x) = floor(steps x + 1/2) / steps",
    source: "Lake et al. 2000, which is one step; the highlight of Blinn 1977",
    parameters: &[&K_A, &K_D, &K_S, &SHININESS],
    own: &[OwnParameter {
        parameter: STEPS,
        field: |reflection| match reflection {
            Reflection::Toon { steps } => Some(steps),
            _ => None,
        },
    }],
    highlight: Some(HighlightVector::Halfway),
    diffuse: &[ModelFactor {
        symbol: Symbol::new(
            "(floor(steps max(N.L, 0) + 1/2) / steps)",
            r"\tfrac{\lfloor\mathrm{steps}\,\max(\mathbf N\cdot\mathbf L,\,0) + 1/2\rfloor}{\mathrm{steps}}",
            "(⌊steps max(<b>N</b>·<b>L</b>, 0) + ½⌋ / steps)",
            "floor(steps max(N.L, 0) + 1/2) / steps: the cosine N.L in steps",
        ),
        quantity: Quantity::Number("stepped_diffuse", |lobe| match *lobe {
            Lobe::Factors { diffuse, .. } => diffuse,
            _ => 0.0,
        }),
    }],
    specular: Some(&[ModelFactor {
        symbol: Symbol::new(
            "(floor(steps max(N.H, 0)^n + 1/2) / steps)",
            r"\tfrac{\lfloor\mathrm{steps}\,\max(\mathbf N\cdot\mathbf H,\,0)^n + 1/2\rfloor}{\mathrm{steps}}",
            "(⌊steps max(<b>N</b>·<b>H</b>, 0)<sup><i>n</i></sup> + ½⌋ / steps)",
            "floor(steps max(N.H, 0)^n + 1/2) / steps: the highlight in steps",
        ),
        quantity: Quantity::Number("stepped_specular", |lobe| match *lobe {
            Lobe::Factors { specular, .. } => specular,
            _ => 0.0,
        }),
    }]),
};

const STEPS: Parameter = Parameter {
    name: "toon-steps",
    symbol: "steps",
    help: "how many steps toon shows diffuse light and highlight in, 1 to 64 [default: 3]",
    range: [1.0, 64.0],
    is_whole: true,
    slider_end: 8.0,
    default: 3.0,
    example: "2",
    placeholder: "N",
};

/// k_d O_d q(max(N.L, 0)) + k_s O_s q(max(N.H, 0)^n) with q(x) = floor(s x + 1/2) / s: the nearest of
/// s + 1 evenly spaced tones, black among them. The highlight is there only where N.L > 0.
///
/// With s = 1, diffuse light is that of Lake et al. (*Stylized Rendering Techniques for Scalable
/// Real-Time 3D Animation*, 2000): a texture of two texels, lit and in shadow, with N.L as
/// the coordinate. Rounding to the nearest tone keeps q(0) = 0 and q(1) = 1 and the mean brightness of
/// Lambert's and Blinn's terms.
///
/// Outlined, one copy per SIMD level, as [`microfacet::reflected`](super::microfacet::reflected) is.
#[inline(never)]
pub(crate) fn reflected<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
    steps: f32,
) -> Reflected<N> {
    surface.simd().vectorized(
        #[inline(always)]
        || in_steps(surface, incidence, STEPS.nearest(steps)),
    )
}

#[inline(always)]
fn in_steps<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
    steps: f32,
) -> Reflected<N> {
    let (cosine, square) = blinn_phong::n_dot_h(surface, incidence);
    let highlight = elementary::power_of_one_exponent(square, surface.of.shininess * 0.5)
        .masked(cosine.zero().less(incidence.n_dot_l));
    let diffuse = nearest_tone(incidence.n_dot_l, steps);
    let specular = nearest_tone(highlight, steps);
    Reflected {
        diffuse: surface.diffuse() * diffuse,
        specular: surface.specular() * specular,
        specular_cosine: Some(cosine),
        lobe: Lobe::Factors { diffuse, specular },
    }
}

/// floor(s x + 1/2) / s, x within 0 and 1.
#[inline(always)]
fn nearest_tone<N: Lanes>(x: N, steps: f32) -> N {
    let scaled = x.clamped(0.0, 1.0) * x.constant(steps) + x.constant(0.5);
    scaled.floor() / x.constant(steps)
}
