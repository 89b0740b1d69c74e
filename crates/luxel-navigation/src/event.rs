//! Events: pointer gestures, the wheel, keyboard commands, and requests of the host.

use glam::{DMat4, DVec2, DVec3};
use luxel_scene::Bounds;

/// An event that moves the camera.
///
/// Positions are in pixels from the window's upper left. The host may pass the world-space point under
/// them; otherwise the pivot's distance is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// No event: only time passes.
    Wait,
    /// Sets the navigation mode. Motion stops; turntable and mouselook make the camera upright.
    Mode(Mode),
    /// Starts a gesture.
    Grab {
        /// The gesture.
        gesture: Gesture,
        /// The pointer's position.
        at: DVec2,
        /// The point there, in world space.
        point: Option<DVec3>,
    },
    /// Moves the pointer. No effect without a gesture.
    Drag {
        /// The new position.
        at: DVec2,
    },
    /// Ends the gesture.
    Release,
    /// Turns the wheel: positive notches zoom towards the point under the pointer, negative ones away
    /// from it.
    Wheel {
        /// The number of notches.
        notches: f64,
        /// The pointer's position.
        at: DVec2,
        /// The point there, in world space.
        point: Option<DVec3>,
    },
    /// Presses a command's key, until it is lifted.
    Press(Command),
    /// Lifts a command's key.
    Lift(Command),
    /// Executes a command by some steps at once.
    Tap {
        /// The command.
        command: Command,
        /// The number of steps.
        steps: f64,
    },
    /// Sets the pivot of rotations. The picture stays.
    Pivot(DVec3),
    /// Goes to a standard view of the pivot; the distance stays.
    View(StandardView),
    /// Fits bounds, or the whole scene, into view; the direction stays.
    Fit(Option<Bounds>),
    /// Levels the horizon; eye and direction stay.
    Level,
    /// Moves the camera, with a transition, to a pose of the host's choice.
    Go {
        /// The target view matrix.
        view_from_world: DMat4,
        /// The pivot there.
        pivot: DVec3,
        /// The scale of the orthographic height there, above 0.
        scale: f64,
    },
    /// Sets the view matrix at once. The scale of the orthographic height is reset to 1.
    Place(DMat4),
}

/// The navigation modes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// The keyboard turns and moves the camera about and along the axes of the world.
    Absolute,
    /// The keyboard moves eye and target along the axes of the world.
    LookAt,
    /// The scene turns under the hand like a ball that rolls under it.
    RollingBall,
    /// Roll, pitch, yaw about the camera's own axes, and a throttle.
    Flying,
    /// The mouse turns, the keys walk.
    Mouselook,
    /// The camera moves around the pivot, the horizon stays level.
    #[default]
    Turntable,
}

/// Pointer gestures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gesture {
    /// Rotates, depending on the mode.
    Turn,
    /// Pans: the grabbed point stays under the pointer.
    Pan,
    /// Zooms: upwards towards the grabbed point, downwards away from it.
    Zoom,
}

/// Standard views. The front is in the direction of +Z if +Y is up; for other up axes that frame is
/// rotated ([`luxel_scene::Viewpoint::axes`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandardView {
    /// From the front.
    Front,
    /// From behind.
    Back,
    /// From the right.
    Right,
    /// From the left.
    Left,
    /// From above, the front at the bottom.
    Top,
    /// From below, the front at the top.
    Bottom,
}

/// An axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

/// A keyboard command: a motion, forwards or backwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Command {
    /// The motion.
    pub drive: Drive,
    /// Along the axis, or about it by the right-hand rule; otherwise the opposite.
    pub is_positive: bool,
}

/// Kinds of motion. Each mode supports some of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// The camera, or the eye alone, along an axis of the world.
    Move(Axis),
    /// The camera about an axis of the world.
    Turn(Axis),
    /// The target along an axis of the world.
    Target(Axis),
    /// The camera along an axis of its own: right, up, back.
    Walk(Axis),
    /// The camera about an axis of its own: pitch up, yaw left, roll left.
    Own(Axis),
    /// Around the pivot, to the right.
    OrbitSideways,
    /// Around the pivot, upwards.
    OrbitUpwards,
    /// The speed ahead.
    Throttle,
}

/// Values with a name in logs.
pub(crate) trait Named: Copy + PartialEq + 'static {
    /// All values with their names.
    const NAMES: &'static [(&'static str, Self)];

    fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, one)| *one == self).map_or("", |(name, _)| name)
    }

    fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(own, _)| *own == name).map(|(_, one)| *one)
    }
}

impl Named for Mode {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("absolute", Self::Absolute),
        ("look-at", Self::LookAt),
        ("rolling-ball", Self::RollingBall),
        ("flying", Self::Flying),
        ("mouselook", Self::Mouselook),
        ("turntable", Self::Turntable),
    ];
}

impl Named for Gesture {
    const NAMES: &'static [(&'static str, Self)] =
        &[("turn", Self::Turn), ("pan", Self::Pan), ("zoom", Self::Zoom)];
}

