//! Files of keys: TOML in which an action is given a key, or several; what the file does not say stays.

use super::{BINDINGS, Bound, Chord, Keys, MODES, motions};
use luxel::formats::Place;
use luxel::formats::values::nearest;
use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

/// What is wrong with a file of keys, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {kind}")]
pub struct KeysError {
    /// The line and the column.
    pub place: Place,
    /// What is wrong.
    pub kind: KeysErrorKind,
}

/// What is wrong with a file of keys.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum KeysErrorKind {
    /// It is no TOML, or other values than keys stand in it.
    #[error("{0}")]
    Malformed(String),
    /// There is no such action, mode or motion.
    #[error("{0}")]
    Unknown(String),
    /// What is no key.
    #[error("{0}")]
    NoKey(String),
    /// A key would do two things.
    #[error("{0}")]
    Twice(String),
}

impl Keys {
    /// The keys that a file says, and those by default for what it does not.
    ///
    /// # Errors
    /// [`KeysError`] with its line, if the file is no TOML of actions and keys, or a key stands in it
    /// twice.
    pub fn read(text: &str) -> Result<Self, KeysError> {
        let at = |byte: usize, kind| KeysError { place: Place::in_text(text, byte), kind };
        let root = DeTable::parse(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or_default().to_owned();
            at(error.span().map_or(0, |span| span.start), KeysErrorKind::Malformed(message))
        })?;
        let mut entries: Vec<_> = root.get_ref().iter().collect();
        entries.sort_by_key(|(name, _)| name.span().start);
        let mut said: Vec<(Chord, Bound)> = Vec::new();
        let mut redone: Vec<Bound> = Vec::new();
        let mut take = |bound: Bound, value: &Spanned<DeValue<'_>>| {
            redone.push(bound);
            for (chord, byte) in chords(value).map_err(|(byte, kind)| at(byte, kind))? {
                let clash =
                    said.iter().find(|(key, other)| *key == chord && clashes(*other, bound));
                if let Some((_, other)) = clash {
                    let message = format!("{chord} does `{}` already", name_of(*other));
                    return Err(at(byte, KeysErrorKind::Twice(message)));
                }
                said.push((chord, bound));
            }
            Ok(())
        };
        for (name, value) in entries {
            let mode = MODES.into_iter().find(|mode| mode.to_string() == *name.get_ref());
            if let Some(mode) = mode {
                let DeValue::Table(table) = value.get_ref() else {
                    let message = format!("`{mode}` is a table of motions: write [{mode}]");
                    return Err(at(value.span().start, KeysErrorKind::Malformed(message)));
                };
                let mut entries: Vec<_> = table.iter().collect();
                entries.sort_by_key(|(name, _)| name.span().start);
                for (name, value) in entries {
                    let known = motions(mode).iter().map(|(_, motion)| *motion);
                    let found = known.clone().find(|motion| *motion == name.get_ref());
                    let Some(motion) = found else {
                        let message = unknown(name.get_ref(), "motion of this mode", known);
                        return Err(at(name.span().start, KeysErrorKind::Unknown(message)));
                    };
                    take(Bound::Motion(mode, motion), value)?;
                }
                continue;
            }
            let Some(place) = BINDINGS.iter().position(|one| one.name == name.get_ref()) else {
                let known = BINDINGS.iter().map(|binding| binding.name);
                let message = unknown(name.get_ref(), "action", known);
                return Err(at(name.span().start, KeysErrorKind::Unknown(message)));
            };
            take(Bound::Action(place), value)?;
        }
        // A key that the file takes does what it did by default no more.
        let mut keys = Self::default();
        keys.bound.retain(|(key, bound)| {
            let is_taken = |(chord, by): &(Chord, Bound)| chord == key && clashes(*by, *bound);
            !redone.contains(bound) && !said.iter().any(is_taken)
        });
        keys.bound.extend(said);
        Ok(keys)
    }
}

/// Whether one key can't do both: motions of different modes don't meet.
fn clashes(one: Bound, other: Bound) -> bool {
    !matches!((one, other), (Bound::Motion(a, _), Bound::Motion(b, _)) if a != b)
}

