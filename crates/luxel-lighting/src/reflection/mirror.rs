//! An ideal mirror.

use super::{Reflection, ReflectionModel};
use crate::parameter::{K_D, K_S, ROUGHNESS};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Mirror,
    name: "mirror",
    help: "an ideal mirror of the environment",
    formula: "k_s O_s E(R), R = 2 N (N.V) - V, without lights",
    source: "Foley et al. 1990, section 16.6",
    parameters: &[&K_D, &K_S, &ROUGHNESS],
    own: &[],
    highlight: None,
    diffuse: &[],
    specular: None,
};
