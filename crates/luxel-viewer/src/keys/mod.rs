//! Key bindings: a table of actions with default keys, which a user's file may rebind.

mod chord;
mod file;

pub(crate) use chord::{Chord, KeyName};
pub use file::{KeysError, KeysErrorKind};
use luxel::navigation::{Command, Mode, StandardView};

/// An action bound to keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Action {
    /// Closes what is open; quits if nothing is, and nothing would be lost.
    Close,
    /// Quits.
    Quit,
    /// Toggles the help.
    Help,
    /// Toggles the panels.
    Panels,
    /// Moves keyboard focus to the panels.
    FocusPanels,
    /// Explains the pixel under the pointer.
    Explain,
    /// Copies the command line that draws the view.
    CopyCommand,
    /// Saves a scene file.
    SaveScene,
    /// Adds the point under the pointer to the measurement.
    Measure,
    /// Opens the dialog for a model.
    Open,
    /// Opens the next (true) or previous file.
    StepFile(bool),
    /// Fits the selection, or all visible objects, into view.
    Fit,
    /// Fits the whole scene into view.
    FitAll,
    /// Hides the selected objects.
    Hide,
    /// Hides all but the selected objects.
    Isolate,
    /// Shows all objects.
    ShowAll,
    /// Goes to a standard view.
    View(StandardView),
    /// Toggles between perspective and orthographic lens.
    ToggleLens,
    /// Saves a picture.
    Screenshot,
    /// Sets the navigation mode.
    Mode(Mode),
    /// Steps to the next navigation mode.
    NextMode,
    /// Levels the horizon.
    Level,
    /// Toggles a guide.
    ToggleGuide(Guide),
    /// Steps to the next way to draw edges.
    NextEdges,
    /// Steps to the next shading mode.
    NextShading,
    /// Steps to the next (true) or previous layer.
    StepLayer(bool),
    /// Toggles the comparison of two display settings.
    Compare,
    /// Toggles the difference of two display settings.
    Difference,
    /// Moves the camera as long as the key is down.
    Motion(Command),
}

/// A guide that can be shown with the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Guide {
    Grid,
    Axes,
    Boxes,
    Normals,
}

/// An action with its name and default keys.
pub(crate) struct Binding {
    /// The action's name in key files.
    pub(crate) name: &'static str,
    action: Action,
    /// The default keys.
    keys: &'static [&'static str],
    /// A description for the help; empty where another line covers the action.
    pub(crate) about: &'static str,
}

impl Binding {
    /// The action.
    pub(crate) fn action(&self) -> Action {
        self.action
    }
}

const fn bind(
    name: &'static str,
    action: Action,
    keys: &'static [&'static str],
    about: &'static str,
) -> Binding {
    Binding { name, action, keys, about }
}