fn name_of(bound: Bound) -> String {
    match bound {
        Bound::Action(at) => BINDINGS[at].name.to_owned(),
        Bound::Motion(mode, name) => format!("{mode}.{name}"),
    }
}

fn unknown<'a>(name: &str, what: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    match nearest(name, known.clone()) {
        Some(meant) => format!("`{name}` is no {what}: did you mean `{meant}`?"),
        None => format!("`{name}` is no {what}: use {}", known.collect::<Vec<_>>().join(", ")),
    }
}

/// The keys of a value, each with its place: a text, or a list of texts, which may be empty.
fn chords(value: &Spanned<DeValue<'_>>) -> Result<Vec<(Chord, usize)>, (usize, KeysErrorKind)> {
    let one = |value: &Spanned<DeValue<'_>>| {
        let start = value.span().start;
        let text = value.get_ref().as_str().ok_or_else(|| {
            let message = "a key is a text, as \"f\"; several are a list, as [\"f\", \"Home\"]";
            (start, KeysErrorKind::Malformed(message.to_owned()))
        })?;
        let chord = text.parse().map_err(|message| (start, KeysErrorKind::NoKey(message)))?;
        Ok((chord, start))
    };
    match value.get_ref() {
        DeValue::Array(items) => items.iter().map(one).collect(),
        _ => Ok(vec![one(value)?]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::{Action, Shown};
    use luxel::navigation::Mode;

    fn action(keys: &Keys, key: &str, mode: Mode) -> Option<Action> {
        keys.action(&key.parse().unwrap(), mode)
    }

    #[test]
    fn a_file_moves_keys_and_leaves_the_others() {
        let keys = Keys::read(
            "grid = \"w\"\nquit = [\"Ctrl+q\", \"F10\"]\nmeasure = []\n\
             [turntable]\nforward = \"Up\"\n",
        );
        let keys = keys.unwrap();
        let of = |key| action(&keys, key, Mode::Turntable);
        assert_eq!(of("w"), Some(Action::Show(Shown::Grid)));
        assert_eq!((of("g"), of("q"), of("r")), (None, None, None));
        assert_eq!((of("Ctrl+q"), of("F10")), (Some(Action::Quit), Some(Action::Quit)));
        assert_eq!(of("Up"), "forward".parse().ok().map(Action::Hold));
        assert_eq!(of("s"), "back".parse().ok().map(Action::Hold));
        assert_eq!(action(&keys, "Up", Mode::Mouselook), None);
        assert_eq!(of("f"), Some(Action::Fit));
        assert_eq!(Keys::read("").unwrap(), Keys::default());
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (text, line, part) in [
            ("quit = \"q\"\nfitt = \"x\"\n", 2, "did you mean `fit`?"),
            ("\n\nquit = 3\n", 3, "a key is a text"),
            ("quit = [\"q\",\n \"Foo\"]\n", 2, "`Foo` is no key"),
            ("fit = \"g\"\nquit = \"g\"\n", 2, "g does `fit` already"),
            ("fit = \"w\"\n[flying]\nfaster = \"w\"\n", 3, "w does `fit` already"),
            ("[flying]\nfoward = \"w\"\n", 2, "no motion"),
            ("quit = \n", 1, ""),
            ("[quit]\na = 1\n", 1, "a key is a text"),
            ("flying = \"F8\"\n", 1, "is a table"),
        ] {
            let error = Keys::read(text).unwrap_err();
            assert!(
                matches!(error.place, Place::LineColumn(at, _) if at == line),
                "{text}: {error}"
            );
            assert!(error.to_string().contains(part), "{text}: {error}");
        }
    }

    #[test]
    fn a_mode_can_be_bound_and_its_motions_too() {
        let keys = Keys::read("mode-flying = \"F8\"\n[flying]\nfaster = \"8\"\n").unwrap();
        assert_eq!(action(&keys, "F8", Mode::Turntable), Some(Action::Mode(Mode::Flying)));
        assert_eq!(action(&keys, "F6", Mode::Turntable), None);
    }
}
