//! What keys do.

use luxel::navigation::{Command, Mode, StandardView};
use winit::keyboard::{Key, ModifiersState, NamedKey};

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Action {
    /// Leave.
    Quit,
    /// Show or hide the help.
    Help,
    /// Show or hide the panels.
    Panels,
    /// The line of a terminal that draws what is seen.
    Line,
    /// A point of the ruler, under the pointer.
    Measure,
    /// The next file, or the one before.
    Step(bool),
    /// What is selected into view; all that is shown, if nothing is.
    Fit,
    /// All of the scene into view.
    FitAll,
    /// What is selected is not drawn any more.
    Hide,
    /// Only what is selected is drawn.
    Isolate,
    /// Everything is drawn.
    ShowAll,
    /// A side to look from.
    View(StandardView),
    /// Parallel rays or a perspective.
    Lens,
    /// A picture of the window into a file.
    Screenshot,
    /// Another way to navigate.
    Mode(Mode),
    /// The next way to navigate.
    NextMode,
    /// A level horizon.
    Level,
    /// A motion, as long as the key is down.
    Hold(Command),
}

/// The ways to navigate, in the order of their keys.
pub(crate) const MODES: [(Mode, &str); 6] = [
    (Mode::Turntable, "F2"),
    (Mode::RollingBall, "F3"),
    (Mode::Absolute, "F4"),
    (Mode::LookAt, "F5"),
    (Mode::Flying, "F6"),
    (Mode::Mouselook, "F7"),
];

/// What a key does in a mode. With Ctrl, views are those from the other side; with Shift and Alt, `h`
/// hides what is not selected and shows everything: as in Blender.
pub(crate) fn action(key: &Key, modifiers: ModifiersState, mode: Mode) -> Option<Action> {
    let is_ctrl_down = modifiers.control_key();
    let view = |view, opposite| Some(Action::View(if is_ctrl_down { opposite } else { view }));
    match key {
        Key::Named(named) => Some(match named {
            NamedKey::Escape => Action::Quit,
            NamedKey::Home => Action::FitAll,
            NamedKey::Delete => Action::Hide,
            NamedKey::Tab => Action::Panels,
            NamedKey::ArrowRight | NamedKey::PageDown => Action::Step(true),
            NamedKey::ArrowLeft | NamedKey::PageUp => Action::Step(false),
            NamedKey::F1 => Action::Help,
            NamedKey::F2 => Action::Mode(Mode::Turntable),
            NamedKey::F3 => Action::Mode(Mode::RollingBall),
            NamedKey::F4 => Action::Mode(Mode::Absolute),
            NamedKey::F5 => Action::Mode(Mode::LookAt),
            NamedKey::F6 => Action::Mode(Mode::Flying),
            NamedKey::F7 => Action::Mode(Mode::Mouselook),
            NamedKey::F12 => Action::Screenshot,
            _ => return None,
        }),
        Key::Character(text) => match text.to_lowercase().as_str() {
            "1" => view(StandardView::Front, StandardView::Back),
            "3" => view(StandardView::Right, StandardView::Left),
            "7" => view(StandardView::Top, StandardView::Bottom),
            "c" if is_ctrl_down => Some(Action::Line),
            _ if is_ctrl_down => None,
            "q" => Some(Action::Quit),
            "h" if modifiers.shift_key() => Some(Action::Isolate),
            "h" if modifiers.alt_key() => Some(Action::ShowAll),
            "r" => Some(Action::Measure),
            "x" => Some(Action::Hide),
            "h" | "?" => Some(Action::Help),
            "f" => Some(Action::Fit),
            "5" => Some(Action::Lens),
            "m" => Some(Action::NextMode),
            "n" => Some(Action::Level),
            letter => held(letter, mode).and_then(|name| name.parse().ok()).map(Action::Hold),
        },
        _ => None,
    }
}