/// All actions with default keys.
pub(crate) static BINDINGS: &[Binding] = &[
    bind("fit", Action::Fit, &["f"], "fit the selection, or all"),
    bind("fit-all", Action::FitAll, &["Home"], "fit all into view"),
    bind("hide", Action::Hide, &["x", "Delete"], "hide the selection"),
    bind("isolate", Action::Isolate, &["Shift+h"], "hide all but the selection"),
    bind("show-all", Action::ShowAll, &["Alt+h"], "show all"),
    bind("measure", Action::Measure, &["r"], "measure, from and to"),
    bind("view-front", Action::View(StandardView::Front), &["1"], "front; with Ctrl back"),
    bind("view-right", Action::View(StandardView::Right), &["3"], "right; with Ctrl left"),
    bind("view-top", Action::View(StandardView::Top), &["7"], "top; with Ctrl bottom"),
    bind("view-back", Action::View(StandardView::Back), &["Ctrl+1"], ""),
    bind("view-left", Action::View(StandardView::Left), &["Ctrl+3"], ""),
    bind("view-bottom", Action::View(StandardView::Bottom), &["Ctrl+7"], ""),
    bind("lens", Action::ToggleLens, &["5"], "parallel rays, perspective"),
    bind("level", Action::Level, &["n"], "level horizon"),
    bind("edges", Action::NextEdges, &["z"], "edges, wireframe, neither"),
    bind("shading", Action::NextShading, &["t"], "next shading mode"),
    bind("layer", Action::StepLayer(true), &["y"], "next layer; with Shift back"),
    bind("previous-layer", Action::StepLayer(false), &["Shift+y"], ""),
    bind("grid", Action::ToggleGuide(Guide::Grid), &["g"], "the ground's grid"),
    bind("axes", Action::ToggleGuide(Guide::Axes), &["Shift+g"], "the world's axes"),
    bind("boxes", Action::ToggleGuide(Guide::Boxes), &["b"], "bounding boxes"),
    bind("normals", Action::ToggleGuide(Guide::Normals), &["p"], "normals"),
    bind("split", Action::Compare, &["v"], "compare two looks"),
    bind("difference", Action::Difference, &["Shift+v"], "their difference"),
    bind("open", Action::Open, &["o", "Shift+o", "Ctrl+o"], "open a model"),
    bind("next-file", Action::StepFile(true), &["Right", "PageDown"], "next file"),
    bind("previous-file", Action::StepFile(false), &["Left", "PageUp"], "previous file"),
    bind("panels", Action::Panels, &["Tab"], "panels"),
    bind("into-panels", Action::FocusPanels, &["Shift+Tab"], "focus the panels"),
    bind("explain", Action::Explain, &["Space"], "explain the pixel"),
    bind("screenshot", Action::Screenshot, &["F12"], "picture into a file"),
    bind("line", Action::CopyCommand, &["Ctrl+c"], "copy its `luxel render`"),
    bind("save", Action::SaveScene, &["Ctrl+s"], "save as a scene file"),
    bind("help", Action::Help, &["h", "?", "F1"], "this help"),
    bind("close", Action::Close, &["Escape"], "close what is open, or quit"),
    bind("quit", Action::Quit, &["q"], "quit"),
    bind("next-mode", Action::NextMode, &["m"], ""),
    bind("mode-turntable", Action::Mode(Mode::Turntable), &["F2"], ""),
    bind("mode-rolling-ball", Action::Mode(Mode::RollingBall), &["F3"], ""),
    bind("mode-absolute", Action::Mode(Mode::Absolute), &["F4"], ""),
    bind("mode-look-at", Action::Mode(Mode::LookAt), &["F5"], ""),
    bind("mode-flying", Action::Mode(Mode::Flying), &["F6"], ""),
    bind("mode-mouselook", Action::Mode(Mode::Mouselook), &["F7"], ""),
];

/// The navigation modes, in the order of their keys.
pub(crate) const MODES: [Mode; 6] = [
    Mode::Turntable,
    Mode::RollingBall,
    Mode::Absolute,
    Mode::LookAt,
    Mode::Flying,
    Mode::Mouselook,
];

/// The navigation mode after this one.
pub(crate) fn next_mode(mode: Mode) -> Mode {
    let at = MODES.iter().position(|one| *one == mode).unwrap_or(0);
    MODES[(at + 1) % MODES.len()]
}

/// The default keys of motions: left hand on `w a s d e c`, right hand on `i j k l , .`.
fn motions(mode: Mode) -> &'static [(&'static str, &'static str)] {
    match mode {
        Mode::Turntable => &[
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
        ],
        Mode::RollingBall => &[
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
            (",", "roll-left"),
            (".", "roll-right"),
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
            (",", "turn-z-"),
            (".", "turn-z+"),
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
            (",", "target-y-"),
            (".", "target-y+"),
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
    }
}

/// The target of a key: an action, or a motion of one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    /// An index into [`BINDINGS`].
    Action(usize),
    /// The mode, and the motion's name.
    Motion(Mode, &'static str),
}

/// Key bindings.
#[derive(Clone, Debug, PartialEq)]
pub struct Keys {
    bindings: Vec<(Chord, Target)>,
}

impl Default for Keys {
    fn default() -> Self {
        let actions = BINDINGS.iter().enumerate().flat_map(|(at, binding)| {
            binding.keys.iter().map(move |key| (*key, Target::Action(at)))
        });
        let motions = MODES.into_iter().flat_map(|mode| {
            motions(mode).iter().map(move |(key, name)| (*key, Target::Motion(mode, name)))
        });
        let bindings = actions.chain(motions);
        let bindings = bindings.filter_map(|(key, target)| Some((key.parse().ok()?, target)));
        Self { bindings: bindings.collect() }
    }
}

