//! Names of reflection models.

use luxel_lighting::Reflection;

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
