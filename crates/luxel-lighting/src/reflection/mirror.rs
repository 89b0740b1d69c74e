//! An ideal mirror.

use super::{Reflection, ReflectionModel};
use crate::parameter::{K_A, K_S};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Mirror,
    name: "mirror",
    help: "an ideal mirror of the environment",
    formula: "k_s O_s E(R), R = 2 N (N.V) - V, without lights",
    source: "Foley et al. 1990, section 16.6",
    parameters: &[&K_A, &K_S],
    own: &[],
    highlight: None,
    diffuse: &[],
    specular: None,
};
