//! Names of reflection models.

use luxel_lighting::Reflection;

/// The reflection model with the parameters that only it has; of a mix the weights and models of its
/// parts.
pub(crate) fn model_name(reflection: &Reflection) -> String {
    match reflection {
        Reflection::Mixed(parts) => {
            let part =
                |(part, weight): &(Reflection, f32)| format!("{weight} {}", simple_name(part));
            parts.iter().map(part).collect::<Vec<_>>().join(" + ")
        }
        simple => simple_name(simple),
    }
}

fn simple_name(reflection: &Reflection) -> String {
    let own = reflection.model().map_or(&[][..], |model| model.own);
    let own = own.iter().filter_map(|own| {
        let value = reflection.own(own.parameter.name)?;
        Some(format!("{} = {value}", own.parameter.symbol))
    });
    let own = own.collect::<Vec<_>>().join(", ");
    let name = reflection.name();
    if own.is_empty() { name.to_owned() } else { format!("{name} ({own})") }
}

/// The text with a capital first letter.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
