//! Names of kinds of lights and of reflection models.

use luxel_lighting::{Light, LightKind, Reflection};

/// The kind of a light, as scene files name it.
pub(crate) fn kind_name(light: &Light) -> &'static str {
    match light.kind {
        LightKind::Ambient => "ambient",
        LightKind::Directional => "directional",
        LightKind::Point => "point",
        LightKind::Spot(_) => "spot",
    }
}

/// The reflection model; of a mix the weights and names of its parts.
pub(crate) fn model_name(reflection: &Reflection) -> String {
    match reflection {
        Reflection::Mixed(parts) => {
            let part = |(part, weight): &(Reflection, f32)| format!("{weight} {}", part.name());
            parts.iter().map(part).collect::<Vec<_>>().join(" + ")
        }
        simple => simple.name().to_owned(),
    }
}

/// The text with a capital first letter.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
