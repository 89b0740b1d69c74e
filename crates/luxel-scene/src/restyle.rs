//! Changes to materials: what is said replaces, what isn't stays.

use crate::{AlphaMode, SceneMaterial};
use luxel_lighting::{Parameter, Reflection};
use std::collections::BTreeMap;

/// Constants of reflection that replace a material's.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Restyle {
    /// O_d and O_a, instead of textures and vertex colours.
    pub color: Option<[f32; 3]>,
    /// k_a
    pub k_a: Option<f32>,
    /// k_d
    pub k_d: Option<f32>,
    /// k_s
    pub k_s: Option<f32>,
    /// n: the exponent of the highlight.
    pub shininess: Option<f32>,
    /// O_e, instead of a texture.
    pub emission: Option<[f32; 3]>,
    /// The model of reflection.
    pub reflection: Option<Reflection>,
    /// O_a, where it isn't O_d; instead of a texture.
    pub ambient: Option<[f32; 3]>,
    /// O_s, instead of a texture.
    pub specular: Option<[f32; 3]>,
    /// 0 for dielectrics, 1 for metals; drops the texture of metalness and roughness.
    pub metallic: Option<f32>,
    /// Perceptual roughness, 0 to 1; drops the same texture.
    pub roughness: Option<f32>,
    /// Alpha, 0 to 1; below 1 the surface lets through what is behind it.
    pub opacity: Option<f32>,
    /// Parameters that only one reflection model has, by name; nothing happens to other models.
    pub own: BTreeMap<&'static str, f32>,
}

impl Restyle {
    /// The value of a parameter of reflection, if the change has one.
    #[must_use]
    pub fn parameter(&self, parameter: &Parameter) -> Option<f32> {
        match parameter.name {
            "ka" => self.k_a,
            "kd" => self.k_d,
            "ks" => self.k_s,
            "shininess" => self.shininess,
            "metallic" => self.metallic,
            "roughness" => self.roughness,
            own => self.own.get(own).copied(),
        }
    }

    /// Changes a parameter of reflection.
    pub fn set_parameter(&mut self, parameter: &'static Parameter, value: f32) {
        let field = match parameter.name {
            "ka" => &mut self.k_a,
            "kd" => &mut self.k_d,
            "ks" => &mut self.k_s,
            "shininess" => &mut self.shininess,
            "metallic" => &mut self.metallic,
            "roughness" => &mut self.roughness,
            own => {
                self.own.insert(own, value);
                return;
            }
        };
        *field = Some(value);
    }

    /// Changes a material.
    pub fn apply(&self, material: &mut SceneMaterial) {
        let Self { color, k_a, k_d, k_s, shininess, emission, reflection, .. } = self;
        let Self { ambient, specular, metallic, roughness, opacity, .. } = *self;
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
            constants.ambient = ambient;
            material.ambient = None;
        }
        if let Some(specular) = specular {
            constants.specular = specular;
            material.specular = None;
        }
        if metallic.is_some() || roughness.is_some() {
            material.metallic_roughness = None;
        }
        if let Some(opacity) = opacity {
            material.opacity = opacity;
            if opacity < 1.0 {
                material.alpha_mode = AlphaMode::Blend;
            }
        }
        constants.metallic = metallic.unwrap_or(constants.metallic);
        constants.roughness = roughness.unwrap_or(constants.roughness);
        constants.k_a = k_a.unwrap_or(constants.k_a);
        constants.k_d = k_d.unwrap_or(constants.k_d);
        constants.k_s = k_s.unwrap_or(constants.k_s);
        constants.shininess = shininess.unwrap_or(constants.shininess);
        if let Some(reflection) = reflection {
            constants.reflection = reflection.clone();
        }
        for (name, value) in &self.own {
            constants.reflection.set_own(name, *value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{TextureId, TextureUse};
    use luxel_lighting::{ROUGHNESS, parameters};

    #[test]
    fn every_parameter_of_reflection_is_changed_by_its_description() {
        for parameter in parameters() {
            let mut restyle = Restyle::default();
            assert_eq!(restyle.parameter(parameter), None, "{}", parameter.name);
            restyle.set_parameter(parameter, 0.5);
            assert_eq!(restyle.parameter(parameter), Some(0.5), "{}", parameter.name);
        }
        let mut restyle = Restyle::default();
        restyle.set_parameter(&ROUGHNESS, 0.5);
        assert_eq!(restyle, Restyle { roughness: Some(0.5), ..Restyle::default() });
    }

    #[test]
    fn what_is_not_said_stays_as_it_is() {
        let mut material = SceneMaterial::default();
        Restyle::default().apply(&mut material);
        assert_eq!(material, SceneMaterial::default());
    }

    #[test]
    fn a_colour_replaces_textures_and_vertex_colours() {
        let mut material = SceneMaterial {
            base_color: Some(TextureUse::new(TextureId(0))),
            ambient: Some(TextureUse::new(TextureId(0))),
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
        let restyle = Restyle {
            k_s: Some(0.7),
            shininess: Some(99.0),
            reflection: Some(Reflection::Phong),
            ..Restyle::default()
        };
        restyle.apply(&mut material);
        assert_eq!(material.constants.k_s, 0.7);
        assert_eq!(material.constants.shininess, 99.0);
        assert_eq!(material.constants.k_d, 1.0);
        assert_eq!(material.constants.reflection, Reflection::Phong);
    }
}
