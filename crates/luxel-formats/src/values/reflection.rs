//! `blinn-phong`, `mixed:lambert=.7,mirror=.3`: a model of reflection by name.

use super::number::non_negative_f32;
use luxel_lighting::Reflection;

const NAMES: &str =
    "unlit, lambert, oren-nayar, phong, blinn-phong, microfacet, mirror, retro or mixed:NAME=W,...";

/// A model of reflection.
///
/// # Errors
/// A name that is none, a weight below 0.
pub fn reflection(text: &str) -> Result<Reflection, String> {
    let Some(parts) = text.strip_prefix("mixed:") else {
        return single(text);
    };
    let mut models = Vec::new();
    for part in parts.split(',') {
        let (name, weight) = part
            .split_once('=')
            .ok_or_else(|| format!("`{part}` lacks a weight: use NAME=WEIGHT"))?;
        models.push((single(name)?, non_negative_f32(weight)?));
    }
    Ok(Reflection::Mixed(models))
}

fn single(name: &str) -> Result<Reflection, String> {
    match name {
        "unlit" => Ok(Reflection::Unlit),
        "lambert" => Ok(Reflection::Lambert),
        "oren-nayar" => Ok(Reflection::OrenNayar),
        "phong" => Ok(Reflection::Phong),
        "blinn-phong" => Ok(Reflection::BlinnPhong),
        "microfacet" => Ok(Reflection::Microfacet),
        "mirror" => Ok(Reflection::Mirror),
        "retro" => Ok(Reflection::Retro),
        _ => Err(format!("`{name}` is no model of reflection: use {NAMES}")),
    }
}

/// The name that [`reflection`] reads.
#[must_use]
pub fn reflection_name(reflection: &Reflection) -> &'static str {
    match reflection {
        Reflection::Unlit => "unlit",
        Reflection::Lambert => "lambert",
        Reflection::OrenNayar => "oren-nayar",
        Reflection::Phong => "phong",
        Reflection::BlinnPhong => "blinn-phong",
        Reflection::Microfacet => "microfacet",
        Reflection::Mirror => "mirror",
        Reflection::Retro => "retro",
        Reflection::Mixed(_) => "mixed",
    }
}

/// The text that [`reflection`] reads as this model.
#[must_use]
pub fn reflection_text(model: &Reflection) -> String {
    match model {
        Reflection::Mixed(parts) => {
            let part = |(model, weight): &(Reflection, f32)| {
                format!("{}={weight}", reflection_name(model))
            };
            format!("mixed:{}", parts.iter().map(part).collect::<Vec<_>>().join(","))
        }
        simple => reflection_name(simple).to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back_as_its_model() {
        for name in [
            "unlit",
            "lambert",
            "oren-nayar",
            "phong",
            "blinn-phong",
            "microfacet",
            "mirror",
            "retro",
        ] {
            assert_eq!(reflection_name(&reflection(name).unwrap()), name);
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
    fn wrong_models_are_refused() {
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