impl Keys {
    /// The action of a key in a mode. Keys of motions also work with Shift.
    pub(crate) fn action(&self, chord: &Chord, mode: Mode) -> Option<Action> {
        let plain = Chord { shift: false, ..chord.clone() };
        self.bindings
            .iter()
            .find_map(|(key, target)| match target {
                Target::Action(at) if key == chord => Some(BINDINGS[*at].action),
                _ => None,
            })
            .or_else(|| {
                self.bindings.iter().find_map(|(key, target)| match target {
                    Target::Motion(of, name) if *of == mode && (key == chord || *key == plain) => {
                        name.parse().ok().map(Action::Motion)
                    }
                    _ => None,
                })
            })
    }

    /// The keys of an action, for the help.
    pub(crate) fn of(&self, action: Action) -> String {
        let is_it = |target: &Target| matches!(target, Target::Action(at) if BINDINGS[*at].action == action);
        let keys = self.bindings.iter().filter(|(_, target)| is_it(target));
        keys.map(|(key, _)| key.to_string()).collect::<Vec<_>>().join("  ")
    }

    /// The first of an action's keys, for a hint.
    pub(crate) fn first_of(&self, action: Action) -> String {
        self.of(action).split("  ").next().unwrap_or_default().to_owned()
    }

    /// The motions of a mode and their keys, in order.
    pub(crate) fn motions(&self, mode: Mode) -> Vec<(String, &'static str)> {
        let of_mode = |(key, target): &(Chord, Target)| match target {
            Target::Motion(of, name) if *of == mode => Some((key.to_string(), *name)),
            _ => None,
        };
        self.bindings.iter().filter_map(of_mode).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn action(keys: &Keys, key: &str) -> Option<Action> {
        keys.action(&key.parse().unwrap(), Mode::Turntable)
    }

    #[test]
    fn no_key_is_bound_twice_and_names_are_unique() {
        let keys = Keys::default();
        let named: usize = BINDINGS.iter().map(|binding| binding.keys.len()).sum();
        let moving: usize = MODES.into_iter().map(|mode| motions(mode).len()).sum();
        assert_eq!(keys.bindings.len(), named + moving, "a default key is invalid");
        for (at, (key, target)) in keys.bindings.iter().enumerate() {
            for (other, with) in &keys.bindings[..at] {
                let is_apart = matches!((target, with), (Target::Motion(a, _), Target::Motion(b, _)) if a != b);
                assert!(key != other || is_apart, "{key}: {target:?} {with:?}");
            }
        }
        for (at, binding) in BINDINGS.iter().enumerate() {
            assert!(BINDINGS[..at].iter().all(|other| other.name != binding.name));
        }
    }

    #[test]
    fn every_motion_is_a_command() {
        for mode in MODES {
            for (key, name) in motions(mode) {
                assert!(name.parse::<Command>().is_ok(), "{mode}: {name}");
                let chord = key.parse().unwrap();
                assert!(matches!(Keys::default().action(&chord, mode), Some(Action::Motion(_))));
            }
        }
    }

    #[test]
    fn shift_ctrl_and_alt_distinguish_keys() {
        let keys = Keys::default();
        assert_eq!(action(&keys, "h"), Some(Action::Help));
        assert_eq!(action(&keys, "?"), Some(Action::Help));
        assert_eq!(action(&keys, "Shift+h"), Some(Action::Isolate));
        assert_eq!(action(&keys, "Alt+h"), Some(Action::ShowAll));
        assert_eq!(action(&keys, "3"), Some(Action::View(StandardView::Right)));
        assert_eq!(action(&keys, "Ctrl+3"), Some(Action::View(StandardView::Left)));
        assert_eq!(action(&keys, "Ctrl+c"), Some(Action::CopyCommand));
        assert!(matches!(action(&keys, "c"), Some(Action::Motion(_))));
        assert!(matches!(action(&keys, "Shift+w"), Some(Action::Motion(_))));
        assert_eq!(action(&keys, "Ctrl+w"), None);
    }
}