/// The commands of held keys: left hand on `w a s d e c`, right hand on `i j k l u o`.
pub(crate) fn held(letter: &str, mode: Mode) -> Option<&'static str> {
    let keys: &[(&str, &str)] = match mode {
        Mode::Turntable | Mode::RollingBall => &[
            ("w", "forward"),
            ("s", "back"),
            ("a", "left"),
            ("d", "right"),
            ("e", "up"),
            ("c", "down"),
            ("i", "orbit-up"),
            ("k", "orbit-down"),
            ("j", "orbit-left"),
            ("l", "orbit-right"),
            ("u", "roll-left"),
            ("o", "roll-right"),
        ],
        Mode::Absolute => &[
            ("a", "x-"),
            ("d", "x+"),
            ("c", "y-"),
            ("e", "y+"),
            ("w", "z-"),
            ("s", "z+"),
            ("i", "turn-x-"),
            ("k", "turn-x+"),
            ("j", "turn-y-"),
            ("l", "turn-y+"),
            ("u", "turn-z-"),
            ("o", "turn-z+"),
        ],
        Mode::LookAt => &[
            ("a", "x-"),
            ("d", "x+"),
            ("c", "y-"),
            ("e", "y+"),
            ("w", "z-"),
            ("s", "z+"),
            ("j", "target-x-"),
            ("l", "target-x+"),
            ("u", "target-y-"),
            ("o", "target-y+"),
            ("i", "target-z-"),
            ("k", "target-z+"),
        ],
        Mode::Flying => &[
            ("w", "faster"),
            ("s", "slower"),
            ("a", "yaw-left"),
            ("d", "yaw-right"),
            ("i", "pitch-up"),
            ("k", "pitch-down"),
            ("j", "roll-left"),
            ("l", "roll-right"),
            ("e", "up"),
            ("c", "down"),
        ],
        Mode::Mouselook => &[
            ("w", "forward"),
            ("s", "back"),
            ("a", "left"),
            ("d", "right"),
            ("e", "up"),
            ("c", "down"),
            ("i", "pitch-up"),
            ("k", "pitch-down"),
            ("j", "yaw-left"),
            ("l", "yaw-right"),
        ],
    };
    keys.iter().find(|(key, _)| *key == letter).map(|(_, command)| *command)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_a_command_that_there_is() {
        for (mode, _) in MODES {
            for letter in 'a'..='z' {
                if let Some(name) = held(&letter.to_string(), mode) {
                    assert!(name.parse::<Command>().is_ok(), "{mode} {letter}: {name}");
                    let key = Key::Character(letter.to_string().into());
                    let action = action(&key, ModifiersState::empty(), mode);
                    assert!(matches!(action, Some(Action::Hold(_))), "{mode} {letter}: {action:?}");
                }
            }
        }
    }

    #[test]
    fn ctrl_gives_the_view_from_the_other_side() {
        let of = |modifiers| action(&Key::Character("3".into()), modifiers, Mode::Turntable);
        assert_eq!(of(ModifiersState::empty()), Some(Action::View(StandardView::Right)));
        assert_eq!(of(ModifiersState::CONTROL), Some(Action::View(StandardView::Left)));
        let c = |modifiers| action(&Key::Character("c".into()), modifiers, Mode::Turntable);
        assert_eq!(c(ModifiersState::CONTROL), Some(Action::Line));
        assert!(matches!(c(ModifiersState::empty()), Some(Action::Hold(_))));
    }

    #[test]
    fn h_helps_isolates_or_shows_all() {
        let of = |text: &str, modifiers| {
            action(&Key::Character(text.into()), modifiers, Mode::Turntable)
        };
        assert_eq!(of("h", ModifiersState::empty()), Some(Action::Help));
        assert_eq!(of("?", ModifiersState::SHIFT), Some(Action::Help));
        assert_eq!(of("H", ModifiersState::SHIFT), Some(Action::Isolate));
        assert_eq!(of("h", ModifiersState::ALT), Some(Action::ShowAll));
    }
}
