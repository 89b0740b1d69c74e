//! What keys do: a table of actions with the keys they have, unless a file of the user's says other ones.

mod chord;
mod file;

pub(crate) use chord::{Chord, KeyName};
pub use file::{KeysError, KeysErrorKind};
use luxel::navigation::{Command, Mode, StandardView};

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Action {
    /// Leave.
    Quit,
    /// Show or hide the help.
    Help,
    /// Show or hide the panels.
    Panels,
    /// The keyboard into the panels.
    IntoPanels,
    /// The ledger of the pixel under the pointer.
    Explain,
    /// The line of a terminal that draws what is seen.
    Line,
    /// What is seen into a scene file.
    Save,
    /// A point of the ruler, under the pointer.
    Measure,
    /// A model, by its name.
    Open,
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
    /// Something that is drawn, or not.
    Show(Shown),
    /// The next way to draw edges.
    NextEdges,
    /// The next shading mode.
    NextShading,
    /// The next layer, or the one before.
    StepLayer(bool),
    /// Two looks side by side, or one.
    Split,
    /// The difference of two looks, or both.
    Difference,
    /// A motion, as long as the key is down.
    Hold(Command),
}

/// What helps to see how things stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shown {
    Grid,
    Axes,
    Boxes,
    Normals,
}

/// An action that keys can be bound to.
pub(crate) struct Binding {
    /// What files of keys call it.
    pub(crate) name: &'static str,
    action: Action,
    /// The keys it has.
    keys: &'static [&'static str],
    /// What it does, for the help; nothing, where another line says it too.
    pub(crate) about: &'static str,
}

impl Binding {
    /// What the keys ask for.
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

/// All actions.
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
    bind("lens", Action::Lens, &["5"], "parallel rays, perspective"),
    bind("level", Action::Level, &["n"], "level horizon"),
    bind("edges", Action::NextEdges, &["z"], "edges, wireframe, neither"),
    bind("shading", Action::NextShading, &["t"], "next shading mode"),
    bind("layer", Action::StepLayer(true), &["y"], "next layer; with Shift back"),
    bind("previous-layer", Action::StepLayer(false), &["Shift+y"], ""),
    bind("grid", Action::Show(Shown::Grid), &["g"], "the ground's grid"),
    bind("axes", Action::Show(Shown::Axes), &["Shift+g"], "the world's axes"),
    bind("boxes", Action::Show(Shown::Boxes), &["b"], "bounding boxes"),
    bind("normals", Action::Show(Shown::Normals), &["p"], "normals"),
    bind("split", Action::Split, &["v"], "compare two looks"),
    bind("difference", Action::Difference, &["Shift+v"], "their difference"),
    bind("open", Action::Open, &["o", "Shift+o", "Ctrl+o"], "open a model"),
    bind("next-file", Action::Step(true), &["Right", "PageDown"], "next file"),
    bind("previous-file", Action::Step(false), &["Left", "PageUp"], "previous file"),
    bind("panels", Action::Panels, &["Tab"], "panels"),
    bind("into-panels", Action::IntoPanels, &["Shift+Tab"], "the keyboard into them"),
    bind("explain", Action::Explain, &["Space"], "explain the pixel"),
    bind("screenshot", Action::Screenshot, &["F12"], "picture into a file"),
    bind("line", Action::Line, &["Ctrl+c"], "copy its `luxel render`"),
    bind("save", Action::Save, &["Ctrl+s"], "save as a scene file"),
    bind("help", Action::Help, &["h", "?", "F1"], "this help"),
    bind("quit", Action::Quit, &["q", "Escape"], "quit"),
    bind("next-mode", Action::NextMode, &["m"], ""),
    bind("mode-turntable", Action::Mode(Mode::Turntable), &["F2"], ""),
    bind("mode-rolling-ball", Action::Mode(Mode::RollingBall), &["F3"], ""),
    bind("mode-absolute", Action::Mode(Mode::Absolute), &["F4"], ""),
    bind("mode-look-at", Action::Mode(Mode::LookAt), &["F5"], ""),
    bind("mode-flying", Action::Mode(Mode::Flying), &["F6"], ""),
    bind("mode-mouselook", Action::Mode(Mode::Mouselook), &["F7"], ""),
];

/// The ways to navigate, in the order of their keys.
pub(crate) const MODES: [Mode; 6] = [
    Mode::Turntable,
    Mode::RollingBall,
    Mode::Absolute,
    Mode::LookAt,
    Mode::Flying,
    Mode::Mouselook,
];

/// The way to navigate after this one.
pub(crate) fn next_mode(mode: Mode) -> Mode {
    let at = MODES.iter().position(|one| *one == mode).unwrap_or(0);
    MODES[(at + 1) % MODES.len()]
}

