//! Torrance-Sparrow reflection with GGX facets: glTF's metallic-roughness material.

use super::description::{COSINE, NOT_METAL};
use super::{
    HighlightVector, Incidence, ModelFactor, Quantity, Reflected, Reflection, ReflectionModel,
    Surface, Symbol, any_lit,
};
use crate::coefficients::broadcast;
use crate::parameter::{K_A, K_D, K_S, METALLIC, ROUGHNESS};
use crate::{Broadcast, Lobe};
use luxel_math::{Lanes, Rgb};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Microfacet,
    name: "microfacet",
    help: "metals and plastics as glTF has them: GGX facets, mirroring the environment",
    formula: "k_d O_d (1 - F) (1 - metallic) max(N.L, 0) + k_s O_s pi D V F max(N.L, 0)",
    source: "glTF 2.0, appendix B; Torrance and Sparrow 1967",
    parameters: &[&K_A, &K_D, &K_S, &ROUGHNESS, &METALLIC],
    own: &[],
    highlight: Some(HighlightVector::Halfway),
    diffuse: &[NOT_MIRRORED, NOT_METAL, COSINE],
    specular: Some(&[PI_D, VISIBILITY, FRESNEL, COSINE]),
};

const NOT_MIRRORED: ModelFactor = ModelFactor {
    symbol: Symbol::new(
        "(1 - F)",
        "(1 - F)",
        "(1 − F)",
        "1 - F: the share of the light that the surface doesn't mirror",
    ),
    quantity: Quantity::Color(None, |lobe| fresnel_of(lobe).map(|f| 1.0 - f)),
};

const PI_D: ModelFactor = ModelFactor {
    symbol: Symbol::new("pi D", r"\pi D", "π D", "pi D: how many microfacets face H, times pi"),
    quantity: Quantity::Number("pi_d", |lobe| match *lobe {
        Lobe::Facets { pi_d, .. } => pi_d,
        _ => 0.0,
    }),
};

const VISIBILITY: ModelFactor = ModelFactor {
    symbol: Symbol::new(
        "V",
        "V",
        "V",
        "V: the visibility of the microfacets, which shade and hide one another",
    ),
    quantity: Quantity::Number("visibility", |lobe| match *lobe {
        Lobe::Facets { visibility, .. } => visibility,
        _ => 0.0,
    }),
};

const FRESNEL: ModelFactor = ModelFactor {
    symbol: Symbol::new(
        "F",
        "F",
        "F",
        "F: Fresnel's reflectance, the share of the light that the surface mirrors",
    ),
    quantity: Quantity::Color(Some("fresnel"), fresnel_of),
};

fn fresnel_of(lobe: &Lobe<f32>) -> [f32; 3] {
    match lobe {
        Lobe::Facets { fresnel, .. } => fresnel.lane(0),
        _ => [0.0; 3],
    }
}

/// F0 of dielectrics: an index of refraction of 1.5 (glTF 2.0, appendix B.3.4).
const DIELECTRIC: f32 = 0.04;
/// alpha isn't below this (a perceptual roughness of 0.0447): a smaller highlight would drown in
/// the rounding of N.H, and shine in no sample.
const SMALLEST_ALPHA: f32 = 0.002;
/// N.V isn't below this: vertex normals may turn away from the eye where the face doesn't.
const SMALLEST_N_DOT_V: f32 = 1e-4;

/// glTF 2.0, appendix B.3.5, with the light's cosine and times pi:
///
/// - diffuse: (1 - F) (1 - metallic) k_d O_d (N.L)
/// - specular: k_s O_s pi D V F (N.L)
///
/// with alpha = roughness^2 (not below 0.002) and H = (L + V) / |L + V|:
///
/// - D = alpha^2 / (pi ((N.H)^2 (alpha^2 - 1) + 1)^2), the distribution GGX (Walter et al. 2007,
///   Trowbridge and Reitz 1975);
/// - V = 1 / (2 ((N.L) sqrt((N.V)^2 (1 - alpha^2) + alpha^2) + (N.V) sqrt((N.L)^2 (1 - alpha^2) +
///   alpha^2))), Smith's masking and shadowing, correlated by height (Heitz 2014), over
///   4 (N.L) (N.V);
/// - F = F0 + (1 - F0) (1 - V.H)^5, Fresnel's reflectance (Schlick 1994), F0 between 0.04 and O_d by
///   metallic.
///
/// Outlined, one copy per SIMD level: within the loop over lights the compiler would work out what is
/// the same for all of them beforehand, for the other models, too.
#[inline(never)]
pub(crate) fn reflected<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> Reflected<N> {
    surface.simd().vectorized(
        #[inline(always)]
        || by_facets(surface, incidence),
    )
}

#[inline(always)]
fn by_facets<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> Reflected<N> {
    let simd = surface.simd();
    let half = (incidence.to_light + surface.view).normalized_or_zero();
    let n_dot_h = surface.normal.dot(half);
    if !any_lit(incidence) {
        return Reflected {
            diffuse: Rgb::black(simd),
            specular: Rgb::black(simd),
            specular_cosine: Some(n_dot_h),
            lobe: Lobe::Plain,
        };
    }
    let n_dot_l = incidence.n_dot_l.clamped(0.0, 1.0);
    let n_dot_v = surface.n_dot_v().clamped(SMALLEST_N_DOT_V, 1.0);
    let v_dot_h = surface.view.dot(half).clamped(0.0, 1.0);
    let alpha = (surface.roughness() * surface.roughness()).maximum(simd.constant(SMALLEST_ALPHA));
    let alpha2 = alpha * alpha;

    // (N.H)^2 (alpha^2 - 1) + 1 without the cancellation: 1 - (N.H)^2 = |N x H|^2.
    let aside = surface.normal.cross(half);
    let width = aside.dot(aside) + n_dot_h * n_dot_h * alpha2;
    let pi_d = alpha2 / (width * width).maximum(simd.constant(f32::MIN_POSITIVE));
    let pi_d = pi_d
        .minimum(simd.one() / alpha2)
        .masked(simd.zero().less(n_dot_h) & simd.zero().less(n_dot_l));

    let rest = simd.one() - alpha2;
    let masking = n_dot_l * (n_dot_v * n_dot_v * rest + alpha2).sqrt();
    let shadowing = n_dot_v * (n_dot_l * n_dot_l * rest + alpha2).sqrt();
    let visibility = simd.constant(0.5) / (masking + shadowing);

    let f0 = facing_reflectance(surface);
    let white = Rgb::new(simd.one(), simd.one(), simd.one());
    let away = simd.one() - v_dot_h;
    let away2 = away * away;
    let fresnel = f0 + (white - f0) * (away2 * away2 * away);

    Reflected {
        diffuse: surface.diffuse()
            * (white - fresnel)
            * ((simd.one() - surface.metallic()) * n_dot_l),
        specular: surface.specular() * fresnel * (pi_d * visibility * n_dot_l),
        specular_cosine: Some(n_dot_h),
        lobe: Lobe::Facets { pi_d, visibility, fresnel },
    }
}

/// F0: 0.04 for dielectrics, O_d for metals.
#[inline(always)]
pub(crate) fn facing_reflectance<N: Lanes, K: Broadcast<N>>(surface: &Surface<'_, N, K>) -> Rgb<N> {
    let simd = surface.simd();
    Rgb::splat(simd, [DIELECTRIC; 3]) * (simd.one() - surface.metallic())
        + broadcast(surface.of.base, simd) * surface.metallic()
}