impl Named for StandardView {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("front", Self::Front),
        ("back", Self::Back),
        ("right", Self::Right),
        ("left", Self::Left),
        ("top", Self::Top),
        ("bottom", Self::Bottom),
    ];
}

const fn plus(drive: Drive) -> Command {
    Command { drive, is_positive: true }
}

const fn minus(drive: Drive) -> Command {
    Command { drive, is_positive: false }
}

impl Named for Command {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("x+", plus(Drive::Move(Axis::X))),
        ("x-", minus(Drive::Move(Axis::X))),
        ("y+", plus(Drive::Move(Axis::Y))),
        ("y-", minus(Drive::Move(Axis::Y))),
        ("z+", plus(Drive::Move(Axis::Z))),
        ("z-", minus(Drive::Move(Axis::Z))),
        ("turn-x+", plus(Drive::Turn(Axis::X))),
        ("turn-x-", minus(Drive::Turn(Axis::X))),
        ("turn-y+", plus(Drive::Turn(Axis::Y))),
        ("turn-y-", minus(Drive::Turn(Axis::Y))),
        ("turn-z+", plus(Drive::Turn(Axis::Z))),
        ("turn-z-", minus(Drive::Turn(Axis::Z))),
        ("target-x+", plus(Drive::Target(Axis::X))),
        ("target-x-", minus(Drive::Target(Axis::X))),
        ("target-y+", plus(Drive::Target(Axis::Y))),
        ("target-y-", minus(Drive::Target(Axis::Y))),
        ("target-z+", plus(Drive::Target(Axis::Z))),
        ("target-z-", minus(Drive::Target(Axis::Z))),
        ("right", plus(Drive::Walk(Axis::X))),
        ("left", minus(Drive::Walk(Axis::X))),
        ("up", plus(Drive::Walk(Axis::Y))),
        ("down", minus(Drive::Walk(Axis::Y))),
        ("back", plus(Drive::Walk(Axis::Z))),
        ("forward", minus(Drive::Walk(Axis::Z))),
        ("pitch-up", plus(Drive::Own(Axis::X))),
        ("pitch-down", minus(Drive::Own(Axis::X))),
        ("yaw-left", plus(Drive::Own(Axis::Y))),
        ("yaw-right", minus(Drive::Own(Axis::Y))),
        ("roll-left", plus(Drive::Own(Axis::Z))),
        ("roll-right", minus(Drive::Own(Axis::Z))),
        ("orbit-right", plus(Drive::OrbitSideways)),
        ("orbit-left", minus(Drive::OrbitSideways)),
        ("orbit-up", plus(Drive::OrbitUpwards)),
        ("orbit-down", minus(Drive::OrbitUpwards)),
        ("faster", plus(Drive::Throttle)),
        ("slower", minus(Drive::Throttle)),
    ];
}

macro_rules! display_and_parse {
    ($($named:ty, $what:literal;)*) => {$(
        impl std::fmt::Display for $named {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str(self.name())
            }
        }

        impl std::str::FromStr for $named {
            type Err = UnknownName;

            fn from_str(text: &str) -> Result<Self, UnknownName> {
                Self::named(text).ok_or_else(|| UnknownName {
                    what: $what,
                    name: text.to_owned(),
                    known: Self::NAMES.iter().map(|(name, _)| *name).collect(),
                })
            }
        }
    )*};
}

display_and_parse! {
    Mode, "mode";
    Gesture, "gesture";
    StandardView, "view";
    Command, "command";
}

/// An unknown name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no {what} `{name}`: use {}", known.join(", "))]
pub struct UnknownName {
    /// The kind of thing that was to be named.
    pub what: &'static str,
    /// The name.
    pub name: String,
    /// The known names.
    pub known: Vec<&'static str>,
}

impl Event {
    /// Whether its numbers are valid; invalid events have no effect.
    pub(crate) fn is_valid(&self) -> bool {
        match *self {
            Self::Grab { at, point, .. } => at.is_finite() && point.is_none_or(DVec3::is_finite),
            Self::Wheel { notches, at, point } => {
                notches.is_finite() && at.is_finite() && point.is_none_or(DVec3::is_finite)
            }
            Self::Drag { at } => at.is_finite(),
            Self::Tap { steps, .. } => steps.is_finite(),
            Self::Pivot(point) => point.is_finite(),
            Self::Fit(Some(bounds)) => bounds.min.is_finite() && bounds.max.is_finite(),
            Self::Go { view_from_world, pivot, scale } => {
                view_from_world.is_finite() && pivot.is_finite() && scale.is_finite() && scale > 0.0
            }
            Self::Place(view_from_world) => view_from_world.is_finite(),
            Self::Wait
            | Self::Mode(_)
            | Self::Release
            | Self::Press(_)
            | Self::Lift(_)
            | Self::View(_)
            | Self::Fit(None)
            | Self::Level => true,
        }
    }
}
