//! Keys with modifiers, as users write them: `f`, `Ctrl+1`, `Shift+Tab`, `?`.

use std::fmt;
use std::str::FromStr;

/// A key with modifiers.
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
    /// A character; letters are lower case. Other characters include Shift.
    Char(char),
    /// An index into [`NAMES`], or beyond: Down and the function keys.
    Named(usize),
}

/// Named keys, and aliases of some.
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
/// The index of Down; F1 and so on follow.
const DOWN: usize = NAMES.len();
/// F1 to F24.
const FUNCTION_KEYS: usize = 24;

impl KeyName {
    /// The key of a typed character.
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
        let matches = |(one, other): &(&str, &str)| {
            one.eq_ignore_ascii_case(name)
                || (!other.is_empty() && other.eq_ignore_ascii_case(name))
        };
        NAMES.iter().position(matches).map(Self::Named)
    }
}

impl Chord {
    /// A key as pressed.
    pub(crate) fn new(key: KeyName, ctrl: bool, shift: bool, alt: bool) -> Self {
        // The character of a shifted key includes Shift.
        let shift = shift && !matches!(key, KeyName::Char(letter) if !letter.is_alphabetic());
        Self { key, ctrl, shift, alt }
    }
}

impl FromStr for Chord {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "`{text}` is not a key: use a character or Escape, Tab, Enter, Space, Backspace, Insert, \
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
    fn written_keys_read_back() {
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
    fn invalid_keys_are_refused() {
        for text in ["", "Foo", "Ctrl+", "Super+x", "F0", "F25", "Shift", "ab", "\u{7}"] {
            assert!(text.parse::<Chord>().is_err(), "{text}");
        }
    }
}
