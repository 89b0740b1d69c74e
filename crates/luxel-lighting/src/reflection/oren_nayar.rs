//! Diffuse reflection of rough surfaces.

use super::description::COSINE;
use super::{
    Incidence, ModelFactor, Quantity, Reflected, Reflection, ReflectionModel, Surface, Symbol,
};
use crate::parameter::{K_A, K_D, ROUGHNESS};
use crate::{Broadcast, Lobe};
use luxel_math::{Lanes, Rgb};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::OrenNayar,
    name: "oren-nayar",
    help: "rough and matt, as plaster: flatter than lambert",
    formula: "k_d O_d max(N.L, 0) (A + B max(q, 0) / max(N.L, N.V)), q = L.V - (N.L) (N.V)",
    source: "Oren and Nayar 1994",
    parameters: &[&K_A, &K_D, &ROUGHNESS],
    own: &[],
    highlight: None,
    diffuse: &[COSINE, ROUGH],
    specular: None,
};

const ROUGH: ModelFactor = ModelFactor {
    symbol: Symbol::new(
        "(A + B max(q, 0) / max(N.L, N.V))",
        r"\Bigl(A + B\,\tfrac{\max(q, 0)}{\max(\mathbf N\cdot\mathbf L,\,\mathbf N\cdot\mathbf V)}\Bigr)",
        "(A + B max(q, 0) / max(<b>N</b>·<b>L</b>, <b>N</b>·<b>V</b>))",
        "A + B max(q, 0) / max(N.L, N.V): how roughness changes the diffuse light; A and B depend on \
         it, q = V.L - (N.V) (N.L)",
    ),
    quantity: Quantity::Number("rough", |lobe| match *lobe {
        Lobe::Rough(factor) => factor,
        _ => 1.0,
    }),
};

/// k_d O_d (N.L) (A + B max(cos(phi_r - phi_i), 0) sin(alpha) tan(beta)) with
/// A = 1 - s^2 / (2 (s^2 + 0.33)), B = 0.45 s^2 / (s^2 + 0.09), s the standard deviation of the
/// slopes of Lambertian facets, alpha and beta the larger and the smaller of the angles of light
/// and eye to the normal (Oren and Nayar, *Generalization of Lambert's Reflectance Model*, 1994, the
/// qualitative model, without interreflection).
///
/// With q = L.V - (N.L)(N.V) = cos(phi_r - phi_i) sin(theta_r) sin(theta_i), the product of the
/// last three factors is max(q, 0) / max(N.L, N.V).
///
/// Outlined, one copy per SIMD level, as [`microfacet::reflected`](super::microfacet::reflected) is.
#[inline(never)]
pub(crate) fn reflected<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> Reflected<N> {
    surface.simd().vectorized(
        #[inline(always)]
        || roughly(surface, incidence),
    )
}

#[inline(always)]
fn roughly<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> Reflected<N> {
    let simd = surface.simd();
    let variance = surface.roughness() * surface.roughness();
    let a = simd.one() - variance * simd.constant(0.5) / (variance + simd.constant(0.33));
    let b = variance * simd.constant(0.45) / (variance + simd.constant(0.09));
    let n_dot_l = incidence.n_dot_l.positive_part();
    let n_dot_v = surface.n_dot_v().positive_part();
    let q = incidence.to_light.dot(surface.view) - n_dot_l * n_dot_v;
    // Where both cosines vanish, so does the whole; 1e-6 keeps the quotient finite.
    let slant = q.positive_part() / n_dot_l.maximum(n_dot_v).maximum(simd.constant(1e-6));
    let rough = a + b * slant;
    Reflected {
        diffuse: surface.diffuse() * (n_dot_l * rough),
        specular: Rgb::black(simd),
        specular_cosine: None,
        lobe: Lobe::Rough(rough),
    }
}
