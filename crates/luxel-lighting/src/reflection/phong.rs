//! Highlights about the mirrored light.

use super::description::COSINE;
use super::{
    HighlightVector, Incidence, ModelFactor, Quantity, Reflection, ReflectionModel, Surface, Symbol,
};
use crate::Broadcast;
use crate::parameter::{K_A, K_D, K_S, SHININESS};
use luxel_math::Lanes;

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Phong,
    name: "phong",
    help: "matt with a highlight where the mirrored light meets the eye",
    formula: "k_d O_d max(N.L, 0) + k_s O_s max(R.V, 0)^n",
    source: "Phong 1975",
    parameters: &[&K_A, &K_D, &K_S, &SHININESS],
    own: &[],
    highlight: Some(HighlightVector::Reflected),
    diffuse: &[COSINE],
    specular: Some(&[ModelFactor {
        symbol: Symbol::new(
            "R.V",
            r"\mathbf R\cdot\mathbf V",
            "<b>R</b>·<b>V</b>",
            "R.V: the cosine of the angle between the mirrored light and the direction to the eye",
        ),
        quantity: Quantity::Power,
    }]),
};

/// R.V with R = 2 N (N.L) - L, the direction of mirroring (Phong, *Illumination for Computer
/// Generated Pictures*, 1975), which is 2 (N.L) (N.V) - L.V.
#[inline(always)]
pub(crate) fn r_dot_v<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> N {
    let n_dot_l = incidence.n_dot_l;
    (n_dot_l + n_dot_l) * surface.phong_n_dot_v - incidence.to_light.dot(surface.view)
}
