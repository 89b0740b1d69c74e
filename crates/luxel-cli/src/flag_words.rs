//! Errors, warnings and advice of the libraries, worded as flags.

use luxel::formats::{Error, Hint, UnknownFormat, Warning};

/// An error with its hint.
pub(crate) fn error_text(error: &Error) -> String {
    format!("{error}{}", hint_text(error.hint()))
}

/// A warning with its hint.
pub(crate) fn warning_text(warning: &Warning) -> String {
    format!("{warning}{}", hint_text(warning.hint))
}

/// An unknown format with its hint.
pub(crate) fn unknown_format_text(error: &UnknownFormat) -> String {
    format!("{error}{}", hint_text(error.hint()))
}

/// The text that follows a message with a hint.
fn hint_text(hint: Option<Hint>) -> &'static str {
    match hint {
        Some(Hint::RaiseMemoryLimit) => ": raise it with --max-memory",
        Some(Hint::PassFormat) => ": say it with --format",
        Some(Hint::ScaleLights) => {
            ": see --light-scale, such as 0.00146 (1/683) for lights that were watts"
        }
        _ => "",
    }
}

/// A text whose settings in backticks become flags: `` `shading flat` `` is `--shading flat`.
pub(crate) fn with_flags(text: &str) -> String {
    let parts = text.split('`').enumerate();
    parts
        .map(|(place, part)| if place % 2 == 1 { format!("--{part}") } else { part.into() })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_become_flags() {
        assert_eq!(
            with_flags("try (`normals mean` `crease 4`)"),
            "try (--normals mean --crease 4)"
        );
        assert_eq!(with_flags("nothing"), "nothing");
    }
}