/// The motions of held keys: left hand on `w a s d e c`, right hand on `i j k l , .`.
fn motions(mode: Mode) -> &'static [(&'static str, &'static str)] {
    match mode {
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

/// What is bound to a key: an action, or a motion of one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bound {
    /// By its place in [`BINDINGS`].
    Action(usize),
    /// The mode and the name of the motion.
    Motion(Mode, &'static str),
}

/// Which keys do what.
#[derive(Clone, Debug, PartialEq)]
pub struct Keys {
    bound: Vec<(Chord, Bound)>,
}

impl Default for Keys {
    fn default() -> Self {
        let actions = BINDINGS.iter().enumerate().flat_map(|(at, binding)| {
            binding.keys.iter().map(move |key| (*key, Bound::Action(at)))
        });
        let motions = MODES.into_iter().flat_map(|mode| {
            motions(mode).iter().map(move |(key, name)| (*key, Bound::Motion(mode, name)))
        });
        let bound = actions.chain(motions);
        let bound = bound.filter_map(|(key, bound)| Some((key.parse().ok()?, bound)));
        Self { bound: bound.collect() }
    }
}

impl Keys {
    /// What a key does in a mode. A motion's key moves with Shift too.
    pub(crate) fn action(&self, chord: &Chord, mode: Mode) -> Option<Action> {
        let plain = Chord { shift: false, ..chord.clone() };
        self.bound
            .iter()
            .find_map(|(key, bound)| match bound {
                Bound::Action(at) if key == chord => Some(BINDINGS[*at].action),
                _ => None,
            })
            .or_else(|| {
                self.bound.iter().find_map(|(key, bound)| match bound {
                    Bound::Motion(of, name) if *of == mode && (key == chord || *key == plain) => {
                        name.parse().ok().map(Action::Hold)
                    }
                    _ => None,
                })
            })
    }

    /// The keys of an action, as the help writes them.
    pub(crate) fn of(&self, action: Action) -> String {
        let is_it =
            |bound: &Bound| matches!(bound, Bound::Action(at) if BINDINGS[*at].action == action);
        let keys = self.bound.iter().filter(|(_, bound)| is_it(bound));
        keys.map(|(key, _)| key.to_string()).collect::<Vec<_>>().join("  ")
    }

    /// The first of an action's keys, for a hint.
    pub(crate) fn first_of(&self, action: Action) -> String {
        self.of(action).split("  ").next().unwrap_or_default().to_owned()
    }

    /// The keys of the motions of a mode with what they do, in order.
    pub(crate) fn motions(&self, mode: Mode) -> Vec<(String, &'static str)> {
        let of_mode = |(key, bound): &(Chord, Bound)| match bound {
            Bound::Motion(of, name) if *of == mode => Some((key.to_string(), *name)),
            _ => None,
        };
        self.bound.iter().filter_map(of_mode).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn action(keys: &Keys, key: &str) -> Option<Action> {
        keys.action(&key.parse().unwrap(), Mode::Turntable)
    }

    #[test]
    fn no_key_is_bound_twice_and_every_name_is_one() {
        let keys = Keys::default();
        let named: usize = BINDINGS.iter().map(|binding| binding.keys.len()).sum();
        let moving: usize = MODES.into_iter().map(|mode| motions(mode).len()).sum();
        assert_eq!(keys.bound.len(), named + moving, "a default is no key");
        for (at, (key, bound)) in keys.bound.iter().enumerate() {
            for (other, with) in &keys.bound[..at] {
                let is_apart =
                    matches!((bound, with), (Bound::Motion(a, _), Bound::Motion(b, _)) if a != b);
                assert!(key != other || is_apart, "{key}: {bound:?} {with:?}");
            }
        }
        for (at, binding) in BINDINGS.iter().enumerate() {
            assert!(BINDINGS[..at].iter().all(|other| other.name != binding.name));
        }
    }

    #[test]
    fn every_motion_is_a_command_that_there_is() {
        for mode in MODES {
            for (key, name) in motions(mode) {
                assert!(name.parse::<Command>().is_ok(), "{mode}: {name}");
                let chord = key.parse().unwrap();
                assert!(matches!(Keys::default().action(&chord, mode), Some(Action::Hold(_))));
            }
        }
    }

    #[test]
    fn shift_ctrl_and_alt_tell_keys_apart() {
        let keys = Keys::default();
        assert_eq!(action(&keys, "h"), Some(Action::Help));
        assert_eq!(action(&keys, "?"), Some(Action::Help));
        assert_eq!(action(&keys, "Shift+h"), Some(Action::Isolate));
        assert_eq!(action(&keys, "Alt+h"), Some(Action::ShowAll));
        assert_eq!(action(&keys, "3"), Some(Action::View(StandardView::Right)));
        assert_eq!(action(&keys, "Ctrl+3"), Some(Action::View(StandardView::Left)));
        assert_eq!(action(&keys, "Ctrl+c"), Some(Action::Line));
        assert!(matches!(action(&keys, "c"), Some(Action::Hold(_))));
        assert!(matches!(action(&keys, "Shift+w"), Some(Action::Hold(_))));
        assert_eq!(action(&keys, "Ctrl+w"), None);
    }
}
