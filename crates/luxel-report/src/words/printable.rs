//! Names from files, for a terminal.

/// The text with control characters spelled out: names come from files, and a file must not
/// command the terminal.
#[must_use]
pub fn printable(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        if character.is_control() {
            safe.extend(character.escape_default());
        } else {
            safe.push(character);
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_from_a_file_cannot_command_the_terminal() {
        assert_eq!(printable("a\x1b[2Jb\n"), "a\\u{1b}[2Jb\\n");
        assert_eq!(printable("Teekanne, \u{e4}\u{f6}\u{fc}"), "Teekanne, \u{e4}\u{f6}\u{fc}");
    }
}
