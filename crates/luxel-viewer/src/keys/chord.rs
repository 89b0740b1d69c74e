//! A key with what is held beside it, as people write it: `f`, `Ctrl+1`, `Shift+Tab`, `?`.

use std::fmt;
use std::str::FromStr;

/// A key with what is held beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Chord {
    pub(crate) key: KeyName,
    pub(crate) ctrl: bool,
    pub(crate) shift: bool,
    pub(crate) alt: bool,
}

/// A key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyName {
    /// A character: small, if it is a letter. Shift is part of all that are none.
    Char(char),
    /// One of [`NAMES`], by its place.
    Named(usize),
}

/// Keys that write nothing, and other names of some of them.
const NAMES: [(&str, &str); 14] = [
    ("Escape", "Esc"),
    ("Tab", ""),
    ("Enter", "Return"),
    ("Space", ""),
    ("Backspace", ""),
    ("Insert", "Ins"),
    ("Delete", "Del"),
    ("Home", ""),
    ("End", ""),
    ("PageUp", ""),
    ("PageDown", ""),
    ("Left", "ArrowLeft"),
    ("Right", "ArrowRight"),
    ("Up", "ArrowUp"),
];
/// The last of the names, then F1 and so on.
const DOWN: usize = NAMES.len();
/// F1 to F24.
const FUNCTION_KEYS: usize = 24;

impl KeyName {
    /// The key of a character that was typed.
    pub(crate) fn of(letter: char) -> Self {
        if letter == ' ' {
            return Self::Named(3);
        }
        let mut lower = letter.to_lowercase();
        match (lower.next(), lower.next()) {
            (Some(one), None) => Self::Char(one),
            _ => Self::Char(letter),
        }
    }

    /// A key by its name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        if ["Down", "ArrowDown"].iter().any(|down| down.eq_ignore_ascii_case(name)) {
            return Some(Self::Named(DOWN));
        }
        if let Some(number) = name.strip_prefix(['F', 'f'])
            && let Ok(number @ 1..=FUNCTION_KEYS) = number.parse::<usize>()
        {
            return Some(Self::Named(DOWN + number));
        }
        let is_it = |(one, other): &(&str, &str)| {
            one.eq_ignore_ascii_case(name)
                || (!other.is_empty() && other.eq_ignore_ascii_case(name))
        };
        NAMES.iter().position(is_it).map(Self::Named)
    }
}

impl Chord {
    /// A key as it was pressed.
    pub(crate) fn new(key: KeyName, ctrl: bool, shift: bool, alt: bool) -> Self {
        // Shift has made another character of it already.
        let shift = shift && !matches!(key, KeyName::Char(letter) if !letter.is_alphabetic());
        Self { key, ctrl, shift, alt }
    }
}

impl FromStr for Chord {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "`{text}` is no key: use a character or Escape, Tab, Enter, Space, Backspace, Insert, \
                 Delete, Home, End, PageUp, PageDown, Left, Right, Up, Down, F1 to F24, with Ctrl+, \
                 Shift+ or Alt+ before it"
            )
        };
        let (mut ctrl, mut shift, mut alt) = (false, false, false);
        let mut rest = text;
        // A plus may be the key itself.
        while let Some((held, key)) = rest.split_once('+').filter(|(_, key)| !key.is_empty()) {
            let is_held = match held.to_ascii_lowercase().as_str() {
                "ctrl" => &mut ctrl,
                "shift" => &mut shift,
                "alt" => &mut alt,
                _ => return Err(wrong()),
            };
            *is_held = true;
            rest = key;
        }
        let mut letters = rest.chars();
        let key = match (letters.next(), letters.next()) {
            (Some(letter), None) if !letter.is_control() => {
                shift |= letter.is_uppercase();
                KeyName::of(letter)
            }
            _ => KeyName::named(rest).ok_or_else(wrong)?,
        };
        Ok(Self::new(key, ctrl, shift, alt))
    }
}

impl fmt::Display for Chord {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (is_held, name) in [(self.ctrl, "Ctrl "), (self.shift, "Shift "), (self.alt, "Alt ")] {
            if is_held {
                formatter.write_str(name)?;
            }
        }
        match self.key {
            KeyName::Char(letter) => write!(formatter, "{letter}"),
            KeyName::Named(DOWN) => formatter.write_str("Down"),
            KeyName::Named(at) if at > DOWN => write!(formatter, "F{}", at - DOWN),
            KeyName::Named(at) => formatter.write_str(NAMES.get(at).map_or("", |(name, _)| name)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        for text in [
            "f",
            "?",
            "Ctrl+1",
            "Shift+Tab",
            "Ctrl+Alt+Delete",
            "F12",
            "Down",
            "Space",
            "ä",
            "+",
            "Ctrl++",
        ] {
            let chord: Chord = text.parse().unwrap();
            let written = chord.to_string().replace(' ', "+");
            assert_eq!(written, text);
            assert_eq!(written.parse(), Ok(chord));
        }
        assert_eq!("H".parse::<Chord>(), "Shift+h".parse());
        assert_eq!("esc".parse::<Chord>(), "Escape".parse());
        assert_eq!("ArrowDown".parse::<Chord>(), "down".parse());
        assert_eq!("Shift+?".parse::<Chord>(), "?".parse());
    }

    #[test]
    fn what_is_no_key_is_refused() {
        for text in ["", "Foo", "Ctrl+", "Super+x", "F0", "F25", "Shift", "ab", "\u{7}"] {
            assert!(text.parse::<Chord>().is_err(), "{text}");
        }
    }
}
