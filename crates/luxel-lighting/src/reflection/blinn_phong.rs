//! Highlights about the normal that would mirror the light into the eye.

use super::description::COSINE;
use super::{
    HighlightVector, Incidence, ModelFactor, Quantity, Reflection, ReflectionModel, Surface, Symbol,
};
use crate::Broadcast;
use crate::parameter::{K_A, K_D, K_S, SHININESS};
use luxel_math::Lanes;

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::BlinnPhong,
    name: "blinn-phong",
    help: "matt with a highlight, as OpenGL lights; wider than that of phong",
    formula: "k_d O_d max(N.L, 0) + k_s O_s max(N.H, 0)^n",
    source: "Blinn 1977",
    parameters: &[&K_A, &K_D, &K_S, &SHININESS],
    own: &[],
    highlight: Some(HighlightVector::Halfway),
    diffuse: &[COSINE],
    specular: Some(&[ModelFactor {
        symbol: Symbol::new(
            "N.H",
            r"\mathbf N\cdot\mathbf H",
            "<b>N</b>·<b>H</b>",
            "N.H: the cosine of the angle between the normal and H, halfway between light and eye",
        ),
        quantity: Quantity::Power,
    }]),
};

/// (N.H, (N.H)^2) with H = (L + V) / |L + V|, the normal that would mirror the light into the eye
/// (Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, 1977); the square is 0 where
/// N.H < 0.
///
/// The highlight takes the square, which needs no root: (N.(L + V))^2 / |L + V|^2. H is summed by its
/// components: from dot products, |L + V|^2 = 2 + 2 L.V would cancel where the light is behind.
#[inline(always)]
pub(crate) fn n_dot_h<N: Lanes, K: Broadcast<N>>(
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
