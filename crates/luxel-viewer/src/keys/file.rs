//! Key files: TOML that binds actions to one key or several; other actions keep their defaults.

use super::{BINDINGS, Chord, Keys, MODES, Target, motions};
use luxel::formats::Place;
use luxel::formats::values::nearest;
use serde_spanned::Spanned;
use std::borrow::Cow;
use toml::de::{DeTable, DeValue};

/// An error in a key file, with its position.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {kind}")]
pub struct KeysError {
    /// Line and column.
    pub place: Place,
    /// The kind of error.
    pub kind: KeysErrorKind,
}

/// A kind of error in a key file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum KeysErrorKind {
    /// The file isn't TOML, or holds values other than keys.
    #[error("{0}")]
    Malformed(String),
    /// An unknown action, mode or motion.
    #[error("{0}")]
    Unknown(String),
    /// An invalid key.
    #[error("{0}")]
    InvalidKey(String),
    /// A key bound twice.
    #[error("{0}")]
    DuplicateKey(String),
}

impl Keys {
    /// Reads bindings; actions that the file doesn't name keep their default keys.
    ///
    /// # Errors
    /// [`KeysError`] with its line, if the file isn't TOML of actions and keys, or binds a key twice.
    pub fn read(text: &str) -> Result<Self, KeysError> {
        let at = |byte: usize, kind| KeysError { place: Place::in_text(text, byte), kind };
        let root = DeTable::parse(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or_default().to_owned();
            at(error.span().map_or(0, |span| span.start), KeysErrorKind::Malformed(message))
        })?;
        let mut assigned: Vec<(Chord, Target)> = Vec::new();
        let mut reassigned: Vec<Target> = Vec::new();
        let mut bind = |target: Target, value: &Spanned<DeValue<'_>>| {
            reassigned.push(target);
            for (chord, byte) in chords(value).map_err(|(byte, kind)| at(byte, kind))? {
                let clash =
                    assigned.iter().find(|(key, other)| *key == chord && clashes(*other, target));
                if let Some((_, other)) = clash {
                    let message = format!("{chord} is bound to `{}` already", name_of(*other));
                    return Err(at(byte, KeysErrorKind::DuplicateKey(message)));
                }
                assigned.push((chord, target));
            }
            Ok(())
        };
        for (name, value) in in_file_order(root.get_ref()) {
            let mode = MODES.into_iter().find(|mode| mode.to_string() == *name.get_ref());
            if let Some(mode) = mode {
                let DeValue::Table(table) = value.get_ref() else {
                    let message = format!("`{mode}` is a table of motions: write [{mode}]");
                    return Err(at(value.span().start, KeysErrorKind::Malformed(message)));
                };
                for (name, value) in in_file_order(table) {
                    let known = motions(mode).iter().map(|(_, motion)| *motion);
                    let found = known.clone().find(|motion| *motion == name.get_ref());
                    let Some(motion) = found else {
                        let message = unknown(name.get_ref(), "motion of this mode", known);
                        return Err(at(name.span().start, KeysErrorKind::Unknown(message)));
                    };
                    bind(Target::Motion(mode, motion), value)?;
                }
                continue;
            }
            let Some(place) = BINDINGS.iter().position(|one| one.name == name.get_ref()) else {
                let known = BINDINGS.iter().map(|binding| binding.name);
                let message = unknown(name.get_ref(), "action", known);
                return Err(at(name.span().start, KeysErrorKind::Unknown(message)));
            };
            bind(Target::Action(place), value)?;
        }
        // A key that the file binds loses its default action.
        let mut keys = Self::default();
        keys.bindings.retain(|(key, target)| {
            let is_taken = |(chord, by): &(Chord, Target)| chord == key && clashes(*by, *target);
            !reassigned.contains(target) && !assigned.iter().any(is_taken)
        });
        keys.bindings.extend(assigned);
        Ok(keys)
    }
}

/// A name and its value.
type NameAndValue<'t, 'a> = (&'t Spanned<Cow<'a, str>>, &'t Spanned<DeValue<'a>>);

/// The entries of a table in the order of the file.
fn in_file_order<'t, 'a>(table: &'t DeTable<'a>) -> Vec<NameAndValue<'t, 'a>> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    entries
}

/// Whether one key can't do both. Motions of different modes don't conflict.
fn clashes(one: Target, other: Target) -> bool {
    !matches!((one, other), (Target::Motion(a, _), Target::Motion(b, _)) if a != b)
}

fn name_of(target: Target) -> String {
    match target {
        Target::Action(at) => BINDINGS[at].name.to_owned(),
        Target::Motion(mode, name) => format!("{mode}.{name}"),
    }
}

fn unknown<'a>(name: &str, what: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    match nearest(name, known.clone()) {
        Some(meant) => format!("unknown {what} `{name}`: did you mean `{meant}`?"),
        None => format!("unknown {what} `{name}`: use {}", known.collect::<Vec<_>>().join(", ")),
    }
}

/// The keys of a value with their positions: a string, or an array of strings, which may be empty.
fn chords(value: &Spanned<DeValue<'_>>) -> Result<Vec<(Chord, usize)>, (usize, KeysErrorKind)> {
    let one = |value: &Spanned<DeValue<'_>>| {
        let start = value.span().start;
        let text = value.get_ref().as_str().ok_or_else(|| {
            let message = "a key is a string, as \"f\"; several are an array, as [\"f\", \"Home\"]";
            (start, KeysErrorKind::Malformed(message.to_owned()))
        })?;
        let chord = text.parse().map_err(|message| (start, KeysErrorKind::InvalidKey(message)))?;
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
    use crate::keys::{Action, Guide};
    use luxel::navigation::Mode;

    fn action(keys: &Keys, key: &str, mode: Mode) -> Option<Action> {
        keys.action(&key.parse().unwrap(), mode)
    }

    #[test]
    fn a_file_rebinds_keys_and_leaves_the_others() {
        let keys = Keys::read(
            "grid = \"w\"\nquit = [\"Ctrl+q\", \"F10\"]\nmeasure = []\n\
             [turntable]\nforward = \"Up\"\n",
        );
        let keys = keys.unwrap();
        let of = |key| action(&keys, key, Mode::Turntable);
        assert_eq!(of("w"), Some(Action::ToggleGuide(Guide::Grid)));
        assert_eq!((of("g"), of("q"), of("r")), (None, None, None));
        assert_eq!((of("Ctrl+q"), of("F10")), (Some(Action::Quit), Some(Action::Quit)));
        assert_eq!(of("Up"), "forward".parse().ok().map(Action::Motion));
        assert_eq!(of("s"), "back".parse().ok().map(Action::Motion));
        assert_eq!(action(&keys, "Up", Mode::Mouselook), None);
        assert_eq!(of("f"), Some(Action::Fit));
        assert_eq!(Keys::read("").unwrap(), Keys::default());
    }

    #[test]
    fn errors_have_their_line() {
        for (text, line, part) in [
            ("quit = \"q\"\nfitt = \"x\"\n", 2, "did you mean `fit`?"),
            ("\n\nquit = 3\n", 3, "a key is a string"),
            ("quit = [\"q\",\n \"Foo\"]\n", 2, "`Foo` is not a key"),
            ("fit = \"g\"\nquit = \"g\"\n", 2, "g is bound to `fit` already"),
            ("fit = \"w\"\n[flying]\nfaster = \"w\"\n", 3, "w is bound to `fit` already"),
            ("[flying]\nfoward = \"w\"\n", 2, "unknown motion"),
            ("quit = \n", 1, ""),
            ("[quit]\na = 1\n", 1, "a key is a string"),
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
