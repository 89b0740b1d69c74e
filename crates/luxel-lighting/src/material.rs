//! Materials: the constants of reflection.

use crate::Reflection;
use crate::parameter::{K_A, K_D, K_S, METALLIC, Parameter, ROUGHNESS, SHININESS};

/// The reflection constants of a surface, which textures and vertex colours multiply.
///
/// Colours are linear.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Material {
    /// The model.
    pub reflection: Reflection,
    /// O_a; `None` means O_d, textures and vertex colours included.
    pub ambient: Option<[f32; 3]>,
    /// O_d; the base colour of a microfacet material.
    pub diffuse: [f32; 3],
    /// O_s.
    pub specular: [f32; 3],
    /// O_e: emitted light.
    pub emission: [f32; 3],
    /// k_a
    pub k_a: f32,
    /// k_d
    pub k_d: f32,
    /// k_s
    pub k_s: f32,
    /// n: the exponent of the highlight.
    pub shininess: f32,
    /// 0 for dielectrics, 1 for metals (microfacet).
    pub metallic: f32,
    /// Perceptual roughness, 0 to 1; alpha = roughness^2 (microfacet, Oren-Nayar).
    pub roughness: f32,
}

impl Default for Material {
    /// A warm light grey (sRGB 0.80, 0.78, 0.75), slightly glossy, for files without materials:
    /// form is visible from shading alone.
    fn default() -> Self {
        Self {
            reflection: Reflection::BlinnPhong,
            ambient: None,
            diffuse: [0.603_827_4, 0.570_481_6, 0.522_521_5],
            specular: [1.0; 3],
            emission: [0.0; 3],
            k_a: K_A.default,
            k_d: K_D.default,
            k_s: K_S.default,
            shininess: SHININESS.default,
            metallic: METALLIC.default,
            roughness: ROUGHNESS.default,
        }
    }
}

impl Material {
    /// The value of a parameter; the default of one that its reflection model lacks.
    #[must_use]
    pub fn value(&self, parameter: &Parameter) -> f32 {
        let own = || self.reflection.own(parameter.name).unwrap_or(parameter.default);
        // The copy lets reading and writing share one table of fields.
        self.clone().shared(parameter.name).map_or_else(own, |value| *value)
    }

    /// Sets the parameter with a name; one that the reflection model lacks stays out.
    pub fn set_value(&mut self, name: &str, value: f32) {
        match self.shared(name) {
            Some(field) => *field = value,
            None => self.reflection.set_own(name, value),
        }
    }

    /// The field of a shared parameter.
    fn shared(&mut self, name: &str) -> Option<&mut f32> {
        let fields = [
            (K_A.name, &mut self.k_a),
            (K_D.name, &mut self.k_d),
            (K_S.name, &mut self.k_s),
            (SHININESS.name, &mut self.shininess),
            (METALLIC.name, &mut self.metallic),
            (ROUGHNESS.name, &mut self.roughness),
        ];
        fields.into_iter().find(|(key, _)| *key == name).map(|(_, field)| field)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::SHARED;

    #[test]
    fn every_shared_parameter_is_a_field_of_the_material() {
        let material = Material {
            k_a: 0.1,
            k_d: 0.2,
            k_s: 0.3,
            shininess: 0.4,
            roughness: 0.5,
            metallic: 0.6,
            ..Material::default()
        };
        let values = SHARED.map(|parameter| material.value(parameter));
        assert_eq!(values, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
        let mut copy = Material::default();
        for parameter in SHARED {
            copy.set_value(parameter.name, material.value(parameter));
        }
        assert_eq!(copy, material);
    }
}
