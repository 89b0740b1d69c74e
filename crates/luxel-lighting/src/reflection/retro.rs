//! Highlights back to the light, as of traffic signs.

use super::description::COSINE;
use super::{ModelFactor, Quantity, Reflection, ReflectionModel, Symbol};
use crate::parameter::{K_A, K_D, K_S, SHININESS};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Retro,
    name: "retro",
    help: "matt with a highlight back to the light, as of traffic signs",
    formula: "k_d O_d max(N.L, 0) + k_s O_s max(V.L, 0)^n",
    source: "the exponent as in Phong 1975",
    parameters: &[&K_A, &K_D, &K_S, &SHININESS],
    own: &[],
    highlight: None,
    diffuse: &[COSINE],
    specular: Some(&[ModelFactor {
        symbol: Symbol::new(
            "V.L",
            r"\mathbf V\cdot\mathbf L",
            "<b>V</b>·<b>L</b>",
            "V.L: the cosine of the angle between the directions to the eye and to the light",
        ),
        quantity: Quantity::Power,
    }]),
};
