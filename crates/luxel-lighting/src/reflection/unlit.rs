//! No reflection.

use super::{Reflection, ReflectionModel};
use crate::parameter::K_D;

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Unlit,
    name: "unlit",
    help: "the surface's own colour, whatever the lights",
    formula: "k_d O_d, without lights",
    source: "Foley et al. 1990, section 16.1",
    parameters: &[&K_D],
    own: &[],
    highlight: None,
    diffuse: &[],
    specular: None,
};
