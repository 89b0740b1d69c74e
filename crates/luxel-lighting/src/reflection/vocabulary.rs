//! Reflection models and their parameters by name.

use super::{OwnParameter, REFLECTION_MODELS, Reflection};
use crate::parameter::{Parameter, SHARED};
use std::slice;

/// The model-specific parameters, in the order of the models.
pub fn own_parameters() -> impl Iterator<Item = &'static OwnParameter> {
    REFLECTION_MODELS.iter().flat_map(|model| model.own)
}

/// All reflection parameters: the shared ones, then the model-specific ones.
pub fn parameters() -> impl Iterator<Item = &'static Parameter> {
    SHARED.into_iter().chain(own_parameters().map(|own| &own.parameter))
}

impl Reflection {
    /// The model with a name, with default parameters. Mixtures have no complete name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        let model = REFLECTION_MODELS.iter().find(|model| model.name == name)?;
        Some(model.reflection.clone())
    }

    /// The name of the model; `mixed` for a mixture.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.model().map_or("mixed", |model| model.name)
    }

    /// The parts of a mixture; of other models, the model itself.
    pub fn models(&self) -> impl Iterator<Item = &Self> {
        let mixed = match self {
            Self::Mixed(parts) => &parts[..],
            _ => &[],
        };
        let alone = mixed.is_empty().then_some(self);
        alone.into_iter().chain(mixed.iter().map(|(part, _)| part))
    }

    /// Whether the model uses a parameter.
    #[must_use]
    pub fn heeds(&self, parameter: &Parameter) -> bool {
        self.models().filter_map(Self::model).any(|model| {
            let own = model.own.iter().map(|own| &own.parameter);
            model.parameters.iter().copied().chain(own).any(|other| other.name == parameter.name)
        })
    }

    /// The value of a model-specific parameter; `None` if the model lacks it.
    #[must_use]
    pub fn own(&self, name: &str) -> Option<f32> {
        let own = own_parameters().find(|own| own.parameter.name == name)?;
        self.models().find_map(|model| (own.field)(&mut model.clone()).copied())
    }

    /// Sets a model-specific parameter, also in a mixture; other models ignore it.
    pub fn set_own(&mut self, name: &str, value: f32) {
        let Some(own) = own_parameters().find(|own| own.parameter.name == name) else { return };
        let parts = match self {
            Self::Mixed(parts) => parts.iter_mut().map(|(part, _)| part).collect(),
            alone => slice::from_mut(alone).iter_mut().collect::<Vec<_>>(),
        };
        for part in parts {
            if let Some(field) = (own.field)(part) {
                *field = own.parameter.nearest(value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn names_of_models_and_parameters_are_unique() {
        let names: BTreeSet<_> = REFLECTION_MODELS.iter().map(|model| model.name).collect();
        assert_eq!(names.len(), REFLECTION_MODELS.len());
        let names: BTreeSet<_> = parameters().map(|parameter| parameter.name).collect();
        assert_eq!(names.len(), parameters().count());
    }

    #[test]
    fn a_model_is_found_by_its_name_and_described_by_its_own_description() {
        for model in REFLECTION_MODELS {
            let found = Reflection::by_name(model.name).unwrap();
            assert_eq!((&found, found.name()), (&model.reflection, model.name));
        }
    }

    #[test]
    fn defaults_are_within_their_ranges() {
        for parameter in parameters() {
            assert_eq!(parameter.nearest(parameter.default), parameter.default, "{parameter:?}");
            assert!(parameter.slider_end <= parameter.range[1], "{parameter:?}");
        }
    }

    #[test]
    fn a_model_specific_parameter_exists_in_its_model_only_and_is_clamped() {
        for model in REFLECTION_MODELS {
            for own in model.own {
                let Parameter { name, range: [low, high], default, .. } = own.parameter;
                for other in REFLECTION_MODELS {
                    let value = (other.name == model.name).then_some(default);
                    assert_eq!(other.reflection.own(name), value, "{name} of {}", other.name);
                }
                let mut mixed = Reflection::mixed(vec![
                    (Reflection::Lambert, 0.5),
                    (model.reflection.clone(), 0.5),
                ]);
                for (set, value) in [(f32::INFINITY, high), (-1.0, low.max(-1.0)), (low, low)] {
                    mixed.set_own(name, set);
                    assert_eq!(mixed.own(name), Some(value), "{name}");
                }
            }
        }
    }
}
