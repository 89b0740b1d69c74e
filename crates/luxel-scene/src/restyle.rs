//! Changes to materials: given values replace the material's, all others stay.

use crate::{AlphaMode, SceneMaterial};
use luxel_lighting::{METALLIC, Parameter, ROUGHNESS, Reflection};
use std::collections::BTreeMap;

/// Constants of reflection that replace a material's.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Restyle {
    /// O_d and O_a, instead of textures and vertex colours.
    pub color: Option<[f32; 3]>,
    /// O_e, instead of a texture.
    pub emission: Option<[f32; 3]>,
    /// The reflection model.
    pub reflection: Option<Reflection>,
    /// O_a, if it differs from O_d; instead of a texture.
    pub ambient: Option<[f32; 3]>,
    /// O_s, instead of a texture.
    pub specular: Option<[f32; 3]>,
    /// Alpha, 0 to 1; below 1 the surface is transparent.
    pub opacity: Option<f32>,
    /// Reflection parameters by name; models ignore the parameters of other models. Metalness and
    /// roughness replace their texture.
    pub parameters: BTreeMap<&'static str, f32>,
}

impl Restyle {
    /// The new value of a reflection parameter, if it changes.
    #[must_use]
    pub fn parameter(&self, parameter: &Parameter) -> Option<f32> {
        self.parameters.get(parameter.name).copied()
    }

    /// Changes a reflection parameter.
    pub fn set_parameter(&mut self, parameter: &Parameter, value: f32) {
        self.parameters.insert(parameter.name, value);
    }

    /// Changes a material.
    pub fn apply(&self, material: &mut SceneMaterial) {
        let Self { color, emission, reflection, ambient, specular, opacity, parameters } = self;
        let constants = &mut material.constants;
        if let Some(color) = *color {
            constants.diffuse = color;
            constants.ambient = None;
            material.base_color = None;
            material.ambient = None;
            material.vertex_colors = false;
        }
        if let Some(emission) = *emission {
            constants.emission = emission;
            material.emission = None;
        }
        if ambient.is_some() {
            constants.ambient = *ambient;
            material.ambient = None;
        }
        if let Some(specular) = *specular {
            constants.specular = specular;
            material.specular = None;
        }
        if [METALLIC, ROUGHNESS].iter().any(|one| parameters.contains_key(one.name)) {
            material.metallic_roughness = None;
        }
        if let Some(opacity) = *opacity {
            material.opacity = opacity;
            if opacity < 1.0 {
                material.alpha_mode = AlphaMode::Blend;
            }
        }
        if let Some(reflection) = reflection {
            constants.reflection = reflection.clone();
        }
        // Last: parameters may be those of the new model.
        for (name, value) in parameters {
            constants.set_value(name, *value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{TextureId, TextureUse};
    use luxel_lighting::{K_S, REFLECTION_MODELS, SHININESS};

    #[test]
    fn every_parameter_of_a_model_is_changed_by_its_description() {
        for model in REFLECTION_MODELS {
            let own = model.own.iter().map(|own| &own.parameter);
            for parameter in model.parameters.iter().copied().chain(own) {
                let mut material = SceneMaterial::default();
                material.constants.reflection = model.reflection.clone();
                let [_, high] = parameter.range;
                let value = high.min(7.0);
                let mut restyle = Restyle::default();
                assert_eq!(restyle.parameter(parameter), None, "{}", parameter.name);
                restyle.set_parameter(parameter, value);
                assert_eq!(restyle.parameter(parameter), Some(value), "{}", parameter.name);
                restyle.apply(&mut material);
                assert_eq!(material.constants.value(parameter), value, "{}", parameter.name);
            }
        }
    }

    #[test]
    fn roughness_replaces_its_texture() {
        let texture: Option<Box<_>> = Some(TextureUse::new(TextureId(0)).into());
        let mut material =
            SceneMaterial { metallic_roughness: texture.clone(), ..SceneMaterial::default() };
        Restyle::default().apply(&mut material);
        assert_eq!(material.metallic_roughness, texture);
        let mut restyle = Restyle::default();
        restyle.set_parameter(&ROUGHNESS, 0.5);
        restyle.apply(&mut material);
        assert_eq!(material.metallic_roughness, None);
    }

    #[test]
    fn an_empty_change_keeps_the_material() {
        let mut material = SceneMaterial::default();
        Restyle::default().apply(&mut material);
        assert_eq!(material, SceneMaterial::default());
    }

    #[test]
    fn a_colour_replaces_textures_and_vertex_colours() {
        let mut material = SceneMaterial {
            base_color: Some(TextureUse::new(TextureId(0)).into()),
            ambient: Some(TextureUse::new(TextureId(0)).into()),
            ..SceneMaterial::default()
        };
        Restyle { color: Some([0.1, 0.2, 0.3]), ..Restyle::default() }.apply(&mut material);
        assert_eq!(material.constants.diffuse, [0.1, 0.2, 0.3]);
        assert_eq!(material.constants.ambient, None, "ambient is the diffuse colour");
        assert_eq!((material.base_color, material.ambient), (None, None));
        assert!(!material.vertex_colors);
    }

    #[test]
    fn constants_are_replaced_one_by_one() {
        let mut material = SceneMaterial::default();
        let mut restyle = Restyle { reflection: Some(Reflection::Phong), ..Restyle::default() };
        restyle.set_parameter(&K_S, 0.7);
        restyle.set_parameter(&SHININESS, 99.0);
        restyle.apply(&mut material);
        assert_eq!(material.constants.k_s, 0.7);
        assert_eq!(material.constants.shininess, 99.0);
        assert_eq!(material.constants.k_d, 1.0);
        assert_eq!(material.constants.reflection, Reflection::Phong);
    }
}
