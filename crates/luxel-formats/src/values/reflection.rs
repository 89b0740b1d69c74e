//! `blinn-phong`, `mixed:lambert=.7,mirror=.3`: a reflection model by name, and its parameters.

use super::number::{non_negative_f32, unit_interval};
use luxel_lighting::{Parameter, REFLECTION_MODELS, Reflection};

/// The values that [`reflection`] accepts: the names of the models and the form of a mixture.
#[must_use]
pub fn reflection_choices() -> String {
    let names: Vec<&str> = REFLECTION_MODELS.iter().map(|model| model.name).collect();
    format!("{} or mixed:NAME=W,...", names.join(", "))
}

/// Parses a reflection model.
///
/// # Errors
/// An unknown name, a weight below 0.
pub fn reflection(text: &str) -> Result<Reflection, String> {
    let Some(parts) = text.strip_prefix("mixed:") else {
        return single(text);
    };
    let mut models = Vec::new();
    for part in parts.split(',') {
        let (name, weight) = part
            .split_once('=')
            .ok_or_else(|| format!("`{part}` has no weight: use NAME=WEIGHT"))?;
        models.push((single(name)?, non_negative_f32(weight)?));
    }
    Ok(Reflection::mixed(models))
}

fn single(name: &str) -> Result<Reflection, String> {
    Reflection::by_name(name)
        .ok_or_else(|| format!("`{name}` is not a reflection model: use {}", reflection_choices()))
}

/// Parses the value of a reflection parameter.
///
/// # Errors
/// Text that is not a number, or a number outside the parameter's range.
pub fn parameter(of: &Parameter, text: &str) -> Result<f32, String> {
    let [low, high] = of.range;
    let value = match (low, high) {
        (0.0, 1.0) => unit_interval(text)?,
        (0.0, f32::INFINITY) => non_negative_f32(text)?,
        _ => super::number::finite(text)? as f32,
    };
    if of.nearest(value) == value {
        Ok(value)
    } else {
        let kind = if of.is_whole { "a whole number" } else { "a number" };
        Err(format!("use {kind} from {low} to {high}"))
    }
}

/// The text that [`reflection`] reads as this model.
#[must_use]
pub fn reflection_text(model: &Reflection) -> String {
    match model {
        Reflection::Mixed(parts) => {
            let part = |(model, weight): &(Reflection, f32)| format!("{}={weight}", model.name());
            format!("mixed:{}", parts.iter().map(part).collect::<Vec<_>>().join(","))
        }
        simple => simple.name().to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_lighting::parameters;

    #[test]
    fn every_name_reads_back_as_its_model() {
        for model in REFLECTION_MODELS {
            assert_eq!(reflection(model.name).as_ref(), Ok(&model.reflection));
            assert_eq!(reflection_text(&model.reflection), model.name);
        }
    }

    #[test]
    fn the_default_of_every_parameter_is_read_and_values_beyond_its_range_are_refused() {
        for one in parameters() {
            assert_eq!(parameter(one, &one.default.to_string()), Ok(one.default), "{}", one.name);
            assert_eq!(parameter(one, one.example), one.example.parse().map_err(|_| String::new()));
            let [low, high] = one.range;
            for wrong in [low - 1.0, high + 1.0, high * 2.0, f32::NAN] {
                assert!(parameter(one, &wrong.to_string()).is_err(), "{}: {wrong}", one.name);
            }
            if one.is_whole {
                assert!(parameter(one, &(low + 0.5).to_string()).is_err(), "{}", one.name);
            }
        }
    }

    #[test]
    fn mixtures_have_weights() {
        let mixed = reflection("mixed:lambert=.75,mirror=0.25").unwrap();
        let parts = vec![(Reflection::Lambert, 0.75), (Reflection::Mirror, 0.25)];
        assert_eq!(mixed, Reflection::Mixed(parts));
        assert_eq!(reflection(&reflection_text(&mixed)), Ok(mixed));
    }

    #[test]
    fn invalid_models_are_refused() {
        for text in [
            "",
            "Phong",
            "cook",
            "mixed",
            "mixed:",
            "mixed:lambert",
            "mixed:lambert=-1",
            "mixed:lambert=nan",
            "mixed:mixed=1",
            "mixed:lambert=1,",
        ] {
            assert!(reflection(text).is_err(), "{text}");
        }
    }
}
