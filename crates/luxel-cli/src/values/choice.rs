//! Parses one of a list of names.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A parser for another crate's named choices; completions show `help`.
pub(crate) fn choice<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
    help: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let values =
        all.iter().map(move |one| PossibleValue::new(name(*one)).help(capital(help(*one))));
    PossibleValuesParser::new(values).try_map(move |text| {
        let found = all.iter().copied().find(|one| name(*one) == text);
        found.ok_or("not one of the possible values")
    })
}

/// The text with a capital first letter.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
